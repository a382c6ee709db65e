#pragma once
// What a selector says of names; internal to the module.

#include <burin/surface/scene.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin::detail {

/// Whether a name is as the pattern says: * any text, ? any letter. Either way of writing an accent
/// (`composed`) means the other.
bool like(std::string_view pattern, std::string_view name);

/// The names from the top of the assembly down to the part.
std::vector<std::string> names_of(const Part& part);

/// Its name, and where that is made of a number and a given name (`piece_name`), each of them.
std::vector<std::string> names_of_piece(const std::string& name);

/// The patterns of a selector by name, one for each level. Throws UsageError where it is empty.
class NamePatterns {
 public:
  explicit NamePatterns(std::string_view selector);

  /// How many names, from the first, are as the patterns say, as few as are so; 0: none. What they
  /// lead to, or what contains it, is meant. A name from any depth means what readers have
  /// numbered, too: "bolt" is "bolt #2" as well, which the input calls the same; "/bolt" is not.
  std::size_t depth(std::span<const std::string> names) const;
  /// Whether they lead to the last of the names, and to nothing that contains it. Bodies of parts
  /// have names such as "solid 2" in all files: a pattern of one level, such as "*2", means none.
  bool lead_to_last(std::span<const std::string> names) const;

 private:
  std::vector<bool> reached(std::span<const std::string> names, bool as_read) const;

  std::vector<std::string> patterns_;
  bool path_ = false, from_top_ = false;
};

}  // namespace burin::detail
