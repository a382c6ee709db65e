#pragma once
// The text of a program, read word by word; internal to the module.

#include <cstddef>
#include <string_view>

namespace burin::detail {

/// Whether a module of that name is OpenSCAD's own, or a word of its language.
bool is_own_module(std::string_view name);

/// Whether a program assigns a variable among its own statements, outside all brackets.
bool assigns_at_top(std::string_view program, std::string_view name);

/// A place in a text that moves forwards, over comments and texts in quotes; never beyond its end.
class ProgramText {
 public:
  explicit ProgramText(std::string_view text, std::size_t at = 0) : text_(text), p_(at) {}

  std::size_t at() const { return p_; }
  bool at_end() const { return p_ >= text_.size(); }
  /// The character here; 0 at the end.
  char here() const { return at_end() ? '\0' : text_[p_]; }
  bool here(std::string_view text) const { return text_.substr(p_).starts_with(text); }
  /// Whether a word stands here, and does not go on.
  bool here_word(std::string_view word) const;

  /// Over blanks and comments.
  void skip();
  /// Over `c` where it stands here.
  bool take(char c);
  /// Over a character, or a whole text in quotes.
  void next();
  /// A name or number, which may be empty.
  std::string_view word();
  /// Over modifiers; whether `*` is among them.
  bool modifiers();
  /// Whether `=` follows, and not `==`; stands before it.
  bool assigns();
  /// From an opening bracket to behind the one that closes it.
  void brackets();
  /// Over the arguments of a call, where there are some.
  void round();
  /// Behind the next semicolon outside brackets or, where `block`, behind the first {}.
  void to_end(bool block);
  /// Behind the next `c`.
  void behind(char c);

 private:
  std::string_view text_;
  std::size_t p_;
};

}  // namespace burin::detail
