#pragma once
/// Where the members of a JSON file stand, so that errors name the line.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace burin {

/// The line of every member and element of a JSON text, comments allowed; nothing where it is no
/// JSON.
class JsonLines {
 public:
  explicit JsonLines(std::string_view text);

  /// From 1, by a path such as "/parts/0/file": its own, else that of what holds it.
  std::int64_t line(std::string_view path) const;
  /// The line where reading ended: the last, or that of what could not be read.
  std::int64_t last() const { return last_; }

 private:
  std::int64_t last_ = 1;
  std::map<std::string, std::int64_t, std::less<>> lines_;
};

/// The line of a place in a text, from 1.
std::int64_t line_at(std::string_view text, std::size_t position);

}  // namespace burin
