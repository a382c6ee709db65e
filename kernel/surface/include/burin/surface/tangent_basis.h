#pragma once
/// Angles in tangent planes, and how they change from one plane to a neighbouring one.

#include <burin/base/vec.h>

#include <cmath>

namespace burin {

/// An orthonormal basis (x, y) of the plane at a right angle to a unit normal; a function of the
/// normal alone.
struct TangentBasis {
  Vec3 normal, x, y;

  explicit TangentBasis(Vec3 unit_normal)
      : TangentBasis(unit_normal, any_orthogonal(unit_normal)) {}
  /// The same from a stored x axis.
  TangentBasis(Vec3 unit_normal, Vec3 x_axis)
      : normal(unit_normal), x(x_axis), y(glm::cross(unit_normal, x_axis)) {}

  /// Coordinates of the tangent part of `v`, and the tangent with given coordinates.
  Vec2 coords(Vec3 v) const { return {glm::dot(v, x), glm::dot(v, y)}; }
  Vec3 vector(Vec2 c) const { return c.x * x + c.y * y; }
};

/// The unit complex number (cos a, sin a) of the angle a by which `from`, carried to the plane of
/// `to` by the smallest rotation of the normals, is turned against `to`: a tangent at angle t in
/// `from` arrives at angle t + a in `to`.
inline Vec2 turn(const TangentBasis& from, const TangentBasis& to) {
  const double c = 1.0 + glm::dot(from.normal, to.normal);
  if (c < 1e-12) return {1, 0};  // opposite normals (unit vectors): no smallest rotation
  const Vec3 carried = from.x - (glm::dot(from.x, to.normal) / c) * (from.normal + to.normal);
  return to.coords(carried);
}

/// The product of two plane vectors as complex numbers, and the square of one: angles add.
inline Vec2 complex_mul(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
inline Vec2 complex_square(Vec2 a) { return {(a.x - a.y) * (a.x + a.y), 2 * a.x * a.y}; }
inline Vec2 complex_conj(Vec2 a) { return {a.x, -a.y}; }

/// A unit complex number of half the angle of the unit complex number `a`; its real part is not
/// negative.
inline Vec2 complex_sqrt(Vec2 a) {
  // The larger half-angle function first: the other follows without cancellation.
  if (a.x >= 0) {
    const double c = std::sqrt(0.5 * (1 + a.x));
    return {c, 0.5 * a.y / c};
  }
  const double s = std::copysign(std::sqrt(0.5 * (1 - a.x)), a.y);
  return {0.5 * a.y / s, s};
}

}  // namespace burin
