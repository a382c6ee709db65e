#include "depth_cue.h"

#include <algorithm>
#include <limits>

namespace burin::detail {

DepthCue::DepthCue(std::span<const ProxyMesh* const> proxies, const Camera& camera,
                   const Style& style)
    : camera_(camera), near_(style.depth.near), far_(style.depth.far), ink_(style.depth.ink) {
  if (!active() && !pales()) return;
  front_ = -std::numeric_limits<double>::infinity();
  back_ = -front_;
  for (const ProxyMesh* proxy : proxies) {
    for (const Vec3& p : proxy->mesh.positions) {
      const double depth = camera.depth(p);
      front_ = std::max(front_, depth);
      back_ = std::min(back_, depth);
    }
  }
}

double DepthCue::mix(const Vec3& p, double at_near, double at_far) const {
  if (!(front_ > back_)) return at_near;
  const double t = std::clamp((front_ - camera_.depth(p)) / (front_ - back_), 0.0, 1.0);
  return at_near + t * (at_far - at_near);
}

std::vector<double> DepthCue::widths(std::span<const Vec3> points) const {
  std::vector<double> out;
  out.reserve(points.size());
  for (const Vec3& p : points) out.push_back(width(p));
  return out;
}

}  // namespace burin::detail
