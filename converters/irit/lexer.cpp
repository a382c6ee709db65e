#include "lexer.h"

#include "text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace burin::irit {
namespace {

bool is_space(char c) { return is_blank(c) || is_line_end(c); }
bool is_bracket(char c) { return c == '[' || c == ']'; }

std::int64_t lines_between(const char* from, const char* to) {
  std::int64_t lines = 0;
  for (const char* p = from; p < to; ++p) lines += *p == '\n' || (*p == '\r' && p[1] != '\n');
  return lines;
}

/// Counted from 1.
std::int64_t column_of(const Source& source, const char* where) {
  const char* line = where;
  while (line > source.bytes().data() && !is_line_end(line[-1])) --line;
  return where - line + 1;
}

}  // namespace

void fail_at(const Source& source, const char* where, const std::string& what) {
  fail_at(source.file(), TextPlace{source.line_of(where), column_of(source, where)}, what);
}

Lexer::Lexer(const Source& source)
    : source_(&source),
      p_(source.bytes().data()),
      end_(source.bytes().data() + source.bytes().size()),
      known_(p_) {}

void Lexer::skip_space() {
  while (p_ < end_ && is_space(*p_)) ++p_;
}

Token Lexer::next() {
  skip_space();
  const char* begin = p_;
  const auto token = [&](Token::Kind kind, const char* from, const char* to) {
    return Token{kind, {from, static_cast<std::size_t>(to - from)}, begin};
  };
  if (p_ == end_) return token(Token::Kind::End, p_, p_);
  if (is_bracket(*p_)) {
    ++p_;
    return token(*begin == '[' ? Token::Kind::Open : Token::Kind::Close, begin, p_);
  }
  if (*p_ == '"') {
    ++p_;
    while (p_ < end_ && *p_ != '"' && !is_line_end(*p_)) p_ += *p_ == '\\' && p_ + 1 < end_ ? 2 : 1;
    const char* stop = p_;
    if (p_ < end_ && *p_ == '"') ++p_;
    return token(Token::Kind::Quoted, begin + 1, stop);
  }
  while (p_ < end_ && !is_space(*p_) && !is_bracket(*p_)) ++p_;
  return token(Token::Kind::Word, begin, p_);
}

Token Lexer::peek() const {
  Lexer ahead = *this;
  return ahead.next();
}

Token Lexer::next_bracket() {
  for (;;) {
    skip_space();
    if (p_ == end_ || is_bracket(*p_)) return next();
    if (*p_ == '#') {
      while (p_ < end_ && !is_line_end(*p_)) ++p_;
      continue;
    }
    const char* begin = p_;
    while (p_ < end_ && !is_space(*p_)) ++p_;
    // A bracket within a word of a comment opens nothing, but one at the end of a word closes.
    const std::string_view word(begin, static_cast<std::size_t>(p_ - begin));
    if (word.find('[') == std::string_view::npos) {
      while (p_[-1] == ']') --p_;
    }
  }
}

void Lexer::skip_block() {
  const char* begin = p_;
  for (std::size_t depth = 1; depth > 0;) {
    const Token token = next();
    if (token.kind == Token::Kind::Open) ++depth;
    if (token.kind == Token::Kind::Close) --depth;
    if (token.kind == Token::Kind::End) {
      fail_at(*source_, begin, "the block that is open here never closes; the file is truncated");
    }
    source_->context().check();
  }
}

void Lexer::open(const char* what) {
  const Token token = next();
  if (token.kind != Token::Kind::Open) expected(token, what);
}

void Lexer::close(const char* what) {
  const Token token = next();
  if (token.kind != Token::Kind::Close) expected(token, what);
}

double Lexer::number(const char* what) {
  const Token token = next();
  double value = 0;
  if (token.kind != Token::Kind::Word || !parse_double(token.text, value)) expected(token, what);
  if (!std::isfinite(value)) {
    fail(token, fmt::format("{} is no finite number; export it again", in_quotes(token.text)));
  }
  return value;
}

std::int64_t Lexer::count(const char* what) {
  const Token token = next();
  std::int64_t value = 0;
  const char* end = token.text.data() + token.text.size();
  if (token.kind != Token::Kind::Word ||
      std::from_chars(token.text.data(), end, value).ptr != end || value < 1) {
    expected(token, what);
  }
  return value;
}

TextPlace Lexer::place_of(const char* where) {
  return {line_of(where), column_of(*source_, where)};
}

std::int64_t Lexer::line_of(const char* where) {
  if (where < known_) return source_->line_of(where);
  known_line_ += lines_between(known_, where);
  known_ = where;
  return known_line_;
}

void Lexer::fail(const Token& at, const std::string& what) const {
  fail_at(*source_, at.where, what);
}

void Lexer::expected(const Token& found, const char* what) const {
  if (found.kind == Token::Kind::End) {
    fail(found, fmt::format("the file ends where {} should be; it is truncated", what));
  }
  fail(found, fmt::format("{} is not {}; export it again", in_quotes(found.text), what));
}

std::string plain(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size()) ++i;
    out += text[i];
  }
  return clean_name(out);
}

std::string raised(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return out;
}

}  // namespace burin::irit
