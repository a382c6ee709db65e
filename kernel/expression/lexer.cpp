#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/expression/lexer.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace burin::expression {
namespace {

bool begins_name(char c) { return is_letter(c) || c == '_'; }

// A character as a person would write it.
std::string shown(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code >= 0x20 && code < 0x7f ? fmt::format("'{}'", c) : fmt::format("byte {:#04x}", code);
}

}  // namespace

void Lexer::skip_blanks() {
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '#') {
      while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      if (at_ == text_.size()) return;
    } else if (c != ' ' && c != '\t' && c != '\r' && c != '\n') {
      return;
    }
    if (text_[at_] == '\n') {
      ++place_.line;
      place_.column = 1;
    } else {
      ++place_.column;
    }
  }
}

Token Lexer::number(Token token) {
  const char* begin = text_.data() + at_;
  const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), token.number);
  if (error != std::errc{} || !std::isfinite(token.number)) {
    fail_at(file_, token.place, "this number is out of range");
  }
  token.kind = TokenKind::Number;
  token.text = {begin, static_cast<std::size_t>(end - begin)};
  return token;
}

Token Lexer::next() {
  skip_blanks();
  Token token;
  token.place = place_;
  if (at_ == text_.size()) return token;
  const char c = text_[at_];
  const bool point = c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]);
  if (is_digit(c) || point) {
    token = number(token);
  } else if (begins_name(c)) {
    std::size_t end = at_;
    while (end < text_.size() && (begins_name(text_[end]) || is_digit(text_[end]))) ++end;
    token.kind = TokenKind::Name;
    token.text = text_.substr(at_, end - at_);
  } else if (std::string_view("+-*/^(),;=").find(c) != std::string_view::npos) {
    token.kind = TokenKind::Sign;
    token.text = text_.substr(at_, 1);
  } else {
    fail_at(file_, place_, fmt::format("{} has no meaning here", shown(c)));
  }
  at_ += token.text.size();
  place_.column += static_cast<std::int64_t>(token.text.size());
  return token;
}

}  // namespace burin::expression
