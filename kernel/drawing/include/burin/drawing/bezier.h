#pragma once
/// Cubic Beziers fitted to polylines.

#include <burin/base/vec.h>

#include <array>
#include <span>
#include <vector>

namespace burin {

using CubicBezier = std::array<Vec2, 4>;

/// The point of a curve at t in [0,1].
inline Vec2 evaluate(const CubicBezier& c, double t) {
  const double s = 1 - t;
  return s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
}

/// A chain of cubic Beziers, continuous, each starting where the one before ends, that stays within
/// `tolerance` of the polyline: its points lie that near to the chain, and all of the chain lies
/// that near to the polyline. Turns of more than 30 degrees at a point stay corners, as do those
/// that a smooth curve could not follow within the tolerance; long straight runs stay straight
/// (`is_straight`). A closed polyline does not repeat its first point; a smooth loop is smooth at
/// its seam too. Points that repeat are ignored; fewer than two different points give no curve.
/// Cost: about 0.15 us per point. @cite Schneider1990
std::vector<CubicBezier> fit_cubics(std::span<const Vec2> points, bool closed, double tolerance);

/// Whether the curve runs from end to end within `tolerance` of its chord, never turning back.
bool is_straight(const CubicBezier& curve, double tolerance);

/// The Douglas-Peucker subset of a polyline: the indices that are kept, first and last always.
/// @cite Douglas1973
std::vector<std::size_t> simplify(std::span<const Vec2> points, double tolerance);

/// The same for the points of a plane curve together with a third number (a half width in mm, say).
std::vector<std::size_t> simplify(std::span<const Vec3> points, double tolerance);

}  // namespace burin
