#include "left_whole.h"

#include <burin/base/ascii.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace burin::detail {
namespace {

/// Words of which one in a name says what is not cut along: English, German, French; an s more is
/// their plural.
constexpr std::array kWords = {
    "bolt",   "screw", "nut",     "washer",   "rivet",    "pin",       "dowel",
    "key",    "shaft", "axle",    "ball",     "roller",   "rod",       "stud",
    "rib",    "spoke", "cotter",  "setscrew", "needle",   "spindle",   "vis",
    "boulon", "ecrou", "écrou",   "Écrou",    "rondelle", "goupille",  "clavette",
    "arbre",  "bille", "nervure", "tige",     "axe",      "niet",      "stift",
    "splint", "achse", "kugel",   "rippe",    "keil",     "grubscrew", "capscrew"};
/// How German names end, which say it last.
constexpr std::array kEndings = {
    "schraube",  "schrauben",  "mutter",          "muttern",      "federring", "bolzen",
    "welle",     "wellen",     "unterlegscheibe", "federscheibe", "stift",     "stifte",
    "passfeder", "passfedern", "niete",           "splinte",      "kugeln",    "rippen"};
/// After such a word these say that the thing is another: "shaft seal", "ball valve".
constexpr std::array kOthers = {
    "seal",    "housing", "plate",    "hole",   "valve",    "bearing", "holder", "support",
    "bracket", "block",   "cover",    "cap",    "carrier",  "guide",   "header", "way",
    "seat",    "joint",   "clamp",    "cage",   "driver",   "mount",   "sleeve", "bushing",
    "bush",    "collar",  "retainer", "circle", "pattern",  "gear",    "pulley", "wheel",
    "lock",    "box",     "case",     "flange", "coupling", "adapter", "knob",   "lever",
    "handle",  "spacer",  "bore",     "slot",   "end"};
/// Fasteners, keys, pins and balls by their standards.
constexpr std::array kIso = {
    1207,  1234,  1580,  2009,  2010,  2338,  2339,  2340,  2341,  2342, 4014, 4016,  4017,  4018,
    4026,  4027,  4028,  4029,  4032,  4033,  4034,  4035,  4036,  4161, 4762, 4766,  7040,  7042,
    7045,  7046,  7047,  7048,  7049,  7050,  7051,  7089,  7090,  7091, 7092, 7093,  7094,  7379,
    7380,  7434,  7435,  7436,  8673,  8674,  8675,  8676,  8734,  8735, 8738, 8739,  8740,  8741,
    8742,  8743,  8744,  8745,  8746,  8747,  8748,  8750,  8751,  8752, 8765, 10510, 10511, 10642,
    10669, 10673, 13337, 14579, 14580, 14581, 14582, 14583, 14584, 15071};
constexpr std::array kDin = {
    1,    6,    7,    84,   85,   94,   95,   96,   97,   125,  126,  127,  128,  137,  186,  188,
    261,  315,  316,  404,  427,  433,  434,  435,  436,  439,  440,  444,  464,  465,  478,  479,
    480,  551,  553,  555,  557,  558,  561,  562,  564,  571,  601,  603,  604,  605,  607,  608,
    609,  610,  653,  660,  661,  662,  674,  835,  906,  908,  910,  912,  913,  914,  915,  916,
    920,  921,  922,  923,  924,  925,  926,  927,  928,  929,  931,  933,  934,  935,  936,  937,
    938,  939,  940,  960,  961,  963,  964,  965,  966,  979,  980,  981,  982,  985,  986,  1433,
    1434, 1440, 1441, 1443, 1444, 1469, 1470, 1471, 1472, 1473, 1474, 1475, 1476, 1477, 1479, 1481,
    1587, 2093, 5401, 6325, 6330, 6331, 6334, 6340, 6796, 6797, 6798, 6799, 6880, 6881, 6883, 6884,
    6885, 6886, 6887, 6888, 6889, 6912, 6914, 6915, 6916, 6921, 6923, 7340, 7341, 7343, 7344, 7346,
    7349, 7500, 7504, 7513, 7516, 7603, 7604, 7965, 7967, 7968, 7971, 7972, 7973, 7976, 7977, 7978,
    7979, 7980, 7981, 7982, 7983, 7984, 7985, 7989, 7990, 7991, 7992, 7995, 7996, 7997, 9021};
/// What programs call bodies that nobody named.
constexpr std::array kNoNames = {"solid",   "body", "part",  "compound", "shape", "component",
                                 "product", "mesh", "shell", "feature",  "pad",   "unnamed"};

/// Letters without digits, small, and numbers, in turn: "HexBolt M6" is hex, bolt, m, 6.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  char before = ' ';
  for (const char c : name) {
    const auto is_word = [](char x) {
      return is_letter(x) || (static_cast<unsigned char>(x) & 0x80U) != 0;
    };
    const bool capital = c >= 'A' && c <= 'Z', small_before = before >= 'a' && before <= 'z';
    const bool goes_on =
        is_digit(c) ? is_digit(before) : is_word(before) && !(capital && small_before);
    if (is_digit(c) || is_word(c)) {
      if (!goes_on || words.empty()) words.emplace_back();
      words.back() += lowered(c);
    }
    before = c;
  }
  return words;
}

template <class List>
bool is_in(const List& list, std::string_view word) {
  return std::ranges::any_of(list, [&](std::string_view known) {
    return word == known ||
           (word.size() == known.size() + 1 && word.starts_with(known) && word.ends_with('s'));
  });
}

bool ends_as(std::string_view word) {
  return std::ranges::any_of(kEndings, [&](std::string_view end) { return word.ends_with(end); });
}

/// The number after ISO, or after DIN.
bool is_standard(const std::vector<std::string>& words, std::size_t i) {
  if (i == 0 || !is_digit(words[i].front()) || words[i].size() > 5) return false;
  const int number = std::stoi(words[i]);
  if (words[i - 1] == "iso") return std::ranges::find(kIso, number) != kIso.end();
  return words[i - 1] == "din" && std::ranges::find(kDin, number) != kDin.end();
}

}  // namespace

std::optional<std::string> left_whole_by_custom(const Part& part) {
  std::vector<std::string> words = words_of(part.name);
  const bool unnamed = std::ranges::all_of(words, [](const std::string& word) {
    return is_digit(word.front()) || is_in(kNoNames, word);
  });
  if (unnamed && !part.assembly.empty()) words = words_of(part.assembly.back());
  std::optional<std::string> found;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (is_in(kOthers, words[i])) found.reset();
    if (is_in(kWords, words[i]) || ends_as(words[i])) found = words[i];
    if (is_standard(words, i)) return words[i - 1] + " " + words[i];
  }
  return found;
}

}  // namespace burin::detail
