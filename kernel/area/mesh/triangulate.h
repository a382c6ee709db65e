#pragma once
/// A constrained Delaunay triangulation of the sheet; internal to the module.

#include <burin/base/vec.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin::detail {

struct SheetMesh {
  std::vector<Vec2> points;
  /// Counterclockwise.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// The triangle beyond side `i`, which is opposite corner `i`; -1: none.
  std::vector<std::array<std::int32_t, 3>> beyond;
  /// Whether side `i` is on a segment of the input.
  std::vector<std::array<bool, 3>> constrained;
};

/// Segments that cross are divided where they do. Cost: n log n. @cite CGAL
SheetMesh triangulate_sheet(std::span<const Vec2> points,
                            std::span<const std::array<std::uint32_t, 2>> segments);

}  // namespace burin::detail
