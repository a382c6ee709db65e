#include "along_ray.h"

#include <algorithm>
#include <cstddef>

namespace burin::detail {

void AlongRay::add(const PaperRay& ray, const std::array<Vec2, 3>& corners) {
  std::array<Vec2, 3> p;  // along the ray and across it
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 d = corners[k] - ray.from;
    p[k] = {glm::dot(d, ray.way), cross2(ray.way, d)};
  }
  int before = 0, behind = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 a = p[k], b = p[(k + 1) % 3];
    if ((a.y < 0) == (b.y < 0)) continue;
    const double at = a.x + (b.x - a.x) * (a.y / (a.y - b.y));
    if (at > 0 && at <= ray.length) farthest = std::max(farthest, at);
    ++(at <= ray.length ? before : behind);
  }
  covers_end = covers_end || (before == 1 && behind == 1);
}

}  // namespace burin::detail
