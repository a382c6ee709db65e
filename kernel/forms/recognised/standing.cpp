#include "standing.h"

#include <burin/work_mesh/half_edges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace burin::recognised {
namespace {

// Cosine between a triangle and its surface from which on it lies on that: a facet of nine around
// leans by 20 degrees at its ends.
constexpr double kLies = 0.5;
// Each pass turns what the one before left beside a triangle that stands.
constexpr int kPasses = 4;

std::size_t index(HalfEdge h) { return static_cast<std::size_t>(h); }

class StandingTurner {
 public:
  StandingTurner(FacetMesh& mesh, const Meeting& meet)
      : m_(mesh),
        meet_(meet),
        opposite_(pair_half_edges(mesh.mesh.triangles, mesh.mesh.positions.size())) {}

  void run(const RunContext& context) {
    for (int pass = 0; pass < kPasses; ++pass) {
      bool any = false;
      for (std::uint32_t t = 0; t < m_.mesh.triangles.size(); ++t) {
        if (t % 4096 == 0) context.check();
        if (m_.patch[t] >= 0 && lean(m_.patch[t], m_.mesh.triangles[t]) < kLies) any |= turn_one(t);
      }
      if (!any) break;
    }
  }

 private:
  /// The cosine between a triangle and its surface; -1 where it has no area.
  double lean(SurfaceRef ref, const Triangle& t) const {
    const auto& p = m_.mesh.positions;
    const Vec3 &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
    const Vec3 twice = glm::cross(b - a, c - a);
    const double size = glm::length(twice);
    return size > 0 ? glm::dot(twice, meet_.normal(ref, (a + b + c) / 3.0)) / size : -1;
  }

  /// Turns that side of a triangle after which the worse of both lies best, if any is better.
  bool turn_one(std::uint32_t t) {
    HalfEdge best = kNoHalfEdge;
    double most = kLies;
    for (HalfEdge h = static_cast<HalfEdge>(3 * t), end = h + 3; h < end; ++h) {
      const double after = lean_after(h);
      if (after > most) most = after, best = h;
    }
    if (best == kNoHalfEdge) return false;
    turn(best);
    return true;
  }

  std::uint32_t vertex(HalfEdge h) const { return m_.mesh.triangles[face_of(h)][index(h) % 3]; }
  std::uint32_t apex(HalfEdge h) const { return vertex(prev_in_face(h)); }

  /// Both triangles at an edge, turned: from x to y, with apex b, and back with apex d.
  std::array<Triangle, 2> turned(HalfEdge h) const {
    const std::uint32_t x = vertex(h), y = vertex(next_in_face(h)), b = apex(h),
                        d = apex(opposite_[index(h)]);
    return {Triangle{x, d, b}, Triangle{d, y, b}};
  }

  /// The lean of the worse of both triangles, were an edge turned; -1 where it may not be.
  double lean_after(HalfEdge h) const {
    const HalfEdge o = opposite_[index(h)];
    if (o == kNoHalfEdge || m_.edge[index(h)] >= 0 || m_.edge[index(o)] >= 0) return -1;
    const std::uint32_t s = face_of(h), t = face_of(o);
    const bool alike = m_.patch[s] == m_.patch[t] && m_.face[s] == m_.face[t] &&
                       (m_.source.empty() || m_.source[s] == m_.source[t]);
    if (!alike || apex(h) == apex(o) || are_joined(h, apex(o))) return -1;
    const auto [one, other] = turned(h);
    return std::min(lean(m_.patch[s], one), lean(m_.patch[s], other));
  }

  /// Whether an edge runs from the apex of a half-edge to `v`.
  bool are_joined(HalfEdge h, std::uint32_t v) const {
    const HalfEdge start = prev_in_face(h);
    HalfEdge k = start;
    do {
      if (vertex(next_in_face(k)) == v || apex(k) == v) return true;
      k = opposite_[index(prev_in_face(k))];
    } while (k != kNoHalfEdge && k != start);
    return k != start;  // a border: not looked around
  }

  void turn(HalfEdge h) {
    const auto flipped = flip_edge(m_.mesh.triangles, opposite_, h);
    carry(flipped, &FlippedSide::side, m_.edge, -1);
    carry(flipped, &FlippedSide::corner, m_.normal);
  }

  FacetMesh& m_;
  const Meeting& meet_;
  std::vector<HalfEdge> opposite_;
};

}  // namespace

void turn_standing(FacetMesh& mesh, const Meeting& meet, const RunContext& context) {
  StandingTurner(mesh, meet).run(context);
}

}  // namespace burin::recognised
