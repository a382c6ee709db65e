#pragma once
/// Where a shape stands.

#include <burin/base/vec.h>

#include <cmath>

namespace burin {

/// Where a shape stands in the scene: p -> linear * p + offset, model mm. `linear` may turn,
/// mirror, stretch and shear (burin/base/affine.h); `scale` then is the mean of three.
struct Placement {
  Mat3 linear{1};
  Vec3 offset{0};

  Vec3 point(Vec3 p) const { return linear * p + offset; }
  Vec3 vector(Vec3 v) const { return linear * v; }
  bool mirrors() const { return glm::determinant(linear) < 0; }
  double scale() const { return std::cbrt(std::abs(glm::determinant(linear))); }
  bool moves() const { return linear != Mat3(1) || offset != Vec3(0); }
  bool operator==(const Placement&) const = default;
};

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
