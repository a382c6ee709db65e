#pragma once
/// Files that appear whole or not at all.

#include <burin/converters/write.h>

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace burin {

/// Functions of a program that are called about unfinished files, so that a signal that ends it
/// leaves none behind. `guard` is called before a file is made; the path stays valid until
/// `release`. Absent at first. To be set before anything is written.
struct OutputGuard {
  void (*guard)(const char* path) = nullptr;
  void (*release)(const char* path) = nullptr;
};
void set_output_guard(const OutputGuard& guard);

/// Whether two names are of one file, by links too, or would be where none is there yet.
bool same_file(const std::string& a, const std::string& b);

/// One output: "-" is standard output, devices and pipes are written as they are, anything else
/// aside and renamed.
class Output {
 public:
  Output(std::string name, const Format& format);
  ~Output();
  Output(Output&& other) noexcept;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  Output& operator=(Output&&) = delete;

  const std::string& name() const { return name_; }
  const Format& format() const { return *format_; }
  bool is_stdout() const { return name_ == "-"; }

  /// Throws OutputError where the file could not be written later, as far as can be known now.
  void probe() const;
  /// Writes all of it aside. Throws OutputError.
  void write(const std::function<void(std::ostream&)>& body);
  /// Gives the file its name. Throws OutputError.
  void commit();

 private:
  bool is_direct() const;
  int open_aside() const;
  void discard();

  std::string name_;
  const Format* format_;
  std::filesystem::path target_;
  std::string aside_;
  bool written_aside_ = false;
};

/// The outputs that were asked for. Throws UsageError where a name's format is unknown, where two
/// are one file, or where one is one of `sources` (files that the run reads).
std::vector<Output> plan_outputs(const std::vector<std::string>& names, const std::string& format,
                                 const std::vector<std::string>& sources);

}  // namespace burin
