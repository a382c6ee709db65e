#pragma once
/// Where a segment is nearest to a point.

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

}  // namespace burin
