#pragma once
// What must hold for keys to have an effect; internal to the module.

#include <burin/illustrate/unused_keys.h>

#include <cstddef>
#include <string_view>
#include <vector>

namespace burin::detail {

/// Where a key may have an effect: on parts that are drawn alike.
struct KeyPlace {
  const Style& whole;
  const Style& part;
  bool hatched = true, transparent = false;
  const KeySurroundings& around;
  /// Of strokes, from 1.
  std::size_t kind = 1;
};

struct KeyNeed {
  bool (*holds)(const KeyPlace&);
  /// What follows "has no effect" where it does not hold. {style}, {law} and {ink} stand for those
  /// of the part, {toneink} for its tone.ink.
  std::string_view otherwise;
};

/// What a key needs, the most general first. Of strokes the first kind's key tells.
std::vector<KeyNeed> needs_of(std::string_view key);

}  // namespace burin::detail
