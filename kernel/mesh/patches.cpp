#include "patches.h"

#include <burin/base/parallel.h>

#include "build_steps.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

/// Radians between neighbours in one plane; CAD curves bend by more from facet to facet.
constexpr double kFlatAngle = 2e-5;
/// Share of the box's diagonal by which the single precision of STL files moves corners.
constexpr double kRounding = 1e-7;
/// How much wider than the facet it bends to a patch is that runs straight; and than a single
/// triangle, which says little about the width of the facet it is part of.
constexpr double kWide = 2.5, kWideOfOne = 12;
/// Curvatures that differ by less than this factor belong to one curved face.
constexpr double kAlikeCurvatures = 2.5;
/// So many edges of a patch that say nothing of it are like those before and behind them.
constexpr std::size_t kMostBetween = 2;

class PatchFinder {
 public:
  PatchFinder(const ProxyMesh& proxy, const std::vector<Vec3>& normals, const RunContext& context)
      : proxy_(proxy), normals_(normals), context_(context) {
    rounding_ = kRounding * proxy.mesh.bounds().diagonal();
  }

  PlanarPatches find() {
    mark_coplanar();
    if (candidates_.empty()) return {};
    PlanarPatches result;
    result.of_face.assign(normals_.size(), -1);
    // Seeds of decent shape first: a needle does not know its plane.
    for (const bool needles : {false, true}) {
      for (const std::uint32_t f : candidates_) {
        if (result.of_face[f] < 0 && (needles || !is_needle(f))) grow(f, result);
      }
    }
    find_straight(result);
    return result;
  }

 private:
  HalfEdge opposite(HalfEdge h) const {
    return proxy_.topology.opposite[static_cast<std::size_t>(h)];
  }
  Vec3 at(HalfEdge h) const { return proxy_.mesh.positions[origin(proxy_.mesh, h)]; }

  /// Whether the corner `far` lies in the plane of normal `n` through the start of `edge`; both
  /// from that start.
  bool in_plane(Vec3 n, Vec3 edge, Vec3 far) const {
    const double off = std::abs(glm::dot(n, far));
    if (off <= rounding_) return true;
    // The height over the edge is at most the distance: mostly this decides, without a root.
    if (off * off > kFlatAngle * kFlatAngle * glm::dot(far, far)) return false;
    return off * glm::length(edge) <= kFlatAngle * glm::length(glm::cross(edge, far));
  }

  /// Whether the triangle beyond `h` lies in the plane of the triangle of `h`.
  bool coplanar(HalfEdge h) const {
    const auto i = static_cast<std::size_t>(h);
    if (proxy_.edge_kind[i] != EdgeKind::Smooth) return false;
    const HalfEdge o = opposite(h);
    const Vec3& n = normals_[face_of(h)];
    const Vec3& m = normals_[face_of(o)];
    if (glm::dot(n, m) < 1 - 5e-5) return false;  // 0.01 radians
    const Vec3 a = at(h), edge = at(o) - a;
    return in_plane(n, edge, at(prev_in_face(o)) - a) && in_plane(m, edge, at(prev_in_face(h)) - a);
  }

  void mark_coplanar() {
    const std::size_t faces = normals_.size();
    std::vector<std::vector<HalfEdge>> found((faces + kFaceGrain - 1) / kFaceGrain);
    parallel_for(
        faces, kFaceGrain,
        [&](std::size_t begin, std::size_t end) {
          for (auto h = static_cast<HalfEdge>(3 * begin); h < static_cast<HalfEdge>(3 * end); ++h) {
            if (h < opposite(h) && coplanar(h)) found[begin / kFaceGrain].push_back(h);
          }
        },
        &context_);
    std::vector<std::uint8_t> marked;
    for (const auto& part : found) {
      if (!part.empty() && marked.empty()) marked.assign(faces, 0);
      for (const HalfEdge h : part) marked[face_of(h)] = marked[face_of(opposite(h))] = 1;
    }
    for (std::uint32_t f = 0; f < marked.size(); ++f) {
      if (marked[f]) candidates_.push_back(f);
    }
  }

