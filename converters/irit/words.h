#pragma once
/// Words and numbers of plain lists.

#include "lexer.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace burin::irit {

/// The words of a text in which # begins a comment to the end of the line; `commas` part words,
/// too.
class Words {
 public:
  explicit Words(std::string_view text, bool commas = false)
      : p_(text.data()), end_(p_ + text.size()), commas_(commas) {}

  /// Empty at the end.
  std::string_view next() {
    while (p_ < end_ && (parts(*p_) || *p_ == '#')) {
      p_ = *p_ == '#' ? std::find_if(p_, end_, is_line_end) : p_ + 1;
    }
    const char* begin = p_;
    while (p_ < end_ && !parts(*p_) && *p_ != '#') ++p_;
    return {begin, static_cast<std::size_t>(p_ - begin)};
  }
  /// Whether nothing but blanks stands before the end of the line.
  bool at_line_end() const {
    const char* p = std::find_if_not(p_, end_, is_blank);
    return p == end_ || is_line_end(*p) || *p == '#';
  }
  std::size_t left() const { return static_cast<std::size_t>(end_ - p_); }

 private:
  bool parts(char c) const { return is_blank(c) || is_line_end(c) || (commas_ && c == ','); }

  const char* p_;
  const char* end_;
  bool commas_;
};

inline std::optional<std::int64_t> whole(std::string_view word) {
  std::int64_t value = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (word.empty() || error != std::errc() || stop != end) return std::nullopt;
  return value;
}

[[noreturn]] inline void expected(const Source& source, std::string_view found,
                                  const std::string& what) {
  if (found.empty()) {
    fail_at(source, found.data(),
            fmt::format("the file ends where {} should be; it is truncated", what));
  }
  fail_at(source, found.data(), fmt::format("{} is not {}", in_quotes(found), what));
}

inline double number(const Source& source, Words& in, const char* what) {
  const std::string_view word = in.next();
  double value = 0;
  if (!parse_double(word, value) || !std::isfinite(value)) expected(source, word, what);
  return value;
}

}  // namespace burin::irit
