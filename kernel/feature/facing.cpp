#include "facing.h"

#include <burin/base/parallel.h>

#include "limits.h"

#include <utility>

namespace burin {

namespace {

constexpr std::size_t kWedgeGrain = 16384;

}  // namespace

Facing::Facing(const ProxyMesh& proxy, const Camera& camera, const RunContext& context)
    : proxy_(&proxy), camera_(&camera), g_(proxy.wedge_normal.size()) {
  const bool perspective = camera.perspective();
  const Vec3 direction = camera.direction(), eye = camera.eye();
  const double unit = perspective ? 1 / glm::length(eye - camera.center()) : 0;
  parallel_for(
      g_.size(), kWedgeGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t w = begin; w < end; ++w) {
          const auto wedge = static_cast<std::uint32_t>(w);
          const Vec3 v = perspective ? (eye - proxy.wedge_position(wedge)) * unit : direction;
          g_[w] = glm::dot(proxy.wedge_normal[w], v) - kEdgeOn;
        }
      },
      &context);
}

ZeroCrossing Facing::crossing(HalfEdge h) const {
  std::uint32_t a = origin_wedge(h), b = target_wedge(h);
  // The same order from both sides, so that both compute the same bits.
  const bool swapped = proxy_->wedge_vertex[a] > proxy_->wedge_vertex[b];
  if (swapped) std::swap(a, b);
  const Vec3 &p = proxy_->wedge_position(a), &q = proxy_->wedge_position(b);
  const double length = glm::length(q - p);
  double t = g_[a] / (g_[a] - g_[b]);
  ZeroCrossing out;
  if (t * length * camera_->scale_at(p) < kSnapLength) {
    t = 0;
    out.position = p;
  } else if ((1 - t) * length * camera_->scale_at(q) < kSnapLength) {
    t = 1;
    out.position = q;
  } else {
    out.position = p + t * (q - p);
  }
  out.share = swapped ? 1 - t : t;
  return out;
}

Vec3 Facing::normal(HalfEdge h, double share) const {
  const Vec3 &a = proxy_->wedge_normal[origin_wedge(h)], &b = proxy_->wedge_normal[target_wedge(h)];
  return normalize_or((1 - share) * a + share * b, a);
}

}  // namespace burin
