#pragma once
/// What models are called, whatever they are packed in or come from.

#include <filesystem>
#include <string>

namespace burin {

/// "-", and what systems call the same: the bytes that are piped into the program.
bool is_standard_input(const std::filesystem::path& path);

/// The suffix in lower case of what is in a file: ".step" of "a.STEP", "a.step.gz" and ".stp" of
/// "a.stpz"; of a file whose format the user named (GivenFormat), that.
std::string model_suffix(const std::filesystem::path& path);
/// The name without folders and suffixes: "a" of these; "stdin" of standard input.
std::string model_stem(const std::filesystem::path& path);

/// As long as it lives a file is of the format that the user named, for readers in this thread.
class GivenFormat {
 public:
  /// `suffix` as ".stl"; empty: none was named.
  GivenFormat(std::filesystem::path path, std::string suffix);
  ~GivenFormat();
  GivenFormat(const GivenFormat&) = delete;
  GivenFormat& operator=(const GivenFormat&) = delete;

 private:
  friend std::string model_suffix(const std::filesystem::path& path);
  std::filesystem::path path_;
  std::string suffix_;
  GivenFormat* outer_;
};

}  // namespace burin
