#pragma once
/// What a user means by a word that is none of the known ones: in meaning first, then in letters.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A thing that a user may name.
struct KnownWord {
  /// As it is written: "--parts-list", "sheet.ink".
  std::string name;
  /// What it is called elsewhere: "bom", "balloons".
  std::vector<std::string> also = {};
  /// What to say of it; empty: "the nearest is 'NAME'".
  std::string say = {};
};

/// The thing that a word means: one whose name or other name it is, whatever its case, the signs
/// between its words and an s at its end; else one that differs by at most a third of its letters
/// (a fifth of those of an other name) or that it begins; else one whose name it begins or ends
/// with ("section-plane" means "section"). The first of several. Null where nothing is near. Time:
/// letters of the word times those of all names.
const KnownWord* meant(std::string_view word, std::span<const KnownWord> known);

/// "; the nearest is 'view'", or what the thing meant says of itself after "; "; empty where
/// nothing is near.
std::string hint(std::string_view word, std::span<const KnownWord> known);

/// Words that have no other names.
std::vector<KnownWord> known_words(std::span<const std::string> names);

}  // namespace burin
