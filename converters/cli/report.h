#pragma once
/// What went wrong, in one line, and the exit status that it means.

#include <string>

namespace burin::cli {

constexpr int kDone = 0, kFailed = 1, kUsage = 2, kBadInput = 3, kNoOutput = 4, kStopped = 5,
              kDifferent = 6;

/// What was thrown, as it is reported to programs and users.
struct Failure {
  int status = kFailed;
  /// "cancelled", "usage", "missing", "input", "geometry", "output", "memory" or "error".
  const char* kind = "error";
  /// One line: FILE[:LINE]: what and what to do.
  std::string message;
};
/// Of the exception that is handled now. `input`: as in `report`.
Failure failure_of(const std::string& input);

/// Prints the line; to be called where an exception was caught. `input` is the file that errors
/// without one of their own are about. Returns the status.
int report(const std::string& input);

}  // namespace burin::cli
