#pragma once
/// Vectors and matrices: GLM in double precision under the names the whole kernel uses.

#include <glm/glm.hpp>

namespace burin {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;

/// The z component of the cross product of two plane vectors.
inline double cross2(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

/// `v` scaled to unit length, or `fallback` where `v` is exactly zero or not finite.
inline Vec3 normalize_or(Vec3 v, Vec3 fallback) {
  const double n = glm::length(v);
  return n > 0 && n < 1e300 ? v / n : fallback;
}

/// Some unit vector at a right angle to the unit vector `n`; a continuous choice except at n = -z.
/// @cite Duff2017
Vec3 any_orthogonal(Vec3 n);

/// `v` without its part along the unit vector `n` (not normalised).
inline Vec3 reject(Vec3 v, Vec3 n) { return v - glm::dot(v, n) * n; }

/// Rotates `v`, tangent at unit normal `from`, by the smallest rotation that takes `from` to the
/// unit normal `to`: discrete parallel transport. Length is kept; opposite normals return `v`.
Vec3 transport(Vec3 v, Vec3 from, Vec3 to);

}  // namespace burin
