#include <burin/base/ascii.h>
#include <burin/base/nearest.h>
#include <burin/options/meant.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace burin {
namespace {

// Words of so few letters are near only what is longer.
constexpr std::size_t kShort = 3;
// Of so many letters one may be wrong in the thing's own name, and in what it is called elsewhere:
// these are many, and short ones are near to anything.
constexpr std::size_t kLettersOwn = 3;
constexpr std::size_t kLettersOther = 5;

using Tokens = std::vector<std::string>;

bool is_letter_or_digit(char c) {
  return is_letter(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80;
}

// "--Hidden_Lines" as hidden and lines.
Tokens tokens_of(std::string_view word) {
  Tokens tokens(1);
  for (const char c : lowered(std::string(word))) {
    if (is_letter_or_digit(c)) {
      tokens.back() += c;
    } else if (!tokens.back().empty()) {
      tokens.emplace_back();
    }
  }
  if (tokens.back().empty()) tokens.pop_back();
  return tokens;
}

std::string joined(const Tokens& tokens) {
  std::string all;
  for (const std::string& token : tokens) all += token;
  return all;
}

std::string singular(std::string word) {
  if (word.size() > kShort && word.ends_with('s')) word.pop_back();
  return word;
}

// What the user typed, and one of the names that it is compared with.
struct Compared {
  const Tokens& word;
  const Tokens& name;
  const std::string& word_letters;
  const std::string& name_letters;
  bool own;
};

// How far apart they are; past `kFar`: nothing to do with each other.
constexpr std::size_t kFar = std::numeric_limits<std::size_t>::max();

std::size_t same(const Compared& c) {
  return singular(c.word_letters) == singular(c.name_letters) ? 0 : kFar;
}

std::size_t by_letters(const Compared& c) {
  const std::size_t least = std::min(c.word_letters.size(), c.name_letters.size());
  if (least < kShort || c.word_letters.size() + c.name_letters.size() == 2 * kShort) return kFar;
  const std::size_t edits = edit_distance(c.word_letters, c.name_letters);
  return edits <= least / (c.own ? kLettersOwn : kLettersOther) ? edits : kFar;
}

std::size_t by_beginning(const Compared& c) {
  const bool begins = c.word_letters.size() >= kShort && c.name_letters.starts_with(c.word_letters);
  return begins ? c.name_letters.size() - c.word_letters.size() : kFar;
}

// The name is made of the first, or of the last words.
std::size_t by_words(const Compared& c, bool first) {
  if (c.name.empty() || c.name.size() >= c.word.size() || c.name_letters.size() <= kShort) {
    return kFar;
  }
  const bool holds = first ? std::equal(c.name.begin(), c.name.end(), c.word.begin())
                           : std::equal(c.name.rbegin(), c.name.rend(), c.word.rbegin());
  return holds ? c.word.size() - c.name.size() : kFar;
}

struct Name {
  const KnownWord* of = nullptr;
  Tokens tokens;
  std::string letters;
  bool own = true;
};

}  // namespace

const KnownWord* meant(std::string_view word, std::span<const KnownWord> known) {
  std::vector<Name> names;
  for (const KnownWord& one : known) {
    const auto add = [&](std::string_view name, bool own) {
      Tokens tokens = tokens_of(name);
      std::string letters = joined(tokens);
      names.push_back({&one, std::move(tokens), std::move(letters), own});
    };
    add(one.name, true);
    for (const std::string& other : one.also) add(other, false);
  }
  const Tokens tokens = tokens_of(word);
  const std::string letters = joined(tokens);
  if (letters.empty()) return nullptr;
  using Measure = std::function<std::size_t(const Compared&)>;
  const Measure measures[] = {same, by_letters, by_beginning,
                              [](const Compared& c) { return by_words(c, true); },
                              [](const Compared& c) { return by_words(c, false); }};
  for (const Measure& measure : measures) {
    const KnownWord* best = nullptr;
    std::size_t least = kFar;
    for (const Name& name : names) {
      const std::size_t apart = measure({tokens, name.tokens, letters, name.letters, name.own});
      if (apart < least) least = apart, best = name.of;
    }
    if (best) return best;
  }
  return nullptr;
}

std::string hint(std::string_view word, std::span<const KnownWord> known) {
  const KnownWord* found = meant(word, known);
  if (!found) return {};
  return "; " + (found->say.empty() ? "the nearest is '" + found->name + "'" : found->say);
}

std::vector<KnownWord> known_words(std::span<const std::string> names) {
  std::vector<KnownWord> words;
  for (const std::string& name : names) words.push_back({name});
  return words;
}

}  // namespace burin
