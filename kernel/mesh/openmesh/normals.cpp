#include <burin/base/parallel.h>
#include <burin/base/smoothstep.h>

#include "../build_steps.h"
#include "../patches.h"
#include "quadric_fit.h"
#include "ring_steps.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// Radians between neighbours that curve so gently that curvature may be extrapolated: 10 degrees.
constexpr double kGentle = 0.17;

/// Finds the normal of one wedge after another; keeps its buffers between them.
class WedgeNormal {
 public:
  WedgeNormal(const RingMesh& rings, const ProxyMesh& proxy, const std::vector<Vec3>& normals,
              const PlanarPatches& patches)
      : rings_(rings), proxy_(proxy), normals_(normals), patches_(patches) {}

  /// `corners` are the half-edges that leave the wedge.
  Vec3 find(std::span<const RingHandle> corners) {
    if (const Vec3 flat = flat_normal(corners); flat != Vec3(0)) return flat;
    gather(corners);
    const Vec3 tessellated = normalize_or(by_area_, fallback(corners));
    // Rims of facets have too few neighbours for a fit; there averages are exact on cylinders.
    const bool facets = coplanar_ && (ring_.size() < 6 || !ends_.empty());
    const Vec3 smooth = corners.size() > 1 && !facets ? fitted(corners) : by_shape_;
    // Where triangles on one side are far longer than on the other, the surface changes its
    // curvature here, and the longer side is the straighter one: areas know that, a fit does not.
    const double t = uneven();
    return normalize_or((1 - t) * normalize_or(smooth, tessellated) + t * tessellated, tessellated);
  }

 private:
  RingHandle next(RingHandle h) const { return rings_.next_halfedge_handle(h); }
  RingHandle prev(RingHandle h) const { return rings_.prev_halfedge_handle(h); }
  RingHandle opposite(RingHandle h) const { return rings_.opposite_halfedge_handle(h); }
  bool smooth(RingHandle h) const {
    return proxy_.edge_kind[static_cast<std::size_t>(rings_.corner(h))] == EdgeKind::Smooth;
  }
  const Vec3& face_normal(RingHandle h) const { return normals_[rings_.triangle(h)]; }
  std::int32_t patch(RingHandle h) const { return patches_.patch(rings_.triangle(h)); }

  Vec3 fallback(std::span<const RingHandle> corners) const {
    for (const RingHandle h : corners) {
      if (face_normal(h) != Vec3(0)) return face_normal(h);
    }
    return {0, 0, 1};
  }

  bool straight(RingHandle h) const {
    return patches_.straight[static_cast<std::size_t>(rings_.corner(h))] != 0;
  }

