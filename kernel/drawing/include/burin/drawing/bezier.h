#pragma once
/// Cubic Beziers fitted to polylines.

#include <burin/base/vec.h>

#include <array>
#include <span>
#include <vector>

namespace burin {

using CubicBezier = std::array<Vec2, 4>;

/// A chain of cubic Beziers, continuous, each starting where the one before ends, that stays within
/// `tolerance` of the polyline at its points; corners (turns of more than 30 degrees at a point)
/// stay corners. A closed polyline does not repeat its first point. @cite Schneider1990
std::vector<CubicBezier> fit_cubics(std::span<const Vec2> points, bool closed, double tolerance);

/// The Douglas-Peucker subset of a polyline: the indices that are kept, first and last always.
/// @cite Douglas1973
std::vector<std::size_t> simplify(std::span<const Vec2> points, double tolerance);

}  // namespace burin
