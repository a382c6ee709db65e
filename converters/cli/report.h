#pragma once
/// What went wrong, in one line, and the exit status that it means.

#include <string>

namespace burin::cli {

constexpr int kDone = 0, kFailed = 1, kUsage = 2, kBadInput = 3, kNoOutput = 4, kStopped = 5,
              kDifferent = 6;

/// Prints the line; to be called where an exception was caught. `input` is the file that errors
/// without one of their own are about. Returns the status.
int report(const std::string& input);

}  // namespace burin::cli
