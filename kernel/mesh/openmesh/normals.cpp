#include <burin/base/parallel.h>
#include <burin/base/smoothstep.h>

#include "../build_steps.h"
#include "../patches.h"
#include "quadric_fit.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// Radians between neighbours that curve so gently that curvature may be extrapolated: 10 degrees.
constexpr double kGentle = 0.17;

double angle_of(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

/// Finds the normal of one wedge after another; keeps its buffers between them.
class WedgeNormal {
 public:
  WedgeNormal(const ProxyMesh& proxy, const std::vector<Vec3>& normals,
              const PlanarPatches& patches)
      : proxy_(proxy), normals_(normals), patches_(patches) {}

  /// `corners` are the corners of the wedge.
  Vec3 find(std::span<const HalfEdge> corners) {
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
  Vec3 at(HalfEdge h) const { return proxy_.mesh.positions[origin(proxy_.mesh, h)]; }
  bool smooth(HalfEdge h) const {
    return proxy_.edge_kind[static_cast<std::size_t>(h)] == EdgeKind::Smooth;
  }

  Vec3 fallback(std::span<const HalfEdge> corners) const {
    for (const HalfEdge h : corners) {
      if (normals_[face_of(h)] != Vec3(0)) return normals_[face_of(h)];
    }
    return {0, 0, 1};
  }

  bool straight(HalfEdge h) const { return patches_.straight[static_cast<std::size_t>(h)] != 0; }

  std::int32_t patch_beyond(HalfEdge h) const {
    return patches_.patch(face_of(proxy_.topology.opposite[static_cast<std::size_t>(h)]));
  }

  /// The exact normal where the wedge lies in one patch, or where patches run straight up to it;
  /// else zero.
  Vec3 flat_normal(std::span<const HalfEdge> corners) {
    if (patches_.of_face.empty()) return Vec3(0);
    const std::int32_t first = patches_.patch(face_of(corners.front()));
    bool one_patch = first >= 0;
    kept_.clear();
    bent_.clear();
    for (const HalfEdge h : corners) {
      one_patch = one_patch && patches_.patch(face_of(h)) == first;
      const HalfEdge in = prev_in_face(h);
      for (const HalfEdge edge : {h, in}) {
        if (straight(edge)) bent_.push_back(patch_beyond(edge));
      }
      if (straight(h) || straight(in)) kept_.push_back(patches_.patch(face_of(h)));
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
    for (const HalfEdge h : corners) {
      const std::int32_t p = patches_.patch(face_of(h));
      if (p < 0 || std::ranges::find(kept_, p) == kept_.end()) continue;
      const Vec3 a = normalize_or(at(next_in_face(h)) - at(h), Vec3(0));
      const Vec3 b = normalize_or(at(prev_in_face(h)) - at(h), Vec3(0));
      sum += std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) *
             patches_.normal[static_cast<std::size_t>(p)];
    }
    return normalize_or(sum, Vec3(0));
  }

  /// The neighbours around the wedge, and the averaged normals.
  void gather(std::span<const HalfEdge> corners) {
    ring_.clear();
    ends_.clear();
    by_area_ = by_shape_ = Vec3(0);
    coplanar_ = false;
    const Vec3 p = at(corners.front());
    for (const HalfEdge h : corners) {
      const HalfEdge in = prev_in_face(h);
      const Vec3 a = at(next_in_face(h)) - p, b = at(in) - p;
      ring_.push_back(a);
      if (!smooth(h)) ends_.push_back(a);
      if (!smooth(in)) {
        ring_.push_back(b);
        ends_.push_back(b);
      } else if (const std::int32_t patch = patches_.patch(face_of(h)); patch >= 0) {
        const HalfEdge o = proxy_.topology.opposite[static_cast<std::size_t>(in)];
        coplanar_ = coplanar_ || patches_.patch(face_of(o)) == patch;
      }
      const Vec3& n = normals_[face_of(h)];
      const double doubled = glm::length(glm::cross(a, b));
      by_area_ += doubled * n;
      const double sizes = glm::dot(a, a) * glm::dot(b, b);
      if (sizes > 0) by_shape_ += doubled / sizes * n;  // exact on spheres @cite Max1999
    }
    by_shape_ = normalize_or(by_shape_, fallback(corners));
  }

  /// The fitted normal, or the averaged one where the fit leans more than the triangles explain.
  Vec3 fitted(std::span<const HalfEdge> corners) {
    points_ = ring_;
    double near = 1, beyond = 1;  // cosines of the largest angles between the average and triangles
    const Vec3 p = at(corners.front());
    const bool few = ring_.size() < 6;
    for (const HalfEdge h : corners) {
      near = std::min(near, glm::dot(by_shape_, normals_[face_of(h)]));
      const HalfEdge far_edge = next_in_face(h);
      if (!smooth(far_edge) || (!few && ends_.empty())) continue;
      const HalfEdge o = proxy_.topology.opposite[static_cast<std::size_t>(far_edge)];
      beyond = std::min(beyond, glm::dot(by_shape_, normals_[face_of(o)]));
      if (few) points_.push_back(at(prev_in_face(o)) - p);
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

  const ProxyMesh& proxy_;
  const std::vector<Vec3>& normals_;
  const PlanarPatches& patches_;
  std::vector<std::int32_t> kept_, bent_;
  std::vector<Vec3> ring_, ends_, points_;
  Vec3 by_area_{0}, by_shape_{0};
  bool coplanar_ = false;
};

}  // namespace

void find_wedge_normals(ProxyMesh& proxy, const Corners& corners,
                        const std::vector<Vec3>& face_normals, const RunContext& context) {
  const PlanarPatches patches = find_patches(proxy, face_normals, context);
  proxy.wedge_normal.resize(proxy.wedge_vertex.size());
  parallel_for(
      proxy.mesh.positions.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        WedgeNormal wedge_normal(proxy, face_normals, patches);
        std::vector<HalfEdge> sorted;
        for (std::size_t v = begin; v < end; ++v) {
          const auto all = corners[v];
          sorted.assign(all.begin(), all.end());
          const auto wedge = [&](HalfEdge h) { return wedge_of(proxy, h); };
          if (!std::ranges::is_sorted(sorted, {}, wedge)) {
            std::ranges::sort(sorted, {}, [&](HalfEdge h) { return std::pair(wedge(h), h); });
          }
          for (auto first = sorted.begin(); first != sorted.end();) {
            const std::uint32_t w = wedge(*first);
            const auto last =
                std::find_if(first, sorted.end(), [&](HalfEdge h) { return wedge(h) != w; });
            proxy.wedge_normal[w] = wedge_normal.find({first, last});
            first = last;
          }
        }
      },
      &context);
}

void find_sagitta(ProxyMesh& proxy, const Corners& corners, const RunContext& context) {
  std::vector<float> of_face(proxy.mesh.triangles.size());
  parallel_for(
      of_face.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          double largest = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = proxy.wedges[f][k], b = proxy.wedges[f][(k + 1) % 3];
            const Vec3 edge = proxy.wedge_position(a) - proxy.wedge_position(b);
            const Vec3 change = proxy.wedge_normal[a] - proxy.wedge_normal[b];
            largest = std::max(largest, glm::dot(edge, edge) * glm::dot(change, change));
          }
          // h^2 k / 8 with k = |change of normal| / h
          of_face[f] = static_cast<float>(std::sqrt(largest) / 8);
        }
      },
      &context);
  proxy.wedge_sagitta.assign(proxy.wedge_vertex.size(), 0);
  parallel_for(
      proxy.mesh.positions.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          for (const HalfEdge h : corners[v]) {
            float& sagitta = proxy.wedge_sagitta[wedge_of(proxy, h)];
            sagitta = std::max(sagitta, of_face[face_of(h)]);
          }
        }
      },
      &context);
}

}  // namespace burin