  bool is_needle(std::uint32_t f) const {
    double longest = 0;
    const auto h = static_cast<HalfEdge>(3 * f);
    for (int k = 0; k < 3; ++k) {
      const Vec3 e = at(next_in_face(h + k)) - at(h + k);
      longest = std::max(longest, glm::dot(e, e));
    }
    return proxy_.mesh.area(f) < 0.02 * longest;
  }

  void grow(std::uint32_t seed, PlanarPatches& result) {
    const auto patch = static_cast<std::int32_t>(result.normal.size());
    const Vec3 through = at(static_cast<HalfEdge>(3 * seed));
    Vec3 sum(0);
    double area = 0;
    result.of_face[seed] = patch;
    stack_.assign(1, seed);
    std::size_t size = 0;
    while (!stack_.empty()) {
      const std::uint32_t f = stack_.back();
      stack_.pop_back();
      ++size;
      sum += proxy_.mesh.area(f) * normals_[f];
      area += proxy_.mesh.area(f);
      const Vec3 normal = normalize_or(sum, normals_[seed]);
      const auto first = static_cast<HalfEdge>(3 * f);
      for (HalfEdge h = first; h < first + 3; ++h) {
        const HalfEdge o = opposite(h);
        if (o == kNoHalfEdge || result.of_face[face_of(o)] >= 0 || !coplanar(h)) continue;
        // Small bends must not add up to a curved patch.
        const Vec3 arm = at(prev_in_face(o)) - through;
        if (std::abs(glm::dot(normal, arm)) >
            std::max(3 * kFlatAngle * glm::length(arm), 3 * rounding_)) {
          continue;
        }
        result.of_face[face_of(o)] = patch;
        stack_.push_back(face_of(o));
      }
    }
    if (size == 1) {
      result.of_face[seed] = -1;
      return;
    }
    result.normal.push_back(normalize_or(sum, normals_[seed]));
    area_.push_back(area);
  }

  bool same_patch(const PlanarPatches& patches, HalfEdge a, HalfEdge b) const {
    const std::int32_t p = patches.of_face[face_of(a)];
    return p >= 0 && p == patches.of_face[face_of(b)];
  }

  struct Crossing {
    double width;
    HalfEdge exit;  // the edge on the far side, or kNoHalfEdge where that is not known
  };

  /// Goes from the middle of edge `h` straight across the patch (or the one triangle) on its side.
  Crossing cross(const PlanarPatches& patches, HalfEdge h) const {
    const Vec3 a = at(h), b = at(next_in_face(h)), from = 0.5 * (a + b);
    const Vec3 along = normalize_or(b - a, Vec3(0));
    const Vec3 across = glm::cross(normals_[face_of(h)], along);
    if (patches.of_face[face_of(h)] < 0) {
      return {std::max(glm::dot(at(prev_in_face(h)) - from, across), 0.0), kNoHalfEdge};
    }
    double width = 0;
    for (int steps = 0; steps < 10000;
         ++steps) {  // as many triangles across one face are too many anyway
      const HalfEdge right = next_in_face(h), left = prev_in_face(h);
      // The line leaves by the side of the triangle that the apex does not lie on.
      const HalfEdge out = glm::dot(at(left) - from, along) > 0 ? left : right;
      const Vec3 p = at(out) - from, q = at(next_in_face(out)) - from;
      const double px = glm::dot(p, along), qx = glm::dot(q, along);
      const double t = px == qx ? 0 : std::clamp(px / (px - qx), 0.0, 1.0);
      width = std::max(width, glm::dot(p + t * (q - p), across));
      const HalfEdge o = opposite(out);
      if (o == kNoHalfEdge || !same_patch(patches, out, o)) return {width, out};
      h = o;
    }
    return {width, kNoHalfEdge};
  }

  /// The change of the normal at an edge, a mm of the two widths it stands for; negative where it
  /// is no bend.
  double bend(HalfEdge h, double width, double width_beyond) const {
    if (h == kNoHalfEdge || proxy_.edge_kind[static_cast<std::size_t>(h)] != EdgeKind::Smooth) {
      return -1;
    }
    const Vec3 change = normals_[face_of(h)] - normals_[face_of(opposite(h))];
    return glm::length(change) / (0.5 * (width + width_beyond));
  }

