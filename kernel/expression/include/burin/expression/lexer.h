#pragma once
/// Words, numbers and signs of a formula, with their places.

#include <cstdint>
#include <string>
#include <string_view>

namespace burin::expression {

struct Place {
  std::int64_t line = 1, column = 1;
};

enum class TokenKind { Number, Name, Sign, End };

struct Token {
  TokenKind kind = TokenKind::End;
  std::string_view text;
  double number = 0;
  Place place;
};

// Throws InputError at `place`: "column N: what".
[[noreturn]] void fail(const std::string& file, Place place, const std::string& what);

class Lexer {
 public:
  Lexer(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  Token next();

 private:
  void skip_blanks();
  Token number(Token token);

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  Place place_;
};

}  // namespace burin::expression
