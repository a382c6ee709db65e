#pragma once
// The inside of a region as triangles; for converters/openscad alone.

#include <burin/base/vec.h>

#include "solid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace burin::csg {

/// A 2-manifold with boundary: where outlines touch at a point, the point is there once for each
/// piece of the inside that meets it.
struct Cap {
  struct Edge {
    std::uint32_t from = 0, to = 0;
    std::int32_t arc = -1;
    /// Of a clockwise outline.
    bool hole = false;
  };
  std::vector<Vec2> points;
  /// Counter-clockwise.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// The inside to the left; at each point as many arrive as leave, one each.
  std::vector<Edge> rim;
};

/// A constrained Delaunay triangulation with all points of the outlines; points are added only
/// where outlines that rounding has moved cross each other.
Cap cap_of(const Region& region);

}  // namespace burin::csg
