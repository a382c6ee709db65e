#include <burin/base/parallel_filter.h>

#include "facing.h"
#include "paper_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace burin {

namespace {

/// The corners of a triangle on paper, and what is of one side of it by the values at its corners:
/// a triangle or a quadrangle.
struct SeenPart {
  std::array<Vec2, 4> points{};
  std::size_t count = 0;

  SeenPart(const std::array<Vec2, 3>& p, const std::array<double, 3>& g, bool front) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t n = (k + 1) % 3;
      if ((g[k] > 0) == front) points[count++] = p[k];
      if ((g[k] > 0) != (g[n] > 0)) points[count++] = glm::mix(p[k], p[n], g[k] / (g[k] - g[n]));
    }
  }
  /// Paper mm: its area over its length.
  double width() const {
    double area = 0, longest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        longest = std::max(longest, glm::distance(points[i], points[j]));
      }
      if (i > 1) area += cross2(points[i - 1] - points[0], points[i] - points[0]) / 2;
    }
    return longest > 0 ? std::abs(area) / longest : 0;
  }
};

/// What planes and normals of facets say in a view.
class FacetSides {
 public:
  FacetSides(const Facing& facing, const std::vector<std::uint8_t>& tips)
      : facing_(facing), plane_(facing.camera()), tips_(tips) {}

  /// Whether the plane of a triangle is turned to the viewer.
  bool front(std::uint32_t f) const {
    const TriMesh& mesh = facing_.proxy().mesh;
    return plane_(mesh.positions[mesh.triangles[f][0]], mesh.normal(f)) > 0;
  }
  /// Whether a contour is visibly out of place there. The plane of a sliver on a round surface may
  /// be any: only where a contour is near that says anything.
  bool contradict(std::uint32_t f) const {
    const Triangle& w = facing_.proxy().wedges[f];
    const std::array<double, 3> g{facing_.g(w[0]), facing_.g(w[1]), facing_.g(w[2])};
    const bool side = front(f);
    const auto alike = std::ranges::count(g, side, [](double x) { return x > 0; });
    if (alike == 3) return false;
    const bool flat = at_tip(w);
    if (alike > 0 && flat && is_unlike_facet(f)) return true;
    return SeenPart(on_paper(f), g, !side).width() > (flat ? kOutOfPlaceAtTip : kOutOfPlace) &&
           (alike > 0 || beside_contour(f));
  }

 private:
  std::array<Vec2, 3> on_paper(std::uint32_t f) const {
    const TriMesh& mesh = facing_.proxy().mesh;
    const Triangle& t = mesh.triangles[f];
    const Camera& camera = facing_.camera();
    return {camera.to_paper(mesh.positions[t[0]]), camera.to_paper(mesh.positions[t[1]]),
            camera.to_paper(mesh.positions[t[2]])};
  }
  bool at_tip(const Triangle& wedges) const {
    return !tips_.empty() &&
           std::ranges::any_of(wedges, [&](std::uint32_t w) { return tips_[w] != 0; });
  }
  /// Whether the round surface that a facet stands for leaves it visibly at the middle of an edge.
  bool is_unlike_facet(std::uint32_t f) const {
    const TriMesh& mesh = facing_.proxy().mesh;
    const Triangle& t = mesh.triangles[f];
    const RoundedFacet rounded = facing_.over(f);
    const double most = kUnlikeFacet / facing_.camera().scale_at(mesh.positions[t[0]]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 flat = glm::mix(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]], 0.5);
      if (glm::distance(rounded.on_edge(k, 0.5), flat) > most) return true;
    }
    return false;
  }
  bool beside_contour(std::uint32_t f) const {
    const ProxyMesh& proxy = facing_.proxy();
    for (HalfEdge h = static_cast<HalfEdge>(3 * f), end = h + 3; h < end; ++h) {
      if (proxy.edge_kind[static_cast<std::size_t>(h)] != EdgeKind::Smooth) continue;
      const HalfEdge o = proxy.topology.opposite[static_cast<std::size_t>(h)];
      if (facing_.crosses(next_in_face(o)) || facing_.crosses(prev_in_face(o))) return true;
    }
    return false;
  }

  const Facing& facing_;
  FacingFunction plane_;
  const std::vector<std::uint8_t>& tips_;
};

}  // namespace

void Facing::let_wide_facets_decide(const std::vector<std::uint8_t>& tips,
                                    const RunContext& context) {
  const FacetSides sides(*this, tips);
  std::vector<std::uint32_t> found = parallel_filter<std::uint32_t>(
      proxy_->wedges.size(), kFaceGrain, [&](std::uint32_t f) { return sides.contradict(f); },
      context);
  if (found.empty()) return;
  decided_.assign(proxy_->wedges.size(), 0);
  for (const std::uint32_t f : found) decided_[f] = sides.front(f) ? 1 : -1;
  // And those beside them whose planes face the same way though their normals do not: nothing folds
  // between them.
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i % 4096 == 0) context.check();
    const bool front = decided_[found[i]] > 0;
    for (HalfEdge h = static_cast<HalfEdge>(3 * found[i]), end = h + 3; h < end; ++h) {
      if (!is_fold(h)) continue;
      const std::uint32_t f = face_of(proxy_->topology.opposite[static_cast<std::size_t>(h)]);
      if (decided(f) || sides.front(f) != front) continue;
      decided_[f] = decided_[found[i]];
      found.push_back(f);
    }
  }
}

bool Facing::is_fold(HalfEdge h) const {
  if (proxy_->edge_kind[static_cast<std::size_t>(h)] != EdgeKind::Smooth) return false;
  const HalfEdge o = proxy_->topology.opposite[static_cast<std::size_t>(h)];
  return front_at(h) != front_at(next_in_face(o)) || front_at(next_in_face(h)) != front_at(o);
}

std::vector<HalfEdge> Facing::folds() const {
  std::vector<HalfEdge> out;
  for (std::size_t i = 0; i < 3 * decided_.size(); ++i) {
    const auto h = static_cast<HalfEdge>(i);
    if (!decided(face_of(h)) || !is_fold(h)) continue;
    const HalfEdge o = proxy_->topology.opposite[i];
    if (h < o || !decided(face_of(o))) out.push_back(h);
  }
  return out;
}

}  // namespace burin
