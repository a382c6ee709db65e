#include "tip_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace burin {

namespace {

/// Cosine of 0.001 radians: between neighbours of one flat face.
constexpr double kFlatCosine = 1 - 0.5e-6;
/// Radians by which the triangles of a tip lean from their mean: less does not show, and is the
/// noise of files.
constexpr double kLeastAngle = 2 * std::numbers::pi / 180;
/// Of the crease angle: at a rim the facets of a smooth surface lean by up to half of it.
constexpr double kLeastAtRim = 0.6;
/// Of the lean: a tip bends alike all the way along its fan, as that of a pyramid of nine sides and
/// more does; where a ridge passes the vertex two edges bend by twice the lean.
constexpr double kMostBend = 0.65;
/// Radians: the faces at the pole of a ball of as many rings as sides lean by a share of pi each.
constexpr double kPole = 1.5 * std::numbers::pi;
/// Where the surface bends by more than the first, of the lean, or the second, of the bends within
/// the fan, beyond the triangles of a vertex, it is round there, and the vertex is the middle of a
/// bulge (the pole of a ball leans by half of what its next ring bends). So it is where a crease
/// around it bends by no more than the third of those: that is one facet more.
constexpr double kRound = 0.6, kAlike = 1.2, kFacet = 1.5;

/// Cosine of how far two creases turn at the corner of a shape: no rim that is round does so
/// between two of its facets.
constexpr double kCorner = 0.5;

}  // namespace

HalfEdge TipFinder::first_of(HalfEdge h) const {
  HalfEdge at = h;
  while (smooth(at)) {
    at = next_in_face(proxy_.topology.opposite[static_cast<std::size_t>(at)]);
    if (at == h) break;
  }
  return at;
}

/// The next corner of the fan, anticlockwise; kNoHalfEdge before a crease, and where that is
/// `first` again.
HalfEdge TipFinder::next(HalfEdge h, HalfEdge first) const {
  const HalfEdge in = prev_in_face(h);
  if (!smooth(in)) return kNoHalfEdge;
  const HalfEdge beyond = proxy_.topology.opposite[static_cast<std::size_t>(in)];
  return beyond == first ? kNoHalfEdge : beyond;
}

/// Whether something holds of one of the corners of the fan.
template <class Holds>
bool TipFinder::any(HalfEdge first, const Holds& holds) const {
  for (HalfEdge h = first; h != kNoHalfEdge; h = next(h, first)) {
    if (holds(h)) return true;
  }
  return false;
}

/// Cosine of the bend at a half-edge; 1 at a boundary.
double TipFinder::across(HalfEdge h) const {
  const HalfEdge o = proxy_.topology.opposite[static_cast<std::size_t>(h)];
  return o == kNoHalfEdge ? 1 : glm::dot(normals_[face_of(h)], normals_[face_of(o)]);
}

/// Cosines: of the largest bend between two faces of the fan, and of what the face that leans most
/// leans from their mean.
TipFinder::Fan TipFinder::measure(HalfEdge first) const {
  Fan fan;
  Vec3 sum(0);
  any(first, [&](HalfEdge h) {
    sum += normals_[face_of(h)];
    const HalfEdge in = prev_in_face(h);
    if (!smooth(in)) return false;
    const double bend = across(in);
    if (bend < kFlatCosine) ++fan.bends;
    fan.most = std::min(fan.most, bend);
    return false;
  });
  const Vec3 mean = normalize_or(sum, normals_[face_of(first)]);
  any(first, [&](HalfEdge h) {
    fan.lean = std::min(fan.lean, glm::dot(mean, normals_[face_of(h)]));
    return false;
  });
  return fan;
}

/// Whether beyond a crease there is a flat face of more than a triangle.
bool TipFinder::at_wall(HalfEdge h) const {
  const HalfEdge o = proxy_.topology.opposite[static_cast<std::size_t>(h)];
  if (o == kNoHalfEdge) return false;
  return std::ranges::any_of(std::array{next_in_face(o), prev_in_face(o)},
                             [&](HalfEdge e) { return smooth(e) && across(e) >= kFlatCosine; });
}

/// Whether the creases at both sides of the fan meet in a corner of flat walls.
bool TipFinder::at_corner(HalfEdge first) const {
  if (smooth(first)) return false;
  HalfEdge last = first;
  any(first, [&](HalfEdge h) {
    last = h;
    return false;
  });
  const auto along = [&](HalfEdge h) {
    const std::vector<Vec3>& p = proxy_.mesh.positions;
    return normalize_or(p[origin(proxy_.mesh, next_in_face(h))] - p[origin(proxy_.mesh, h)],
                        Vec3(0));
  };
  const HalfEdge end = prev_in_face(last);
  return glm::dot(along(end), along(first)) < kCorner && at_wall(first) && at_wall(end);
}

bool TipFinder::is_tip(HalfEdge first) const {
  const Fan fan = measure(first);
  const bool rim = !smooth(first);
  const int faces = rim ? fan.bends + 1 : fan.bends;
  if (faces < 3) return false;
  if (at_corner(first) && angle_of(fan.lean) >= kLeastAtRim * crease_angle_) return true;
  // Of small angles 1 - cos is half the square; what passes is looked at by angles.
  if (1 - fan.most > 1.2 * kMostBend * kMostBend * (1 - fan.lean)) return false;
  const double lean = angle_of(fan.lean), most = angle_of(fan.most);
  if (lean < (rim ? kLeastAtRim * crease_angle_ : kLeastAngle) || most > kMostBend * lean)
    return false;
  if (!rim && faces * lean < kPole) return false;
  const double round = std::cos(std::min(kRound * lean, kAlike * most));
  const double facet = std::cos(std::min(kFacet * most, std::numbers::pi));
  return !any(first, [&](HalfEdge h) {
    const HalfEdge out = next_in_face(h);
    return across(out) < round && (smooth(out) || across(out) >= facet);
  });
}

void TipFinder::label(HalfEdge first, std::vector<std::uint32_t>& labels) const {
  std::uint32_t face = 0;
  any(first, [&](HalfEdge h) {
    if (h != first && across(h) < kFlatCosine) ++face;
    labels[static_cast<std::size_t>(h)] = face;
    return false;
  });
  if (!smooth(first) || across(first) < kFlatCosine) return;
  // All the way round: the last face is the first one.
  any(first, [&](HalfEdge h) {
    std::uint32_t& l = labels[static_cast<std::size_t>(h)];
    if (l == face) l = 0;
    return false;
  });
}

}  // namespace burin
