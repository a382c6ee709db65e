#pragma once
/// Where a shape stands.

#include <burin/base/vec.h>

#include <cmath>

namespace burin {

/// Where a shape stands in the scene: p -> linear * p + offset, model mm. `linear` may turn,
/// mirror, stretch and shear.
struct Placement {
  Mat3 linear{1};
  Vec3 offset{0};

  Vec3 point(Vec3 p) const { return linear * p + offset; }
  Vec3 vector(Vec3 v) const { return linear * v; }
  bool mirrors() const { return glm::determinant(linear) < 0; }
  /// How many times as long all lengths become, where it is one number; else the mean of the three.
  double scale() const { return std::cbrt(std::abs(glm::determinant(linear))); }
  /// Whether all lengths grow alike: it turns, mirrors, scales and moves, and does no more.
  /// Programs keep rotations in single precision, which counts as none.
  bool is_similar() const;
  /// Whether it takes different points to different points, all of them finite.
  bool is_invertible() const;
  /// The most that any length, and any area, grows.
  double stretch() const;
  double area_stretch() const;
  /// What takes all points back; only where it is invertible.
  Placement inverse() const;
  bool moves() const { return linear != Mat3(1) || offset != Vec3(0); }
  bool operator==(const Placement&) const = default;
};

/// The unit normal of what was flat and had the normal `n`; outward stays outward.
Vec3 placed_normal(const Placement& placement, Vec3 n);

/// First `b`, then `a`.
inline Placement after(const Placement& a, const Placement& b) {
  return {a.linear * b.linear, a.point(b.offset)};
}

/// Turns about x, then y, then z, as OpenSCAD has it; whole quarter turns are exact.
Mat3 rotation(Vec3 degrees);

/// How far a matrix is from one that turns or mirrors and does no more: the largest entry by which
/// its transpose times itself differs from the identity. Infinite where it is no number.
double off_rotation(const Mat3& m);

}  // namespace burin
