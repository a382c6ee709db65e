#pragma once
// Directions on paper; internal to the module.

#include <burin/base/vec.h>

namespace burin {

/// To the left of a vector, as long as it.
inline Vec2 turned_left(Vec2 v) { return {-v.y, v.x}; }

}  // namespace burin
