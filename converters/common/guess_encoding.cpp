#include <burin/base/ascii.h>

#include "alphabets.h"
#include "encoding.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace burin {
namespace {

// How common what bytes stand for is in names: letters that every text is made of, signs, letters
// of rare words, and what a name would hardly hold.
constexpr double kCommon = 1, kUsual = 0.9, kSign = 0.7, kHalf = 0.45, kRare = 0.2, kOdd = 0.05;
// Two encodings whose marks are nearer than this are told apart by uchardet, and by the user.
constexpr double kNearEncodings = 0.1;
// Below this the best one is a guess.
constexpr double kPoor = 0.5;
// uchardet looks at so many letters before it says anything: short names are given to it again.
constexpr int kTimes = 16;

bool within(int byte, int low, int high) { return byte >= low && byte <= high; }
bool is_plain_byte(int byte) { return byte < 0x80 && is_letter(static_cast<char>(byte)); }

/// The bytes of a text; blanks before and after it.
class NameBytes {
 public:
  explicit NameBytes(std::string_view text) : text_(text) {}
  int size() const { return static_cast<int>(text_.size()); }
  int operator[](int i) const {
    return within(i, 0, size() - 1) ? static_cast<std::uint8_t>(text_[static_cast<std::size_t>(i)])
                                    : ' ';
  }

 private:
  std::string_view text_;
};

/// What the letter that begins with a byte is worth, and how many bytes it takes; 0 bytes: there
/// is no such letter.
struct Letter {
  double worth = 0;
  int bytes = 0;
};

/// Letters of two bytes over 0xa0, as the national sets that EUC stands on have them: `common`
/// first bytes, then rare ones.
Letter rows(int lead, int trail, int common, int rare, int last) {
  const bool own = trail >= 0xa1;
  if (own && within(lead, common, rare - 1)) return {kCommon, 2};
  if (own && within(lead, rare, last)) return {kRare, 2};
  return {own && within(lead, 0xa1, 0xa3) ? kSign : kOdd, 2};
}

Letter gb18030(const NameBytes& b, int i) {
  const int lead = b[i], trail = b[i + 1];
  if (!within(lead, 0x81, 0xfe)) return {};
  if (within(trail, '0', '9')) return {kOdd, within(b[i + 2], 0x81, 0xfe) ? 4 : 0};
  if (trail < 0x40 || trail == 0x7f || trail == 0xff) return {};
  return rows(lead, trail, 0xb0, 0xd8, 0xf7);
}

Letter euc_kr(const NameBytes& b, int i) {
  const int lead = b[i], trail = b[i + 1];
  if (!within(lead, 0x81, 0xfd) || !(is_plain_byte(trail) || within(trail, 0x81, 0xfe))) return {};
  return rows(lead, trail, 0xb0, 0xc9, 0xc8);
}

Letter euc_jp(const NameBytes& b, int i) {
  const int lead = b[i], trail = b[i + 1];
  if (lead == 0x8e && trail >= 0xa1) return {kRare, 2};
  if (!within(lead, 0xa1, 0xfe) || !within(trail, 0xa1, 0xfe)) return {};
  if (within(lead, 0xa4, 0xa5)) return {kCommon, 2};
  Letter letter = rows(lead, trail, 0xb0, 0xd0, 0xfe);
  letter.worth = std::min(letter.worth, 0.85);  // without kana it is more often Chinese
  return letter;
}

/// Whether a second byte in ASCII looks like a letter of the word that goes on after it.
bool in_word(const NameBytes& b, int i) { return is_plain_byte(b[i]) && is_plain_byte(b[i + 1]); }

Letter shift_jis(const NameBytes& b, int i) {
  const int lead = b[i], trail = b[i + 1];
  if (within(lead, 0xa1, 0xdf)) return {kHalf, 1};
  if (!(within(lead, 0x81, 0x9f) || within(lead, 0xe0, 0xfc))) return {};
  if (trail < 0x40 || trail == 0x7f || trail > 0xfc) return {};
  if (in_word(b, i + 1)) return {kRare, 2};
  const bool kana = (lead == 0x82 && within(trail, 0x9f, 0xf1)) || (lead == 0x83 && trail <= 0x96);
  if (kana || within(lead, 0x88, 0x97)) return {kCommon, 2};
  return {within(lead, 0x81, 0x82) ? kSign : kRare, 2};
}

Letter big5(const NameBytes& b, int i) {
  const int lead = b[i], trail = b[i + 1];
  if (!within(lead, 0x81, 0xfe)) return {};
  if (!within(trail, 0x40, 0x7e) && !within(trail, 0xa1, 0xfe)) return {};
  if (in_word(b, i + 1)) return {kRare, 2};
  if (within(lead, 0xa4, 0xc6)) return {kUsual, 2};
  if (within(lead, 0xc9, 0xf9)) return {kRare, 2};
  return {within(lead, 0xa1, 0xa3) ? kSign : kOdd, 2};
}

struct Candidate {
  const char* name;  // as iconv has it, with what vendors added
  Letter (*letter)(const NameBytes&, int);
};

enum : std::size_t { Chinese, Japanese, Korean, UnixJapanese, Taiwanese };
constexpr std::array kCandidates{Candidate{"GB18030", gb18030}, Candidate{"CP932", shift_jis},
                                 Candidate{"CP949", euc_kr}, Candidate{"EUC-JP", euc_jp},
                                 Candidate{"BIG5", big5}};

/// The mean worth of the letters; nothing where some bytes are none.
double mark_of_encoding(const Candidate& candidate, const std::vector<std::string>& texts) {
  double sum = 0;
  int count = 0;
  for (const std::string& text : texts) {
    const NameBytes bytes(text);
    for (int i = 0; i < bytes.size();) {
      if (bytes[i] < 0x80) {
        ++i;
        continue;
      }
      const Letter letter = candidate.letter(bytes, i);
      if (letter.bytes == 0 || i + letter.bytes > bytes.size()) return 0;
      sum += letter.worth;
      ++count;
      i += letter.bytes;
    }
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

EncodingGuess guess_encoding(const std::vector<std::string>& texts) {
  std::array<double, kCandidates.size()> marks{};
  std::ranges::transform(kCandidates, marks.begin(),
                         [&](const Candidate& c) { return mark_of_encoding(c, texts); });
  const auto best = static_cast<std::size_t>(std::ranges::max_element(marks) - marks.begin());
  const AlphabetGuess alphabet = guess_alphabet(texts);
  const double most = std::max(marks[best], alphabet.mark);
  const auto near = [&](double mark, double by) { return mark > most - by; };
  if (alphabet.mark >= marks[best]) {
    return {alphabet.encoding,
            alphabet.sure && most >= kPoor && !near(marks[best], kNearEncodings)};
  }
  bool sure = most >= kPoor && !near(alphabet.mark, kNearEncodings);
  for (std::size_t k = 0; k < marks.size(); ++k) {
    if (k != best && near(marks[k], kNearEncodings)) sure = false;
  }
  std::string found = kCandidates[best].name;
  if (sure) return {found, true};
  const std::string other = detected_encoding(texts, kTimes);
  const auto may_be = [&](std::size_t k) { return near(marks[k], 2 * kNearEncodings); };
  if (other == "UHC" && may_be(Korean)) found = "CP949";
  if (other == "EUC-JP" && may_be(UnixJapanese) && marks[UnixJapanese] == kCommon) {
    found = "EUC-JP";
  }
  if (other == "BIG5" && may_be(Taiwanese) && marks[Chinese] < kCommon) found = "BIG5";
  return {found, false};
}

}  // namespace burin