  /// The exact normal where the wedge lies in one patch, or where patches run straight up to it;
  /// else zero.
  Vec3 flat_normal(std::span<const RingHandle> corners) {
    if (patches_.of_face.empty()) return Vec3(0);
    const std::int32_t first = patch(corners.front());
    bool one_patch = first >= 0;
    kept_.clear();
    bent_.clear();
    for (const RingHandle h : corners) {
      one_patch = one_patch && patch(h) == first;
      const RingHandle in = prev(h);
      for (const RingHandle edge : {h, in}) {
        if (straight(edge)) bent_.push_back(patch(opposite(edge)));
      }
      if (straight(h) || straight(in)) kept_.push_back(patch(h));
    }
    // A facet of a fillet runs straight along the fillet, into the next corner, but bends where it
    // meets the flat face: there it has that face's normal.
    const auto bends = [&](std::int32_t p) { return std::ranges::find(bent_, p) != bent_.end(); };
    if (!std::ranges::all_of(kept_, bends)) std::erase_if(kept_, bends);
    if (one_patch) return patches_.normal[static_cast<std::size_t>(first)];
    if (kept_.empty()) return Vec3(0);
    if (std::ranges::count(kept_, kept_.front()) == std::ssize(kept_)) {
      return patches_.normal[static_cast<std::size_t>(kept_.front())];
    }
    Vec3 sum(0);
    for (const RingHandle h : corners) {
      const std::int32_t p = patch(h);
      if (p < 0 || std::ranges::find(kept_, p) == kept_.end()) continue;
      const Vec3 a = normalize_or(rings_.to(h) - rings_.from(h), Vec3(0));
      const Vec3 b = normalize_or(rings_.from(prev(h)) - rings_.from(h), Vec3(0));
      sum += std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) *
             patches_.normal[static_cast<std::size_t>(p)];
    }
    return normalize_or(sum, Vec3(0));
  }

  /// The neighbours around the wedge, and the averaged normals.
  void gather(std::span<const RingHandle> corners) {
    ring_.clear();
    ends_.clear();
    by_area_ = by_shape_ = Vec3(0);
    coplanar_ = false;
    const Vec3 p = rings_.from(corners.front());
    for (const RingHandle h : corners) {
      const RingHandle in = prev(h);
      const Vec3 a = rings_.to(h) - p, b = rings_.from(in) - p;
      ring_.push_back(a);
      if (!smooth(h)) ends_.push_back(a);
      if (!smooth(in)) {
        ring_.push_back(b);
        ends_.push_back(b);
      } else if (const std::int32_t own = patch(h); own >= 0) {
        coplanar_ = coplanar_ || patch(opposite(in)) == own;
      }
      const Vec3& n = face_normal(h);
      const double doubled = glm::length(glm::cross(a, b));
      by_area_ += doubled * n;
      const double sizes = glm::dot(a, a) * glm::dot(b, b);
      if (sizes > 0) by_shape_ += doubled / sizes * n;  // exact on spheres @cite Max1999
    }
    by_shape_ = normalize_or(by_shape_, fallback(corners));
  }

  /// The fitted normal, or the averaged one where the fit leans more than the triangles explain.
  Vec3 fitted(std::span<const RingHandle> corners) {
    points_ = ring_;
    double near = 1, beyond = 1;  // cosines of the largest angles between the average and triangles
    const Vec3 p = rings_.from(corners.front());
    const bool few = ring_.size() < 6;
    for (const RingHandle h : corners) {
      near = std::min(near, glm::dot(by_shape_, face_normal(h)));
      const RingHandle far_edge = next(h);
      if (!smooth(far_edge) || (!few && ends_.empty())) continue;
      const RingHandle o = opposite(far_edge);
      beyond = std::min(beyond, glm::dot(by_shape_, face_normal(o)));
      if (few) points_.push_back(rings_.from(prev(o)) - p);
    }
    const Vec3 n = quadric_normal(by_shape_, points_, ring_.size());
    if (n == Vec3(0)) return by_shape_;
    const double c = glm::dot(n, by_shape_);
    if (c >= near) return n;
    // At a rim the surface may go on turning as it does further in, by half a triangle, as long as
    // that is gentle.
    const double bend = ends_.empty() ? 0 : angle_of(beyond);
    const double rim = 0.6 * bend * (1 - smoothstep(kGentle, 2 * kGentle, bend));
    return angle_of(c) <= angle_of(near) + rim ? n : by_shape_;
  }

  /// 0 where the neighbours lie about evenly around the vertex, 1 where they are far away on one
  /// side only.
  double uneven() const {
    if (ends_.size() == 2) {
      const double a = glm::length(ends_[0]), b = glm::length(ends_[1]);
      return smoothstep(5, 12, std::max(a, b) / std::max(std::min(a, b), 1e-300));
    }
    if (!ends_.empty()) return 0;
    Vec3 sum(0);
    double size = 0;
    for (const Vec3& p : ring_) {
      sum += p;
      size += glm::length(p);
    }
    return smoothstep(0.45, 0.75, glm::length(sum) / size);
  }

  const RingMesh& rings_;
  const ProxyMesh& proxy_;
  const std::vector<Vec3>& normals_;
  const PlanarPatches& patches_;
  std::vector<std::int32_t> kept_, bent_;
  std::vector<Vec3> ring_, ends_, points_;
  Vec3 by_area_{0}, by_shape_{0};
  bool coplanar_ = false;
};

}  // namespace

void find_wedge_normals(const RingMesh& rings, ProxyMesh& proxy,
                        const std::vector<Vec3>& face_normals, const RunContext& context) {
  const PlanarPatches patches = find_patches(proxy, face_normals, context);
  const Groups<RingHandle> of_wedge = wedge_rings(rings, proxy, context);
  proxy.wedge_normal.resize(of_wedge.size());
  parallel_for(
      of_wedge.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        WedgeNormal wedge_normal(rings, proxy, face_normals, patches);
        for (std::size_t w = begin; w < end; ++w) {
          proxy.wedge_normal[w] = wedge_normal.find(of_wedge[w]);
        }
      },
      &context);
}

}  // namespace burin
