#pragma once
/// Encodings of one byte a letter.

#include <string>
#include <vector>

namespace burin {

struct AlphabetGuess {
  std::string encoding;
  /// How common what the bytes stand for is in names, as `guess_encoding` marks encodings of
  /// several bytes; over 1 where many letters are written as only this alphabet has them.
  double mark = 0;
  bool sure = true;
};

/// The alphabet that makes the commonest letters of all texts together: that of Western Europe,
/// Central Europe, Turkey, Cyrillic or Greek; others where uchardet knows them.
AlphabetGuess guess_alphabet(const std::vector<std::string>& texts);

/// What uchardet takes the texts for, each given `times`, in its own names.
std::string detected_encoding(const std::vector<std::string>& texts, int times);

}  // namespace burin
