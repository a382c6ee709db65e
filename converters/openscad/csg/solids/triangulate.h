#pragma once
// Plane pieces as triangles; for csg/solids alone.

#include "space.h"

#include <array>
#include <span>

namespace burin::csg {

struct Triangulation {
  /// Counter-clockwise seen from the end of the plane's main axis.
  std::vector<std::array<Id, 3>> triangles;
  /// Across the side opposite to each corner; kNone outside the hull.
  std::vector<std::array<Id, 3>> neighbor;
  /// Whether that side is one of the edges.
  std::vector<std::array<bool, 3>> is_edge;
};

/// Of edges in a plane that meet at their ends alone; their convex hull is filled.
Triangulation triangulate(Space& space, Id plane, std::span<const std::array<Id, 2>> edges);

}  // namespace burin::csg
