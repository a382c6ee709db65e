#pragma once
// What the nodes of a tree evaluate to; for converters/openscad alone.

#include <burin/base/vec.h>
#include <burin/forms/recognised/turned_surface.h>

#include <array>
#include <cstdint>
#include <vector>

namespace burin::csg {

/// A circle that edges of a polygon stand for.
struct Arc {
  Vec2 middle{0};
  double radius = 0;
  /// Angle from corner to corner of the polygon.
  double step = 0;
};

/// A closed polygon without crossings. Edge i goes from point i to i + 1.
struct Outline {
  std::vector<Vec2> points;
  /// For each edge its arc, or -1 where it is meant straight.
  std::vector<std::int32_t> arc;
};

/// A 2-D result: the material lies to the left of every outline (outer ones counter-clockwise,
/// holes clockwise); outlines touch at most at points.
struct Region {
  std::vector<Outline> outlines;
  std::vector<Arc> arcs;
  bool empty() const { return outlines.empty(); }
};

/// What flat facets stand for.
using Turned = TurnedSurface;
/// What stands in the place of a surface where there is none.
inline constexpr std::int32_t kMeantFlat = KnownSurfaces::kMeantFlat;

/// A 3-D result: a closed surface, outside on the side from which triangles turn counter-clockwise.
struct Solid {
  std::vector<Vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// For each triangle the row of `surfaces` that it stands for, or kMeantFlat.
  std::vector<std::int32_t> surface;
  std::vector<Turned> surfaces;
  bool empty() const { return triangles.empty(); }
};

/// Facets of 40 degrees and more stay what they are: who asks for $fn = 8 wants a prism.
inline constexpr int kFewestRound = 9;

}  // namespace burin::csg
