#include <burin/base/groups.h>
#include <burin/base/parallel_filter.h>

#include "build_steps.h"
#include "flood.h"
#include "tip_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace burin {

namespace {

/// Of the crease angle: bends below it are never edges.
constexpr double kLeastBend = 0.5;
/// Radians up to which two triangles are one flat face.
constexpr double kFlatBend = 0.01;
/// Of a bend: up to the first, bends on the far side of the face are nothing beside it; from the
/// second on it belongs to something rounder, as the first bend of a fillet does (half the next).
constexpr double kNothing = 0.1, kRounder = 1.2;
/// A chamfer is this many times narrower than the faces beside it.
constexpr double kNarrow = 3;
/// Of a face's width: an edge this near to the line of another is the same bend.
constexpr double kSameLine = 0.05;
/// Triangles of a flat face that is more than a facet, the end of something round, at the least;
/// and of the bend at its border: bends beyond the facet there that are smaller belong to a wall
/// that leads away from it, such as a cone's (a ball bends as much again, a fillet twice).
constexpr std::uint32_t kEnd = 4;
constexpr double kWall = 0.5;
/// Of the least bend: from there on a bend is an edge for certain, not one of something round that
/// is coarse.
constexpr double kStillRound = 2.5;
/// Cosine: bends that cross each other by more do not make one round face together.
constexpr double kAcross = 0.7;

class Bends {
 public:
  Bends(const ProxyMesh& proxy, const std::vector<Vec3>& normals, double least)
      : proxy_(proxy), normals_(normals), least_(least) {}

  /// Whether the edge bends enough, between faces of more than one triangle.
  bool is_candidate(HalfEdge h) const {
    return bends(h) && in_flat_face(face_of(h)) && in_flat_face(face_of(opposite(h)));
  }
  /// Whether it does so between one of more than one triangle and one that is a triangle.
  bool is_candidate_at_tips(HalfEdge h) const {
    return bends(h) && in_flat_face(face_of(h)) != in_flat_face(face_of(opposite(h)));
  }
  /// Whether it is the border of a flat end beside a wall: what else bends on the wall runs across.
  bool is_rim(HalfEdge h) const {
    if (!bends(h)) return false;
    const HalfEdge o = opposite(h);
    return (is_end(h) && leads_away(o)) || (is_end(o) && leads_away(h));
  }
  /// Whether nothing else bends on the face of more than one triangle.
  bool ends_a_wall(HalfEdge h) const { return alone(in_flat_face(face_of(h)) ? h : opposite(h)); }
  /// The half-edge on the side that is a triangle.
  HalfEdge on_triangle(HalfEdge h) const { return in_flat_face(face_of(h)) ? opposite(h) : h; }

  void find_faces() {
    const std::int32_t faces = flood(
        proxy_.topology.opposite, [&](HalfEdge h) { return is_flat(h); }, face_);
    triangles_.assign(static_cast<std::size_t>(faces), 0);
    for (const std::int32_t f : face_) ++triangles_[static_cast<std::size_t>(f)];
    const auto all = static_cast<HalfEdge>(proxy_.edge_kind.size());
    std::vector<HalfEdge> borders;
    for (HalfEdge h = 0; h < all; ++h) {
      if (opposite(h) == kNoHalfEdge || face(h) != face(opposite(h))) borders.push_back(h);
    }
    around_ = grouped(
        static_cast<std::size_t>(faces), borders.size(),
        [&](std::size_t i) { return std::array{static_cast<std::uint32_t>(face(borders[i]))}; },
        [&](std::size_t i) { return std::array{borders[i]}; });
  }

  /// Whether the edge is one that a draughtsman draws: nothing else bends on both of its faces, or
  /// it is one of the two edges of a chamfer between wider faces.
  bool is_edge(HalfEdge h) const {
    const HalfEdge o = opposite(h);
    const bool here = alone(h), there = alone(o);
    if (here && there) return true;
    return (there && is_chamfer(h, width(o))) || (here && is_chamfer(o, width(h)));
  }

 private:
  HalfEdge opposite(HalfEdge h) const {
    return proxy_.topology.opposite[static_cast<std::size_t>(h)];
  }
  EdgeKind kind(HalfEdge h) const { return proxy_.edge_kind[static_cast<std::size_t>(h)]; }
  std::size_t face(HalfEdge h) const { return static_cast<std::size_t>(face_[face_of(h)]); }
  Vec3 from(HalfEdge h) const { return proxy_.mesh.positions[origin(proxy_.mesh, h)]; }
  Vec3 to(HalfEdge h) const { return from(next_in_face(h)); }
  std::span<const HalfEdge> around(HalfEdge h) const { return around_[face(h)]; }

  /// Whether an edge bends enough; true of one of its half-edges.
  bool bends(HalfEdge h) const {
    return kind(h) == EdgeKind::Smooth && h < opposite(h) && bend(h) >= least_;
  }
  /// Radians; 0 at a boundary.
  double bend(HalfEdge h) const {
    const HalfEdge o = opposite(h);
    if (o == kNoHalfEdge) return 0;
    const Vec3 &a = normals_[face_of(h)], &b = normals_[face_of(o)];
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  }
  bool is_flat(HalfEdge h) const { return kind(h) == EdgeKind::Smooth && bend(h) < kFlatBend; }
  bool in_flat_face(std::uint32_t f) const {
    const auto h = static_cast<HalfEdge>(3 * f);
    return is_flat(h) || is_flat(h + 1) || is_flat(h + 2);
  }

