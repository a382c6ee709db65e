#pragma once
// How far what leaves a level goes; internal to the module.

#include "order.h"

#include <cstdint>
#include <vector>

namespace burin::detail {

/// Places that each part takes one after the other while what it belongs to comes apart, relative
/// to where it stands before; the first is 0.
using Ways = std::vector<std::vector<Vec3>>;

/// How a removal moves.
struct Travel {
  /// Model mm along its direction.
  double by = 0;
  /// Where a node goes on to once what it came off has left another way; one a node, at a right
  /// angle to the direction.
  std::vector<Vec3> follow;
};

/// One for each removal of a level, from the inside out: the box of everything that moves clears
/// those of all parts that are still there, as they stand and as they will, in the frame of the
/// direction, by the gap. What comes off a part that leaves later another way goes on with it, so
/// that it stays before its place. `ways`: how the parts come apart inside; gets the travel of the
/// level. `crowded` counts removals that found no free place within the bound.
std::vector<Travel> travels(const Level& level, const Situation& situation, Ways& ways,
                            std::int64_t& crowded);

}  // namespace burin::detail
