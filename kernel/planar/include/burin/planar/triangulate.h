#pragma once
/// What lies inside oriented loops of a plane, as triangles.

#include <burin/base/ids.h>
#include <burin/base/vec.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Two indices of points: an edge with the inside to its left.
using DirectedEdge = std::array<std::uint32_t, 2>;

struct Triangulated {
  /// Counterclockwise; indices from `points.size()` on are those of `added`.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Where edges cross each other.
  std::vector<Vec2> added;
};

/// The places around which the edges wind a positive number of times, as a constrained Delaunay
/// triangulation (CGAL). Each point must have as many edges that leave as come. Points at the same
/// place become the first of them. Cost: n log n; where edges cross each other once more for each
/// face that they make. @cite CGAL
Triangulated triangulate(std::span<const Vec2> points, std::span<const DirectedEdge> edges);

}  // namespace burin
