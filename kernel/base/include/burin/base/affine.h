#pragma once
/// What placements do that stretch and shear.

#include <burin/base/placement.h>

namespace burin {

/// Whether all lengths grow alike: it turns, mirrors, scales and moves, and does no more. Programs
/// keep rotations in single precision: within 1e-5.
bool is_similar(const Placement& placement);

/// Whether it takes different points to different points, all of them finite.
bool is_invertible(const Placement& placement);

/// The most that any length, and any area, grows.
double stretch(const Placement& placement);
double area_stretch(const Placement& placement);

/// What takes all points back; only of an invertible one.
Placement inverse(const Placement& placement);

/// The unit normal of what was flat and had the normal `n`; outward stays outward.
Vec3 placed_normal(const Placement& placement, Vec3 n);

}  // namespace burin
