#include "through_hole.h"

#include <burin/visibility/occluder.h>

#include <algorithm>
#include <vector>

namespace burin::detail {

bool goes_through(const Surface& part, const Feature& hole, const RunContext& context) {
  constexpr std::size_t kPlaces = 16;
  // Of the radius: near the wall, where the bottom of a drilled or a round end is near.
  constexpr double kNearWall = 0.9;
  const ProxyMesh* proxy = &part.proxy();
  const Occluder occluder({&proxy, 1}, context);
  const double near = 4 * occluder.resolution(), middle = 0.5 * (hole.low + hole.high);
  const double far = hole.high - middle + hole.radius;
  const std::size_t step = std::max<std::size_t>(1, hole.points.size() / kPlaces);
  for (std::size_t i = 0; i < hole.points.size(); i += step) {
    const Vec3 out = reject(hole.points[i] - hole.point, hole.along);
    if (!(glm::length(out) > 0)) continue;
    const Vec3 from =
        hole.point + middle * hole.along + kNearWall * hole.radius * glm::normalize(out);
    for (const Vec3& way : {hole.along, -hole.along}) {
      if (occluder.occluded(from, way, near, far)) return false;
    }
  }
  return true;
}

}  // namespace burin::detail
