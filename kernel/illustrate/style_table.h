#pragma once
/// The one table of style keys; text, JSON and help are made from it.

#include <burin/illustrate/style.h>

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace burin::detail {

/// A number in [low, high].
struct NumberKey {
  double& (*member)(Style&);
  double low, high;
};

/// A switch with its two words.
struct FlagKey {
  bool& (*member)(Style&);
  std::string_view on = "true", off = "false";
};

/// One word of a list.
struct WordKey {
  std::string& (*member)(Style&);
  std::vector<std::string> words;
};

/// A direction: any vector but zero.
struct VectorKey {
  Vec3& (*member)(Style&);
};

struct StyleKey {
  std::string name;
  std::string meaning;
  std::variant<NumberKey, FlagKey, WordKey, VectorKey> kind;
};

/// All keys, grouped as the members of Style are.
std::span<const StyleKey> style_table();

/// The key of that name. Throws UsageError that names the nearest.
const StyleKey& find_key(std::string_view name);

/// What a key takes, for people.
std::string takes(const StyleKey& key);

/// Sets and reads a key as text. Setting throws UsageError for anything that the key does not take.
void set_value(Style& style, const StyleKey& key, std::string_view text);
std::string value_text(const Style& style, const StyleKey& key);

}  // namespace burin::detail
