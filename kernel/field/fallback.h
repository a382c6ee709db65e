#pragma once
/// The direction of the style where the surface offers none.

#include <burin/base/vec.h>

#include <cmath>

namespace burin::field {

/// The unit part of `fallback` tangent at `normal`; where the two are within 20 degrees of one
/// another, that of the model axis that is most nearly at a right angle to `fallback` instead, so
/// that flat faces have one.
inline Vec3 fallback_tangent(Vec3 fallback, Vec3 normal) {
  const Vec3 unit = normalize_or(fallback, Vec3(0, 0, 1));
  const Vec3 t = reject(unit, normal);
  if (glm::length(t) > 0.34) return glm::normalize(t);
  const Vec3 a = glm::abs(unit);
  const Vec3 axis = a.x <= a.y && a.x <= a.z ? Vec3(1, 0, 0)
                    : a.y <= a.z             ? Vec3(0, 1, 0)
                                             : Vec3(0, 0, 1);
  return normalize_or(reject(axis, normal), any_orthogonal(normal));
}

}  // namespace burin::field
