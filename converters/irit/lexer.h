#pragma once
/// Brackets, words and quoted strings of IRIT data.

#include <burin/base/text_place.h>

#include "source.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace burin::irit {

/// As for meshes: squares of squares of coordinates stay finite.
inline constexpr double kLargestCoordinate = 1e60;

/// Throws InputError with the line and the column of `where`.
[[noreturn]] void fail_at(const Source& source, const char* where, const std::string& what);

struct Token {
  enum class Kind : std::uint8_t { Open, Close, Word, Quoted, End };
  Kind kind = Kind::End;
  /// Without quotes; what stands before a quoted character is still in it.
  std::string_view text;
  const char* where = nullptr;
};

class Lexer {
 public:
  explicit Lexer(const Source& source);

  Token next();
  Token peek() const;
  /// The next bracket or end: between objects all words are comments, and # begins one to the end
  /// of its line.
  Token next_bracket();
  /// Goes past the closing bracket of a block that is open.
  void skip_block();

  void open(const char* what);
  void close(const char* what);
  double number(const char* what);
  /// A whole number from 1 on.
  std::int64_t count(const char* what);

  std::size_t left() const { return static_cast<std::size_t>(end_ - p_); }
  const char* where() const { return p_; }
  /// The number of the line that `where` lies in; cheap where calls go forward.
  std::int64_t line_of(const char* where);
  /// Its line and column.
  TextPlace place_of(const char* where);
  const Source& source() const { return *source_; }
  [[noreturn]] void fail(const Token& at, const std::string& what) const;
  /// What was found instead of `what`.
  [[noreturn]] void expected(const Token& found, const char* what) const;

 private:
  void skip_space();

  const Source* source_;
  const char* p_;
  const char* end_;
  const char* known_;
  std::int64_t known_line_ = 1;
};

/// A quoted or bare word with its escapes undone, fit for names.
std::string plain(std::string_view text);
/// ASCII letters raised.
std::string raised(std::string_view text);

}  // namespace burin::irit
