#include "alphabets.h"

#include <burin/base/ascii.h>

#include <iconv.h>
#include <uchardet/uchardet.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

namespace burin {
namespace {

constexpr double kCommonLetter = 1, kUsualLetter = 0.9, kBesideCapital = 0.7, kForeign = 0.75,
                 kOddLetter = 0.3, kHardly = 0.05;
// Between two alphabets whose marks are nearer than this uchardet decides.
constexpr double kNearAlphabets = 0.1;
// No word of Latin letters has so many accents in a row; what has is of other letters.
constexpr int kLongRun = 4;
constexpr double kSlack = 1e-9;  // of sums
// So many letters with their capitals in the right places are no chance: pairs of bytes of other
// encodings would be so once in six hundred texts.
constexpr int kManyLetters = 8;
constexpr double kNoChance = 1.15;

struct Alphabet {
  const char* encoding;
  /// In UTF-8: letters that names in its languages are made of.
  const char *small, *capital;
  /// Letters of small languages, which others mean something else by.
  const char* foreign;
  /// Whole words are of these letters; else they stand among those of ASCII.
  bool own;
};

enum : std::size_t { Western, Central, Turkish, Cyrillic, Greek, Count };
constexpr std::array<Alphabet, Count> kAlphabets{
    {{"WINDOWS-1252", "äöüßéèêëàâîïôùûçœñáíóúìòãõåæøšž", "ÄÖÜÉÈÊËÀÂÎÏÔÙÛÇŒÑÁÍÓÚÌÒÃÕÅÆØŠŽ", "ðþýÐÞÝ",
      false},
     {"WINDOWS-1250", "ąćęłńóśźżáčďéěíňřšťúůýžľĺŕôőűăâîşţäöüßç",
      "ĄĆĘŁŃÓŚŹŻÁČĎÉĚÍŇŘŠŤÚŮÝŽĽĹŔÔŐŰĂÂÎŞŢÄÖÜÇ", "đĐ", false},
     {"WINDOWS-1254", "çğıöşüâîû", "ÇĞİÖŞÜ", "", false},
     {"WINDOWS-1251", "абвгдежзийклмнопрстуфхцчшщъыьэюяіїє", "АБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯІЇЄ",
      "ёЁ", true},
     {"WINDOWS-1253", "αβγδεζηθικλμνξοπρσςτυφχψωάέήίόύώ", "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩΆΈΉΊΌΎΏ", "ϊϋΐΰ",
      true}}};

enum class Case : std::uint8_t { None, Small, Capital };

/// What the bytes from 0x80 on are.
struct Letters {
  std::array<Case, 256> cases{};
  std::array<bool, 256> foreign{};
};

std::string in_bytes(const char* encoding, std::string_view text) {
  std::string bytes(text.size(), '\0');
  const iconv_t handle = iconv_open(encoding, "UTF-8");
  char *in = const_cast<char*>(text.data()), *out = bytes.data();  // `in` is never written to
  std::size_t left = text.size(), room = bytes.size();
  iconv(handle, &in, &left, &out, &room);
  iconv_close(handle);
  bytes.resize(bytes.size() - room);
  return bytes;
}

Letters letters_of(const Alphabet& alphabet) {
  Letters letters;
  const auto take = [&](std::string_view text, Case of, bool foreign) {
    for (const char c : in_bytes(alphabet.encoding, text)) {
      letters.cases[static_cast<std::uint8_t>(c)] = of;
      letters.foreign[static_cast<std::uint8_t>(c)] = foreign;
    }
  };
  take(alphabet.small, Case::Small, false);
  take(alphabet.capital, Case::Capital, false);
  take(alphabet.foreign, Case::Small, true);
  for (int c = 'a'; c <= 'z'; ++c) letters.cases[static_cast<std::size_t>(c)] = Case::Small;
  for (int c = 'A'; c <= 'Z'; ++c) letters.cases[static_cast<std::size_t>(c)] = Case::Capital;
  return letters;
}

/// A byte of a text and those about it.
struct Place {
  std::uint8_t before = ' ', at = 0, after = ' ';
  /// How many bytes from 0x80 on stand in a row here.
  int run = 0;
};

bool is_plain_letter(std::uint8_t c) { return c < 0x80 && is_letter(static_cast<char>(c)); }

/// Degree, micro, diameter, powers and the like, where they stand as signs.
bool is_sign(const Place& p) {
  constexpr std::string_view kSigns = "\xb0\xb5\xb1\xd8\xd7\xb2\xb3\xf8";
  if (kSigns.find(static_cast<char>(p.at)) == std::string_view::npos) return false;
  const bool power = p.at == 0xb2 || p.at == 0xb3;
  return p.before < 0x80 && p.after < 0x80 && !(power && is_plain_letter(p.after));
}

/// Of letters that stand among those of ASCII.
double latin(const Letters& letters, const Place& p) {
  if (p.run >= kLongRun) return kHardly;
  if (is_sign(p)) return kCommonLetter;
  const Case before = letters.cases[p.before], at = letters.cases[p.at],
             after = letters.cases[p.after];
  if (at == Case::None) return kOddLetter;
  if (letters.foreign[p.at]) return kForeign;
  if (at == Case::Small)
    return p.after >= 0x80 && after != Case::Small ? kOddLetter : kCommonLetter;
  if (before == Case::Small || (after == Case::None && before == Case::None)) return kOddLetter;
  if (p.after < 0x80) return kCommonLetter;
  return after == Case::Small && p.run == 2 ? kBesideCapital : kOddLetter;
}

/// Of alphabets of their own: capitals begin words, or are among themselves.
double own(const Letters& letters, const Place& p) {
  const Case before = letters.cases[p.before], at = letters.cases[p.at];
  if (at == Case::None) return kHardly;
  if (is_plain_letter(p.before) || is_plain_letter(p.after)) return kOddLetter;
  if (letters.foreign[p.at]) return kOddLetter;
  return at == Case::Capital && before == Case::Small ? kHardly : kUsualLetter;
}

/// Calls `one(place)` for each byte from 0x80 on.
template <class F>
void for_high_bytes(const std::vector<std::string>& texts, const F& one) {
  for (const std::string& text : texts) {
    const auto byte = [&](std::size_t i) {
      return i < text.size() ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{' '};
    };
    for (std::size_t begin = 0; begin < text.size(); ++begin) {
      std::size_t end = begin;
      while (byte(end) >= 0x80) ++end;
      const auto run = static_cast<int>(end - begin);
      for (; begin < end; ++begin) one({byte(begin - 1), byte(begin), byte(begin + 1), run});
    }
  }
}

double mark_of_alphabet(std::size_t which, const std::vector<std::string>& texts) {
  static const auto all = [] {
    std::array<Letters, Count> made;
    std::ranges::transform(kAlphabets, made.begin(), letters_of);
    return made;
  }();
  const bool is_own = kAlphabets[which].own;
  double sum = 0;
  int count = 0;
  for_high_bytes(texts, [&](const Place& p) {
    sum += is_own ? own(all[which], p) : latin(all[which], p);
    ++count;
  });
  const double mean = count > 0 ? sum / count : 0;
  return is_own && count >= kManyLetters && mean > kUsualLetter - kNearAlphabets
             ? mean * kNoChance / kUsualLetter
             : mean;
}

/// Of alphabets that are not in the table, and Central Europe where the letters are as usual in
/// Western Europe: those of other countries stand in runs of many bytes.
std::string guess_by_uchardet(const std::vector<std::string>& texts, const std::string& found) {
  int letters = 0, runs = 0;
  bool windows = false;
  for_high_bytes(texts, [&](const Place& p) {
    ++letters;
    windows = windows || p.at < 0xa0;
    runs += p.before < 0x80;
  });
  if (found == "WINDOWS-1250") return found;
  // ISO has no letters from 0x80 to 0x9f.
  if (found == "ISO-8859-2") return windows ? "WINDOWS-1250" : found;
  for (const char* name : {"WINDOWS-1251", "KOI8-R", "ISO-8859-5", "IBM866", "WINDOWS-1253",
                           "ISO-8859-7", "WINDOWS-1255", "ISO-8859-8"}) {
    if (found == name && letters >= 3 * runs) return found;
  }
  return kAlphabets[Western].encoding;
}

}  // namespace

std::string detected_encoding(const std::vector<std::string>& texts, int times) {
  const std::unique_ptr<uchardet, void (*)(uchardet_t)> detector(uchardet_new(), uchardet_delete);
  for (int k = 0; k < times; ++k) {
    for (const std::string& text : texts) {
      uchardet_handle_data(detector.get(), text.data(), text.size());
      uchardet_handle_data(detector.get(), "\n", 1);
    }
  }
  uchardet_data_end(detector.get());
  const char* name = uchardet_get_charset(detector.get());
  return name == nullptr ? std::string() : std::string(name);
}

AlphabetGuess guess_alphabet(const std::vector<std::string>& texts) {
  std::array<double, Count> marks{};
  for (std::size_t k = 0; k < Count; ++k) marks[k] = mark_of_alphabet(k, texts);
  const auto best = static_cast<std::size_t>(std::ranges::max_element(marks) - marks.begin());
  const auto near = [&](std::size_t k) { return marks[k] > marks[best] - kNearAlphabets; };
  const std::string found = detected_encoding(texts, 1);
  if (near(Western)) return {guess_by_uchardet(texts, found), marks[best], true};
  const auto is = [&](std::size_t k) {
    return AlphabetGuess{kAlphabets[k].encoding, marks[best], true};
  };
  if (near(Turkish) && near(Central)) {
    AlphabetGuess guess = is(found == "ISO-8859-9" ? Turkish : Central);
    guess.sure = false;
    return guess;
  }
  if (near(Cyrillic) && near(Greek)) {
    AlphabetGuess guess = is(found == "WINDOWS-1253" || found == "ISO-8859-7" ? Greek : Cyrillic);
    guess.sure = found.starts_with("WINDOWS-125");
    return guess;
  }
  // The Cyrillic letters of Unix, whose capitals Windows has for small letters.
  if (best == Cyrillic && found == "KOI8-R" && marks[best] < kNoChance - kSlack)
    return {found, marks[best], false};
  // What Poland and its neighbours wrote before Windows, which has other letters in two places.
  const bool iso = best == Central && found == "ISO-8859-2";
  return iso ? AlphabetGuess{guess_by_uchardet(texts, found), marks[best], true} : is(best);
}

}  // namespace burin
