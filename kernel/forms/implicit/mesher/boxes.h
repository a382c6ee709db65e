#pragma once
// Sizes of boxes around pieces of a surface.

#include <burin/base/box.h>

#include <algorithm>
#include <vector>

namespace burin {

inline double longest(const Box3& b) {
  const Vec3 s = b.size();
  return std::max({s.x, s.y, s.z});
}

inline Box3 grown(const Box3& b, double by) { return {b.min - by, b.max + by}; }

inline Box3 box_of(const std::vector<Vec3>& points) {
  Box3 b;
  for (const Vec3& p : points) b.add(p);
  return b;
}

}  // namespace burin
