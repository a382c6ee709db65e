#pragma once
// Points that are one by their places, whatever their numbers; for csg/solids alone.

#include "../solid.h"

#include <span>
#include <vector>

namespace burin::csg {

/// mm: what OpenSCAD takes for one point when it makes a solid of a polyhedron.
inline constexpr double kFineGrid = 0x1p-20;

/// Some of the points (`which`, ascending) by place: for every point of `points` the first of those
/// that lie within `reach` mm of it along each axis; itself where it is none of them. Linear,
/// unless thousands of points lie within `reach` of each other.
std::vector<std::uint32_t> by_place(const std::vector<Vec3>& points,
                                    std::span<const std::uint32_t> which, double reach);
/// All of them.
std::vector<std::uint32_t> by_place(const std::vector<Vec3>& points, double reach);

/// A unit of the last of the six digits that a tree gives of the largest coordinate, and a little
/// more: numbers that were alike up to rounding may come that far apart.
double last_digit(const std::vector<Vec3>& points);

/// Corners of edges that are passed more often one way than the other, ascending.
std::vector<std::uint32_t> open_corners(const Solid& solid);
/// Whether every edge is passed as often one way as the other.
bool closed(const Solid& solid);

}  // namespace burin::csg
