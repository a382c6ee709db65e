#pragma once
/// Words, numbers and signs of a formula, with their places.

#include <burin/base/text_place.h>

#include <string>
#include <string_view>

namespace burin::expression {

enum class TokenKind { Number, Name, Sign, End };

struct Token {
  TokenKind kind = TokenKind::End;
  std::string_view text;
  double number = 0;
  TextPlace place;
};

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
  TextPlace place_{1, 1};
};

}  // namespace burin::expression
