#pragma once
/// Descriptions of a user's choices: what each is called, means and takes. Everything that names,
/// explains or checks a choice is made from them: command line, Python, JSON Schema, pages, panels.

#include <burin/base/vec.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace burin {

/// A number in [low, high], of a unit ("mm", "degrees"; may be empty).
struct NumberRange {
  double low = 0, high = 0;
  std::string unit = {};
};
/// A whole number in [low, high].
struct WholeRange {
  std::uint64_t low = 0, high = 0;
};
/// A switch with its two words.
struct Switch {
  std::string on = "true", off = "false";
};
/// One word of a list. The value is its place there, from 0.
struct WordList {
  std::vector<std::string> words;
};
/// X,Y,Z, any vector but zero.
struct Direction {};
/// Anything else: whoever sets it reads it.
struct FreeText {};

using Takes = std::variant<NumberRange, WholeRange, Switch, WordList, Direction, FreeText>;
using OptionValue = std::variant<double, std::uint64_t, bool, Vec3, std::string>;

struct Option {
  /// As programs spell it: "hatch.spacing_min", "volume_degree".
  std::string name;
  /// What it is for, in one sentence without a full stop.
  std::string meaning;
  Takes takes;
  /// What it takes, for messages; empty: made from `takes`.
  std::string phrase = {};
};

/// What an option takes, for people: "0.05 to 50", "true or false", "X,Y,Z".
std::string takes_text(const Option& option);

/// A value from text; nothing where the option does not take it. Numbers may begin with + and have
/// blanks around them; switches also take 1 0 yes no on off, and true and false as Python spells
/// them.
std::optional<OptionValue> parse_value(const Option& option, std::string_view text);

/// The text that `parse_value` reads back to the same value.
std::string value_text(const Option& option, const OptionValue& value);

/// An option as one JSON object, for programs and panels: "name", "meaning", "kind" ("number",
/// "whole", "flag", "word", "direction" or "text"), where they apply "low", "high", "unit",
/// "words", and "takes" for people; and what `more` holds ({"default", "300"}), as text.
std::string to_json(const Option& option,
                    const std::vector<std::pair<std::string, std::string>>& more = {});

/// "number", "whole", "flag", "word", "direction" or "text".
std::string_view kind_of(const Option& option);

/// What JSON Schema says of the values that an option takes in files, as one object: true and false
/// for switches whose words these are, arrays of three numbers for directions.
std::string value_schema(const Option& option);

}  // namespace burin
