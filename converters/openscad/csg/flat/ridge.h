#pragma once
// Where an extrusion narrows to a line or a point; for converters/openscad alone.

#include "cap.h"

namespace burin::csg {

/// Walls of two sides that meet on a line share its points, so that the solid is closed; where more
/// than two meet, each pair has points of its own.
struct Ridge {
  /// `top`: where each point of the cap ends, and `wide`: where it would if nothing narrowed.
  /// `along`: the coordinate that is left, -1 where all is one point.
  Ridge(const Cap& cap, const std::vector<Vec2>& top, const std::vector<Vec2>& wide, int along);

  std::vector<Vec2> points;
  /// For each edge of the rim the points of its end on the ridge, from above its beginning on; one
  /// where it ends in a point.
  std::vector<std::vector<std::uint32_t>> chains;
};

}  // namespace burin::csg
