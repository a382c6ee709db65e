#include "facing.h"

#include <burin/base/parallel.h>
#include <burin/mesh/tips.h>

#include "paper_limits.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::size_t kWedgeGrain = 16384;

}  // namespace

Facing::Facing(const ProxyMesh& proxy, const Camera& camera, const RunContext& context)
    : ZeroSet(proxy, camera) {
  const FacingFunction facing(camera);
  const bool cut = !proxy.on_contour.empty();
  parallel_for(
      g_.size(), kWedgeGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t w = begin; w < end; ++w) {
          const Vec3& p = proxy.wedge_position(static_cast<std::uint32_t>(w));
          g_[w] = cut && proxy.on_contour[w] != 0 ? 0 : facing(p, proxy.wedge_normal[w]);
        }
      },
      &context);
  if (cut) {  // exact normals do not lean
    turn_thin_patches_away(context);
    return;
  }
  const std::vector<std::uint8_t> tips = wedges_at_tips(proxy);
  turn_flat_walls_away(facing, context);
  face_tips(tips);
  turn_thin_patches_away(context);
  let_wide_facets_decide(tips, context);
}

void Facing::turn_flat_walls_away(const FacingFunction& facing, const RunContext& context) {
  const TriMesh& mesh = proxy_->mesh;
  const std::size_t n = mesh.triangles.size();
  std::vector<std::vector<std::uint32_t>> found((n + kFaceGrain - 1) / kFaceGrain);
  parallel_for(
      n, kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          const Triangle& t = mesh.triangles[f];
          const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]],
                     &c = mesh.positions[t[2]];
          const Vec3 normal = glm::cross(b - a, c - a);
          const double g = glm::dot(normal, facing.to_viewer(a));
          if (g * g > kEdgeOn * kEdgeOn * glm::dot(normal, normal)) continue;
          const auto [least, most] = std::minmax(
              {g_[proxy_->wedges[f][0]], g_[proxy_->wedges[f][1]], g_[proxy_->wedges[f][2]]});
          const double longest =
              std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
          if (longest * (most - least) / 8 * camera_->scale_at(a) < kFlatBulge) continue;
          found[begin / kFaceGrain].push_back(static_cast<std::uint32_t>(f));
        }
      },
      &context);
  for (const auto& part : found) {
    for (const std::uint32_t f : part) {
      for (const std::uint32_t w : proxy_->wedges[f]) turn_away(w);
    }
  }
}

void Facing::face_tips(const std::vector<std::uint8_t>& tips) {
  if (tips.empty()) return;
  // Of the other corners of its triangles: how many are turned to the viewer, and away.
  struct Sides {
    std::uint32_t front = 0, back = 0;
  };
  std::vector<Sides> beside(tips.size());
  for (const Triangle& w : proxy_->wedges) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!tips[w[k]]) continue;
      for (const std::uint32_t other : {w[(k + 1) % 3], w[(k + 2) % 3]}) {
        if (!tips[other]) ++(front(other) ? beside[w[k]].front : beside[w[k]].back);
      }
    }
  }
  for (std::size_t w = 0; w < tips.size(); ++w) {
    if (!tips[w]) continue;
    const auto [front, back] = beside[w];
    if (front > 0 && back > 0) g_[w] = 0;
    if (front > 0 && back == 0) g_[w] = std::max(g_[w], kEdgeOn);
    if (front == 0 && back > 0) g_[w] = std::min(g_[w], -kEdgeOn);
  }
}

}  // namespace burin
