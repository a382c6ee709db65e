#pragma once
/// Names in files that do not say which encoding they are in.

#include <burin/base/diagnostics.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

bool is_utf8(std::string_view text);
/// The bytes of the UTF-8 character at the beginning of `text`, or 0 where there is none.
std::size_t utf8_length(std::string_view text);

/// Throws UsageError, which names the option, where this system has no encoding of that name.
void check_encoding(const std::string& option, const std::string& encoding);

/// Turns texts into UTF-8. Which encoding they are in is what the user says, else UTF-8 where all
/// texts are that, else the one that makes the commonest letters of all texts together:
/// Windows-1252, 1250, 1251, 1253, 1254 or their like, GB18030, Shift-JIS, EUC-KR, EUC-JP, Big5
/// (uchardet is asked where two are as good).
class TextDecoder {
 public:
  /// `encoding`: a name that iconv knows; empty: it is found out from what is learned.
  explicit TextDecoder(std::string encoding) : encoding_(std::move(encoding)) {}

  /// Looks at one of the texts; to be called for all of them before `utf8`. ASCII is no news.
  void learn(std::string_view text);
  /// A text as UTF-8; what is no letter of the encoding becomes U+FFFD.
  std::string utf8(std::string_view text);
  /// Says once, with code "names.encoding", where what was found out is not sure, or where `utf8`
  /// met what is no letter of the encoding.
  void report(Diagnostics& diagnostics);

 private:
  void decide();

  std::string encoding_;
  std::vector<std::string> texts_;
  bool decided_ = false, sure_ = true;
  /// Bytes that became U+FFFD.
  std::int64_t wrong_ = 0;
};

/// A whole text file as UTF-8; empty where it is that already. As `TextDecoder` does with its
/// lines, and what stands in quotes in them.
std::string utf8_text(std::string_view text, const std::string& encoding, Diagnostics& diagnostics);

/// The first, and whether it is clear: internal to `TextDecoder`, here for its tests.
struct EncodingGuess {
  std::string encoding;
  bool sure = true;
};
/// Of texts that are not all UTF-8. Cost: 20 ns a byte.
EncodingGuess guess_encoding(const std::vector<std::string>& texts);

}  // namespace burin
