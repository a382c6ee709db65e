#pragma once
// How finely OpenSCAD divides circles; for converters/openscad alone.

#include <burin/base/vec.h>

#include "tree.h"

namespace burin::csg {

/// `$fn`, `$fa` and `$fs` of a node.
struct Fineness {
  double fn = 0, fa = 12, fs = 2;
};
Fineness fineness_of(const Node& node);

/// More would be no circle that anyone has drawn: OpenSCAD itself dies of it.
inline constexpr int kMostFragments = 1 << 20;

/// Corners of a circle of radius r mm, as OpenSCAD 2021.01 counts them; 3 at least. Throws
/// InputError above kMostFragments.
int fragments(double r, const Fineness& fineness);

/// Corner i of n on the unit circle; exact where sine and cosine are 0, 1/2 or 1.
Vec2 corner(int i, int n);
/// The point of the unit circle at an angle; exact at the same angles.
Vec2 direction(double degrees);

}  // namespace burin::csg
