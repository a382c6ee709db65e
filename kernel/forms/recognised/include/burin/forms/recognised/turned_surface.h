#pragma once
/// What the facets of a mesh are known to stand for, from whoever made them.

#include <burin/base/vec.h>
#include <burin/forms/recognised/point_grid.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace burin {

/// A profile turned about an axis, of which a polyhedron with corners on it was made. Points of the
/// profile are (distance from the axis, height along it from `origin`) in mm. Or (`Grid`) a surface
/// of no such kind through the points of a grid.
struct TurnedSurface {
  Vec3 origin{0}, axis{0, 0, 1};
  /// Angle from facet to facet about the axis.
  double step = 0;
  enum class Profile : std::uint8_t { Line, Circle, Grid } profile = Profile::Line;
  /// Line: two points of it, apart. Outside is where the triangles say.
  Vec2 a{0}, b{0};
  /// Circle: with its middle on the axis a sphere, else a torus.
  Vec2 middle{0};
  double radius = 0;
  /// Circle: angle from facet to facet along it.
  double profile_step = 0;
  /// Grid: a piece of `smooth_grids`; shared, never changed.
  std::shared_ptr<const PointGrid> grid;
};

/// For each triangle of a mesh the row of `surfaces` that it stands for, kMeantFlat, or kUnknown
/// where nobody knows.
struct KnownSurfaces {
  static constexpr std::int32_t kMeantFlat = -1, kUnknown = -2;
  std::vector<TurnedSurface> surfaces;
  std::vector<std::int32_t> of;
};

}  // namespace burin
