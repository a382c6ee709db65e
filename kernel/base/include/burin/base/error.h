#pragma once
/// The typed exceptions of the kernel. Each message is one line that says what is wrong and what to
/// do.

#include <cstdint>
#include <stdexcept>
#include <string>

namespace burin {

/// Base of every error that the kernel and the converters throw on purpose.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Broken, missing or unreadable input. `file` and `line` (0 = unknown) say where; a binary format
/// puts "at byte N" into `what()` instead of a line.
class InputError : public Error {
 public:
  explicit InputError(const std::string& what, std::string file = {}, std::int64_t line = 0)
      : Error(what), file_(std::move(file)), line_(line) {}
  const std::string& file() const { return file_; }
  std::int64_t line() const { return line_; }

 private:
  std::string file_;
  std::int64_t line_;
};

/// Wrong use of the program or of the library: an unknown style key, a number out of range.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// Geometry that no drawing can be made of, although the file was read.
class GeometryError : public Error {
 public:
  using Error::Error;
};

/// Output that cannot be written.
class OutputError : public Error {
 public:
  explicit OutputError(const std::string& what, std::string file = {})
      : Error(what), file_(std::move(file)) {}
  const std::string& file() const { return file_; }

 private:
  std::string file_;
};

/// Thrown by RunContext::check once the run was cancelled.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

}  // namespace burin
