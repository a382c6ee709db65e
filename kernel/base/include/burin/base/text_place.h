#pragma once
/// Where in a text something stands, for messages.

#include <cstdint>
#include <string>

namespace burin {

/// Counted from 1; 0: not known.
struct TextPlace {
  std::int64_t line = 0, column = 0;
};

/// Throws InputError with the line: "column N: what".
[[noreturn]] void fail_at(const std::string& file, TextPlace place, const std::string& what);

}  // namespace burin
