#pragma once
/// Reading numbers and words out of text, free of the locale, with line numbers in errors.

#include <burin/base/ascii.h>

#include "source.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace burin {

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
inline bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// `token`, short and printable, in quotes: for messages.
std::string in_quotes(std::string_view token);
/// A name out of a file as UTF-8 that XML and JSON can hold: bytes that are no UTF-8 are taken as
/// Latin-1, control characters become blanks, and what is too long is cut.
std::string clean_name(std::string_view name);
/// Reads a whole token as a double: an optional sign, decimal digits, an exponent; inf and nan too.
/// What is too large is infinite, what is too small is 0.
bool parse_double(std::string_view token, double& value);
/// Reads the double that begins at `p`; returns the end of it, or nullptr where there is none.
const char* scan_double(const char* p, const char* end, double& value);

/// A text without the NULs and the Ctrl-Z that programs pad it with at its end.
std::string_view without_padding(std::string_view text);

/// A place in a text. Lines end with \n, \r\n or \r.
class TextCursor {
 public:
  explicit TextCursor(const Source& source, std::size_t offset = 0)
      : source_(source),
        p_(source.bytes().data() + offset),
        end_(p_ + without_padding(source.bytes().substr(offset)).size()) {}

  const char* where() const { return p_; }
  bool at_end() const { return p_ == end_; }
  bool at_line_end() const { return p_ == end_ || is_line_end(*p_); }
  char peek() const { return at_end() ? '\0' : *p_; }
  std::size_t left() const { return static_cast<std::size_t>(end_ - p_); }
  void skip(std::size_t n) { p_ += n; }

  void skip_blanks() {
    while (is_blank(*p_)) ++p_;
  }
  /// Skips blanks and line ends, and comments from `comment` (0: none) to the end of their line.
  void skip_space(char comment = 0);
  /// To the beginning of the next line.
  void next_line();
  /// The characters up to the next blank or line end.
  std::string_view token();
  /// The rest of the line without blanks at its ends; the cursor stays before the line end.
  std::string_view rest_of_line();

  /// The number here; blanks before it are skipped. `what` says in the error what was expected.
  double number(const char* what);
  std::int64_t integer(const char* what);
  /// A count of things at least `bytes_each` bytes long; refused where the rest of the file cannot
  /// hold them.
  std::size_t count(const char* what, std::size_t bytes_each);

  [[noreturn]] void fail(const std::string& what) const { source_.fail_at_line(p_, what); }

 private:
  [[noreturn]] void expected(const char* what);

  const Source& source_;
  const char* p_;
  const char* end_;
};

}  // namespace burin
