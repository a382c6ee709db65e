#pragma once
/// Where a segment is nearest to a point, and how far that is.

#include <burin/base/vec.h>

#include <algorithm>

namespace burin {

/// The share s in [0,1] of the way at which a + s d is nearest to p; 0 where d has no length.
/// Points of two or three dimensions.
template <class Point>
double nearest_along(const Point& a, const Point& d, const Point& p) {
  const double dd = glm::dot(d, d);
  return dd > 0 ? std::clamp(glm::dot(p - a, d) / dd, 0.0, 1.0) : 0;
}

/// How far a point is from the segment from `a` to `b`.
template <class Point>
double distance_to_segment(const Point& a, const Point& b, const Point& p) {
  const Point d = b - a;
  return glm::distance(p, a + nearest_along(a, d, p) * d);
}

}  // namespace burin
