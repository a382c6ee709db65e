#pragma once
/// Which files a run reads, for programs that run again when one of them changes.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace burin {

/// What tells that a file is another than it was, without reading it.
struct FileStamp {
  /// False: there is no such file; all else is 0.
  bool there = false;
  std::uint64_t device = 0, node = 0, size = 0;
  /// Nanoseconds of the last change of its bytes, and of its entry.
  std::int64_t changed = 0, renewed = 0;

  bool operator==(const FileStamp&) const = default;
};
FileStamp stamp_of(const std::filesystem::path& path);

/// As long as it lives it hears of each file that its thread opens to read, by the name that it is
/// opened by, also where that fails. One inside the life of another: both hear. To be ended in the
/// thread that made it, the last one first.
class InputFiles {
 public:
  /// By name; as they were just before they were first opened.
  using Stamps = std::map<std::string, FileStamp>;

  InputFiles();
  ~InputFiles();
  InputFiles(const InputFiles&) = delete;
  InputFiles& operator=(const InputFiles&) = delete;

  const Stamps& stamps() const { return stamps_; }

  /// To be called by readers just before they open a file. Costs nothing where nobody listens.
  static void opens(const std::filesystem::path& path);

 private:
  Stamps stamps_;
  InputFiles* outer_;
};

/// Whether any of the files is another now. Cost: about 1 us a file.
bool changed(const InputFiles::Stamps& stamps);

}  // namespace burin
