#include "zero_set.h"

#include <burin/base/parallel_filter.h>

#include "facing.h"
#include "paper_limits.h"

#include <utility>

namespace burin {

namespace {}  // namespace

std::vector<std::uint32_t> ZeroSet::mixed_faces(const RunContext& context) const {
  const std::vector<Triangle>& wedges = proxy_->wedges;
  const auto mixed = [&](std::uint32_t f) {
    if (decided(f)) return false;
    const bool a = front(wedges[f][0]);
    return a != front(wedges[f][1]) || a != front(wedges[f][2]);
  };
  return parallel_filter<std::uint32_t>(wedges.size(), kFaceGrain, mixed, context);
}

ZeroCrossing ZeroSet::crossing(HalfEdge h) const {
  std::uint32_t a = origin_wedge(h), b = target_wedge(h);
  // The same order from both sides, so that both compute the same bits.
  const bool swapped = proxy_->wedge_vertex[a] > proxy_->wedge_vertex[b];
  if (swapped) std::swap(a, b);
  const Vec3 &p = proxy_->wedge_position(a), &q = proxy_->wedge_position(b);
  const double length = glm::length(q - p);
  double t = zero_share(a, b, h);
  ZeroCrossing out;
  if (t * length * camera_->scale_at(p) < kSnapLength) {
    t = 0;
    out.position = p;
  } else if ((1 - t) * length * camera_->scale_at(q) < kSnapLength) {
    t = 1;
    out.position = q;
  } else {
    out.position = on_edge(h, t);
  }
  out.share = swapped ? 1 - t : t;
  out.share_beyond = swapped ? t : 1 - t;
  return out;
}

Vec3 ZeroSet::normal(HalfEdge h, double share) const {
  if (decided(face_of(h))) return proxy_->mesh.normal(face_of(h));
  const Vec3 &a = proxy_->wedge_normal[origin_wedge(h)], &b = proxy_->wedge_normal[target_wedge(h)];
  return normalize_or((1 - share) * a + share * b, a);
}

}  // namespace burin
