#pragma once
// Convex solids; for csg/solids alone.

#include "../solid.h"

#include <span>

namespace burin::csg {

/// The convex hull of points; empty where they lie in a plane.
Solid convex_hull(std::span<const Vec3> points);
/// Whether no point of it lies outside of one of its triangles.
bool convex(const Solid& solid);
/// Convex parts whose union a solid is (Nef polyhedra, cut from their notches). Throws Error where
/// that cannot be done.
std::vector<std::vector<Vec3>> convex_parts(const Solid& solid);

}  // namespace burin::csg
