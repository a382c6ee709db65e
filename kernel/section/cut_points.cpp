#include "cutter.h"

#include <algorithm>
#include <cmath>

namespace burin::detail {

/// Where the edge between two corners meets the plane: the one on it where that is one.
Cutter::Corner Cutter::between(const CutTriangle& t, std::size_t k, std::size_t j) {
  const std::size_t far = beyond(t.corners[k]) ? k : j;
  if (std::abs(height_[t.corners[far]]) <= on_plane_) return {t.corners[far], t.piece.bary[far]};
  // From the lower vertex on, so that both triangles get the same point.
  const bool first = t.corners[k] < t.corners[j];
  const std::size_t low = first ? k : j, high = first ? j : k;
  const std::uint32_t a = t.corners[low], b = t.corners[high];
  const auto [entry, is_new] = points_.try_emplace(edge_key(a, b));
  Between& at = entry->second;
  if (is_new) {
    at.vertex = static_cast<std::uint32_t>(positions.size());
    positions.push_back(find_between(t, low, high, at));
  }
  const Vec3 bary = glm::mix(t.piece.bary[low], t.piece.bary[high], at.share);
  if (!is_new) move_onto_edge(t, bary, at);
  return {at.vertex, bary};
}

/// Where the exact surface over an edge meets the plane; where the edge does, if it has none there
/// or lies in a plane of before.
Vec3 Cutter::find_between(const CutTriangle& t, std::size_t low, std::size_t high,
                          Between& out) const {
  constexpr int kMostSteps = 30;
  constexpr double kExact = 1e-6;  // of what lies on the plane: rounding
  const std::uint32_t a = t.corners[low], b = t.corners[high];
  out.share = height_[a] / (height_[a] - height_[b]);
  const Vec3 chord = glm::mix(positions[a], positions[b], out.share);
  const auto on_border = [&](std::uint32_t v) {
    return v >= on_some_plane_.size() || on_some_plane_[v] != 0;
  };
  if ((on_border(a) && on_border(b)) || !is_on_surface(t)) return chord;
  // False position; it halves what the side that stays says (Illinois). Bracketed, so that it ends.
  double from = 0, to = 1, at_from = height_[a], at_to = height_[b], share = out.share;
  for (int i = 0; i < kMostSteps; ++i) {
    const Lifted p = lift_(t.piece.facet, glm::mix(t.piece.bary[low], t.piece.bary[high], share));
    const double h = glm::dot(plane_.normal, p.position) - plane_.offset;
    const double moved = glm::distance(p.position, chord);
    if (!(moved <= 0.5 * glm::distance(positions[a], positions[b]))) break;
    if (std::abs(h) <= kExact * on_plane_) {
      out.share = share;
      out.lifted = p;
      return p.position - h * plane_.normal;
    }
    if ((h > 0) == (at_from > 0)) {
      from = share, at_from = h, at_to *= 0.5;
    } else {
      to = share, at_to = h, at_from *= 0.5;
    }
    share = glm::mix(from, to, at_from / (at_from - at_to));
  }
  return chord;
}

/// In files whose edges and faces do not fit, corners stand off it: then nothing is moved, for what
/// is moved must not stand beside what is not.
bool Cutter::is_on_surface(const CutTriangle& t) const {
  constexpr double kFits = 10;  // times what lies on the plane
  if (!lift_ || t.piece.facet == kNoFacet) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 p = lift_(t.piece.facet, t.piece.bary[k]).position;
    if (!(glm::distance(p, positions[t.corners[k]]) <= kFits * on_plane_)) return false;
  }
  return true;
}

/// A point on an edge between two faces lies on the first one's surface; as the second one comes,
/// it moves to where both and the plane meet.
void Cutter::move_onto_edge(const CutTriangle& t, Vec3 bary, const Between& at) {
  constexpr double kTangent = 0.05;  // sine: where faces go on into each other none says where
  if (at.lifted.normal == Vec3(0) || !is_on_surface(t)) return;
  const Lifted other = lift_(t.piece.facet, bary);
  const Vec3 &n1 = at.lifted.normal, &n2 = other.normal;
  const double det = glm::dot(plane_.normal, glm::cross(n1, n2));
  if (!(std::abs(det) > kTangent)) return;
  const Vec3 p = (plane_.offset * glm::cross(n1, n2) +
                  glm::dot(n1, at.lifted.position) * glm::cross(n2, plane_.normal) +
                  glm::dot(n2, other.position) * glm::cross(plane_.normal, n1)) /
                 det;
  const double apart = glm::distance(at.lifted.position, other.position);
  if (glm::distance(p, positions[at.vertex]) <= apart / kTangent) positions[at.vertex] = p;
}

}  // namespace burin::detail