  bool runs_straight(const PlanarPatches& patches, HalfEdge h) const {
    const HalfEdge o = opposite(h);
    const Crossing wide = cross(patches, h), narrow = cross(patches, o);
    const double wanted = narrow.exit == kNoHalfEdge ? kWideOfOne : kWide;
    if (!(wide.width >= wanted * narrow.width) || !(narrow.width > 0)) return false;
    // Strips of unequal width on one curved face all bend alike a mm.
    const double here = bend(h, wide.width, narrow.width);
    const auto alike = [&](const Crossing& c) {
      if (c.exit == kNoHalfEdge || opposite(c.exit) == kNoHalfEdge) return false;
      const double there = bend(c.exit, c.width, cross(patches, opposite(c.exit)).width);
      return there * kAlikeCurvatures > here && there < here * kAlikeCurvatures;
    };
    return !(alike(wide) && alike(narrow));
  }

  /// Whether a patch may run straight up to `h`: it is far larger than what lies beyond.
  bool may_run_straight(const PlanarPatches& patches, HalfEdge h) const {
    if (proxy_.edge_kind[static_cast<std::size_t>(h)] != EdgeKind::Smooth) return false;
    const auto area_at = [&](std::uint32_t f) {
      const std::int32_t p = patches.of_face[f];
      return p < 0 ? proxy_.mesh.area(f) : area_[static_cast<std::size_t>(p)];
    };
    const HalfEdge o = opposite(h);
    return !same_patch(patches, h, o) && area_at(face_of(h)) >= kWide * area_at(face_of(o));
  }

  void find_straight(PlanarPatches& result) const {
    result.straight.assign(proxy_.edge_kind.size(), 0);
    parallel_for(
        candidates_.size(), kFaceGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t f = candidates_[i];
            if (result.of_face[f] < 0) continue;
            for (HalfEdge h = static_cast<HalfEdge>(3 * f); face_of(h) == f; ++h) {
              if (!may_run_straight(result, h)) continue;
              result.straight[static_cast<std::size_t>(h)] = runs_straight(result, h);
            }
          }
        },
        &context_);
    fill_straight(result);
  }

  /// The edge that follows on the border of the patch of `h`, or kNoHalfEdge.
  HalfEdge next_on_border(const PlanarPatches& patches, HalfEdge h) const {
    HalfEdge next = next_in_face(h);
    for (;;) {
      const HalfEdge o = opposite(next);
      if (o == kNoHalfEdge || !same_patch(patches, next, o)) return next;
      next = next_in_face(o);
      if (next == h) return kNoHalfEdge;  // an end of a slit
    }
  }

  /// What a flat face does before and behind a place of its border it does there too, where it is
  /// narrow or the triangles beyond do not tell.
  void fill_straight(PlanarPatches& result) const {
    std::vector<HalfEdge> filled;
    for (const std::uint32_t f : candidates_) {
      if (result.of_face[f] < 0) continue;
      for (HalfEdge h = static_cast<HalfEdge>(3 * f); face_of(h) == f; ++h) {
        if (!result.straight[static_cast<std::size_t>(h)]) continue;
        std::array<HalfEdge, kMostBetween> between;
        std::size_t count = 0;
        for (HalfEdge e = next_on_border(result, h); e != kNoHalfEdge;
             e = next_on_border(result, e)) {
          if (result.straight[static_cast<std::size_t>(e)]) {
            filled.insert(filled.end(), between.begin(), between.begin() + count);
            break;
          }
          if (count == between.size() || !may_run_straight(result, e)) break;
          between[count++] = e;
        }
      }
    }
    for (const HalfEdge h : filled) result.straight[static_cast<std::size_t>(h)] = 1;
  }

  const ProxyMesh& proxy_;
  const std::vector<Vec3>& normals_;
  const RunContext& context_;
  double rounding_ = 0;
  std::vector<std::uint32_t> candidates_;
  std::vector<std::uint32_t> stack_;
  std::vector<double> area_;
};

}  // namespace

PlanarPatches find_patches(const ProxyMesh& proxy, const std::vector<Vec3>& face_normals,
                           const RunContext& context) {
  return PatchFinder(proxy, face_normals, context).find();
}

}  // namespace burin
