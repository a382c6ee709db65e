#include "text.h"

#include "encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace burin {

std::string in_quotes(std::string_view token) {
  constexpr int kLongest = 40;
  // Bytes of which some are no UTF-8 are no letters.
  const bool utf8 = is_utf8(token);
  std::string out = "'";
  for (int n = 0; n < kLongest && !token.empty(); ++n) {
    const std::size_t length = utf8 ? utf8_length(token) : 1;
    const char c = token.front();
    if (length > 1 || (c >= ' ' && c < 127)) {
      out += token.substr(0, length);
    } else {
      out += '?';
    }
    token.remove_prefix(length);
  }
  if (!token.empty()) out += "...";
  return out + "'";
}

std::string_view without_padding(std::string_view text) {
  using namespace std::string_view_literals;
  const std::size_t end = text.find_last_not_of("\0\x1a \t\r\n"sv) + 1;
  return text.substr(0, text.find_first_of("\0\x1a"sv, end));
}

const char* scan_double(const char* p, const char* end, double& value) {
  const char* digits = p;
  if (p < end && *p == '+' && p + 1 < end && p[1] != '-') ++digits;
  const auto [stop, error] = std::from_chars(digits, end, value);
  if (error == std::errc::invalid_argument) return nullptr;
  if (error == std::errc::result_out_of_range) {
    const std::string_view text(digits, static_cast<std::size_t>(stop - digits));
    const std::size_t e = text.find_first_of("eE");
    const bool tiny = e != std::string_view::npos
                          ? text.substr(e).find('-') != std::string_view::npos
                          : text.find_first_of("123456789") > text.find('.');
    value = tiny ? 0.0 : std::numeric_limits<double>::infinity();
    if (text.front() == '-') value = -value;
  }
  return stop;
}

bool parse_double(std::string_view token, double& value) {
  const char* end = token.data() + token.size();
  return scan_double(token.data(), end, value) == end && !token.empty();
}

void TextCursor::skip_space(char comment) {
  for (;;) {
    while (is_blank(*p_) || is_line_end(*p_)) ++p_;
    if (comment == 0 || *p_ != comment || at_end()) return;
    while (!at_line_end()) ++p_;
  }
}

void TextCursor::next_line() {
  while (!at_line_end()) ++p_;
  if (*p_ == '\r') ++p_;
  if (*p_ == '\n') ++p_;
}

std::string_view TextCursor::token() {
  const char* begin = p_;
  while (!at_line_end() && !is_blank(*p_)) ++p_;
  return {begin, static_cast<std::size_t>(p_ - begin)};
}

std::string_view TextCursor::rest_of_line() {
  skip_blanks();
  const char* begin = p_;
  while (!at_line_end()) ++p_;
  const char* stop = p_;
  while (stop > begin && is_blank(stop[-1])) --stop;
  return {begin, static_cast<std::size_t>(stop - begin)};
}

double TextCursor::number(const char* what) {
  skip_blanks();
  double value = 0;
  const char* stop = scan_double(p_, end_, value);
  if (stop == nullptr || !(stop == end_ || is_blank(*stop) || is_line_end(*stop))) expected(what);
  p_ = stop;
  return value;
}

std::int64_t TextCursor::integer(const char* what) {
  skip_blanks();
  std::int64_t value = 0;
  const char* digits = *p_ == '+' ? p_ + 1 : p_;
  const auto [stop, error] = std::from_chars(digits, end_, value);
  if (error != std::errc() || !(stop == end_ || is_blank(*stop) || is_line_end(*stop))) {
    expected(what);
  }
  p_ = stop;
  return value;
}

std::size_t TextCursor::count(const char* what, std::size_t bytes_each) {
  skip_blanks();
  const char* begin = p_;
  const std::int64_t n = integer(what);
  if (n < 0 || static_cast<std::uint64_t>(n) > left() / bytes_each) {
    source_.fail_at_line(begin,
                         fmt::format("{}, {}, cannot fit into the {} bytes that follow; the file "
                                     "is truncated or damaged, export it again",
                                     what, n, left()));
  }
  return static_cast<std::size_t>(n);
}

void TextCursor::expected(const char* what) {
  if (at_end())
    fail(fmt::format("the file ends where {} should be; it is truncated, export it again", what));
  if (at_line_end()) fail(fmt::format("the line ends where {} should be; export it again", what));
  const char* begin = p_;
  const std::string found = in_quotes(token());
  source_.fail_at_line(begin, fmt::format("{} is not {}; export it again", found, what));
}

}  // namespace burin
