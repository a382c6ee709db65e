#pragma once
/// "Did you mean ...": the known word nearest to what was typed.

#include <span>
#include <string>
#include <string_view>

namespace burin {

/// The known word with the fewest edits (letters put in, left out, changed or swapped with the
/// next) to `word`, the first of several; empty where `known` is. @cite Damerau1964
std::string nearest(std::string_view word, std::span<const std::string> known);

/// The number of such edits between two words.
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace burin
