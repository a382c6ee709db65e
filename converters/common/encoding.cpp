#include "encoding.h"

#include <burin/base/ascii.h>
#include <burin/base/error.h>

#include "text.h"

#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace burin {
namespace {

// More texts than that say nothing new.
constexpr std::size_t kMostTexts = 4096;
constexpr const char* kReplacement = "\xef\xbf\xbd";

bool is_ascii(std::string_view text) {
  return std::ranges::none_of(text, [](char c) { return static_cast<signed char>(c) < 0; });
}

/// Names that people and files use for what programs wrote with additions of their vendors.
std::string widest(const std::string& encoding) {
  constexpr std::array<std::pair<const char*, const char*>, 9> kWider{
      {{"shift_jis", "CP932"},
       {"shift-jis", "CP932"},
       {"sjis", "CP932"},
       {"euc-kr", "CP949"},
       {"euckr", "CP949"},
       {"gb2312", "GB18030"},
       {"gbk", "GB18030"},
       {"latin1", "WINDOWS-1252"},
       {"iso-8859-1", "WINDOWS-1252"}}};
  const std::string plain = lowered(encoding);
  for (const auto& [name, wider] : kWider) {
    if (plain == name) return wider;
  }
  return encoding;
}

/// As people call it.
std::string plain_name(const std::string& encoding) {
  if (encoding == "CP932") return "Shift_JIS";
  return encoding == "CP949" ? "EUC-KR" : encoding;
}

class Converter {
 public:
  explicit Converter(const std::string& encoding)
      : handle_(iconv_open("UTF-8", widest(encoding).c_str())) {}
  ~Converter() {
    if (known()) iconv_close(handle_);
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;
  bool known() const { return handle_ != reinterpret_cast<iconv_t>(-1); }
  /// Bytes that were no letters.
  std::int64_t wrong() const { return wrong_; }

  std::string convert(std::string_view text) {
    std::string out;
    std::array<char, 4096> piece{};
    char* in = const_cast<char*>(text.data());  // never written to
    std::size_t left = text.size();
    while (left > 0) {
      char* to = piece.data();
      std::size_t room = piece.size();
      const std::size_t done = iconv(handle_, &in, &left, &to, &room);
      out.append(piece.data(), to);
      if (done != static_cast<std::size_t>(-1) || errno == E2BIG) continue;
      out += kReplacement;
      ++in, --left;
      ++wrong_;
    }
    iconv(handle_, nullptr, nullptr, nullptr, nullptr);
    return out;
  }

 private:
  iconv_t handle_;
  std::int64_t wrong_ = 0;
};

}  // namespace

void check_encoding(const std::string& option, const std::string& encoding) {
  if (!encoding.empty() && Converter(encoding).known()) return;
  throw UsageError(fmt::format(
      "{} takes the name of an encoding, such as UTF-8, WINDOWS-1252, GB18030, SHIFT_JIS, EUC-KR "
      "or BIG5, not '{}'",
      option, encoding));
}

void TextDecoder::learn(std::string_view text) {
  if (is_ascii(text) || texts_.size() >= kMostTexts) return;
  texts_.emplace_back(text);
}

void TextDecoder::decide() {
  if (std::exchange(decided_, true) || !encoding_.empty()) return;
  if (std::ranges::all_of(texts_, is_utf8)) {
    encoding_ = "UTF-8";
    return;
  }
  // A name that parts have in common is no more evidence than one.
  std::ranges::sort(texts_);
  texts_.erase(std::unique(texts_.begin(), texts_.end()), texts_.end());
  EncodingGuess guess = guess_encoding(texts_);
  encoding_ = std::move(guess.encoding);
  sure_ = guess.sure;
}

std::string TextDecoder::utf8(std::string_view text) {
  decide();
  if (is_ascii(text) || (lowered(encoding_) == "utf-8" && is_utf8(text))) return std::string(text);
  Converter converter(encoding_);
  std::string out = converter.convert(text);
  wrong_ += converter.wrong();
  return out;
}

void TextDecoder::report(Diagnostics& diagnostics) {
  decide();
  if (wrong_ > 0) {
    diagnostics.add(Severity::Warning, "names.encoding", wrong_,
                    fmt::format("{} bytes of the names are not valid in {}; give the right "
                                "encoding with `encoding`",
                                wrong_, plain_name(encoding_)));
    return;
  }
  if (sure_ || texts_.empty()) return;
  diagnostics.add(Severity::Warning, "names.encoding", std::ssize(texts_),
                  fmt::format("the file does not state the encoding of its names; {} is assumed "
                              "('{}'); `encoding` sets another",
                              plain_name(encoding_), clean_name(utf8(texts_.front()))));
}

std::string utf8_text(std::string_view text, const std::string& encoding,
                      Diagnostics& diagnostics) {
  TextDecoder decoder(encoding);
  if (is_ascii(text) || (encoding.empty() && is_utf8(text))) return {};
  // Texts in quotes by themselves; none of the encodings has a quote within a letter.
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find_first_of("\r\n'\"", from), text.size());
    decoder.learn(text.substr(from, to - from));
    from = to + 1;
  }
  std::string out = decoder.utf8(text);
  decoder.report(diagnostics);
  return out;
}

}  // namespace burin