  double length(HalfEdge h) const { return glm::distance(from(h), to(h)); }
  double distance(HalfEdge line, Vec3 p) const {
    return glm::length(glm::cross(to(line) - from(line), p - from(line))) / length(line);
  }
  /// Of the face of `h`, at a right angle to it, in model mm.
  double width(HalfEdge h) const {
    double most = 0;
    for (const HalfEdge e : around(h)) most = std::max(most, distance(h, from(e)));
    return most;
  }
  /// Calls `each(edge)` for the other bends of the face of `h` that count beside it, until it says
  /// false; whether it never did.
  template <class Each>
  bool others(HalfEdge h, const Each& each) const {
    const double near = kSameLine * width(h), least = kNothing * bend(h);
    return std::ranges::all_of(around(h), [&](HalfEdge e) {
      if (kind(e) != EdgeKind::Smooth || bend(e) <= least) return true;
      if (!runs_along(e, h)) return true;
      const bool same = distance(h, from(e)) <= near && distance(h, to(e)) <= near;
      return same || each(e);
    });
  }
  bool alone(HalfEdge h) const {
    return others(h, [](HalfEdge) { return false; });
  }
  bool is_end(HalfEdge h) const { return triangles_[face(h)] >= kEnd; }
  bool runs_along(HalfEdge e, HalfEdge h) const {
    const double along = glm::dot(to(e) - from(e), to(h) - from(h));
    return std::abs(along) >= kAcross * length(e) * length(h);
  }
  /// Whether an edge bends along `h` by a share of its bend and more, as what is round does again
  /// and again, little above the crease angle too.
  bool bends_again(HalfEdge e, HalfEdge h) const {
    const double bent = bend(e);
    if (bent < kWall * bend(h) || !runs_along(e, h)) return false;
    return kind(e) == EdgeKind::Smooth || bent < kStillRound * least_;
  }
  /// Whether nothing bends again on the wall of `h`, on its own face or the next ones, but for what
  /// leads there from the border of the end.
  bool leads_away(HalfEdge h) const {
    const Vec3 normal = normals_[face_of(opposite(h))];
    const auto at_end = [&](Vec3 p) {
      return std::abs(glm::dot(normal, p - from(h))) <= kSameLine * distance(h, p);
    };
    const auto again = [&](HalfEdge e) {
      return opposite(e) != kNoHalfEdge && !at_end(from(e)) && !at_end(to(e)) && bends_again(e, h);
    };
    return std::ranges::none_of(around(h), [&](HalfEdge e) {
      if (again(e)) return true;
      if (kind(e) != EdgeKind::Smooth || face(opposite(e)) == face(opposite(h))) return false;
      return std::ranges::any_of(around(opposite(e)), again);
    });
  }
  /// Whether the face of `h` is a chamfer beside one of width `beside`: what else bends there is no
  /// rounder, and leads to another face that is wider, and on which nothing else bends.
  bool is_chamfer(HalfEdge h, double beside) const {
    const double own = width(h);
    if (beside < kNarrow * own) return false;
    return others(h, [&](HalfEdge e) {
      const HalfEdge o = opposite(e);
      return bend(e) <= kRounder * bend(h) && face(o) != face(opposite(h)) && alone(o) &&
             width(o) >= kNarrow * own;
    });
  }

  const ProxyMesh& proxy_;
  const std::vector<Vec3>& normals_;
  double least_;
  std::vector<std::int32_t> face_;        // of each triangle the flat face
  std::vector<std::uint32_t> triangles_;  // of each face how many
  Groups<HalfEdge> around_;               // of each face its half-edges towards others
};

/// Sets or unsets a crease.
void set_crease(ProxyMesh& proxy, const std::vector<Vec3>& normals, HalfEdge h, bool crease) {
  const auto i = static_cast<std::size_t>(h);
  const EdgeKind kind = crease ? crease_kind(proxy, normals, h) : EdgeKind::Smooth;
  proxy.edge_kind[i] = kind;
  proxy.edge_kind[static_cast<std::size_t>(proxy.topology.opposite[i])] = kind;
}

}  // namespace

void sharpen_lone_bends(ProxyMesh& proxy, const std::vector<Vec3>& normals, double crease_angle,
                        const RunContext& context) {
  Bends bends(proxy, normals, kLeastBend * crease_angle);
  const auto all = [&](const auto& holds) {
    return parallel_filter<HalfEdge>(proxy.edge_kind.size(), 3 * kFaceGrain, holds, context);
  };
  const auto candidates = all([&](HalfEdge h) { return bends.is_candidate(h); });
  auto at_tips = all([&](HalfEdge h) { return bends.is_candidate_at_tips(h); });
  if (candidates.empty() && at_tips.empty()) return;
  bends.find_faces();
  std::vector<HalfEdge> edges;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i % kFaceGrain == 0) context.check();
    if (bends.is_edge(candidates[i]) || bends.is_rim(candidates[i])) edges.push_back(candidates[i]);
  }
  for (const HalfEdge h : at_tips) {
    if (bends.is_rim(h)) edges.push_back(h);
  }
  std::erase_if(at_tips, [&](HalfEdge h) { return !bends.ends_a_wall(h); });
  for (HalfEdge& h : at_tips) h = bends.on_triangle(h);
  for (const HalfEdge h : edges) set_crease(proxy, normals, h, true);
  for (const HalfEdge h : at_tips) set_crease(proxy, normals, h, true);
  // With all of them cut off: what goes over from wall to wall in fans from both ends of an edge.
  const TipFinder finder(proxy, normals, crease_angle);
  std::erase_if(at_tips, [&](HalfEdge h) {
    return finder.is_tip(finder.first_of(h)) && finder.is_tip(finder.first_of(next_in_face(h)));
  });
  for (const HalfEdge h : at_tips) set_crease(proxy, normals, h, false);
}

}  // namespace burin
