// How a march comes to an edge of the model, and what it does there.

#include <burin/base/bracketed_zero.h>

#include "march.h"

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Crossings without progress after which a march is led along the edge, and after which it gives
// up.
constexpr int kStalled = 3;
constexpr int kMaxTurns = 100;
// Share of a chord beyond its ends that still belongs to it, and neighbours looked at for what lies
// farther on.
constexpr double kBeyond = 1e-9;
// Cosine of the largest angle between march and edge at which both faces may claim that it goes to
// the other one, by rounding and the tolerance of the edge; a larger one is a fold.
constexpr double kGrazing = 0.985;
// Shares of the part's size that a march is led along an edge: at first, and at the most.
constexpr double kFirstSlide = 1e-8, kLongestSlide = 1e-4;

}  // namespace

// The length at which the path meets the curve, on the cubic between both ends of the step.
double March::meet(const Crossing& crossing, const PathState& to, double length) const {
  const double noise = triangles_.noise(crossing.edge);
  const auto f = [&](double gone) {
    return triangles_.inside(crossing.edge, between(state_, to, length, gone));
  };
  double low = 0, high = crossing.upto * length;
  double f_low = f(low), f_high = f(high);
  while (f_high >= -0.5 * noise && high < length) {
    high = std::min(length, 1.25 * high + 0.05 * length);
    f_high = f(high);
  }
  if (f_high >= 0) return high;
  if (f_low <= noise) {
    // It begins on the curve: only what lies inside between here and there makes another crossing.
    bool found = false;
    for (double x = 0.5 * high; !found && x > 1e-6 * high; x *= 0.5) {
      const double fx = f(x);
      found = fx > noise;
      if (!found) continue;
      low = x;
      f_low = fx;
    }
    if (!found) return 0;
  }
  const double span = high - low;
  return low + span * bracketed_zero([&](double share) { return f(low + share * span); }, f_low,
                                     f_high, {1e-15 * length / span, 1e-4 * noise});
}

// The state on the curve: the path itself, not the cubic.
double March::refine(const Crossing& crossing, double length, double guess, PathState& at) const {
  const double noise = triangles_.noise(crossing.edge);
  PathError error;
  double x = guess;
  if (!(x > 0) || !path().step(state_, x, at, error)) {
    at = state_;
    return 0;
  }
  for (int i = 0; i < kMaxRefinements; ++i) {
    const double f = triangles_.inside(crossing.edge, at.uv);
    if (std::abs(f) < 0.01 * noise) break;
    const double d = 1e-4 * length;
    const double slope = (triangles_.inside(crossing.edge, at.uv + d * at.velocity) - f) / d;
    if (!(slope < 0)) break;
    const double next = std::clamp(x - f / slope, 0.0, length);
    PathState there;
    if (!path().step(state_, next, there, error)) break;
    x = next;
    at = there;
  }
  return x;
}

// Where the path meets the curve of a border half-edge, or that of its neighbour on the border
// where it passes the first one beyond its end.
double March::find_crossing(Crossing& crossing, PathState& to, double length, PathState& at) {
  double gone = refine(crossing, length, meet(crossing, to, length), at);
  HalfEdge before = kNoHalfEdge;
  for (int i = 0; i < kMaxHandOvers; ++i) {
    const HalfEdge h = crossing.edge;
    const double share = triangles_.share(h, at.uv);
    if (share >= -kBeyond && share <= 1 + kBeyond) break;
    Vec2 step(0);
    const HalfEdge other =
        share > 1 ? triangles_.next_border(h, step) : triangles_.previous_border(h, step);
    // Back again: the path passes between both, at their common vertex.
    if (other == kNoHalfEdge || other == before) break;
    before = h;
    const Vec2 end = to.uv + step;
    if (triangles_.inside(other, end) >= -triangles_.noise(other)) break;
    state_.uv += step;
    to.uv = end;
    crossing = {other, 1};
    gone = refine(crossing, length, meet(crossing, to, length), at);
  }
  triangle_ = face_of(crossing.edge);
  return gone;
}

std::optional<MarchStop> March::cross(Crossing crossing, PathState& to, double length) {
  if (!triangles_.is_border(crossing.edge)) return MarchStop::Boundary;
  PathState at;
  const double gone = find_crossing(crossing, to, length, at);
  const HalfEdge h = crossing.edge;
  const BorderPlace place = triangles_.beside(h, at.uv);
  const Vec3 direction = at.direction();
  gone_ += gone;
  state_ = at;
  if (!path().start(place.uv, direction, at)) return MarchStop::Singular;
  state_ = at;
  const ModelEdgeClass kind = triangles_.edge_class(h);
  if (kind == ModelEdgeClass::Sharp) return MarchStop::Crease;
  if (kind == ModelEdgeClass::Boundary || triangles_.opposite(h) == kNoHalfEdge) {
    return MarchStop::Boundary;
  }
  // 1e-12 of the size is no progress: rounding.
  turns_ = gone > 1e-12 * atlas_.size ? 0 : turns_ + 1;
  if (turns_ > kMaxTurns) return MarchStop::NotConverged;
  return enter(h, place, turns_ < kStalled);
}

// Goes on at the same point of the edge on its other side, the direction carried over by the
// smallest rotation between the normals.
std::optional<MarchStop> March::enter(HalfEdge h, const BorderPlace& place, bool progress) {
  const HalfEdge other = triangles_.opposite(h);
  const BorderPlace entry = triangles_.across(h, place);
  const std::uint32_t triangle = face_of(other);
  const GeodesicPath next(atlas_, triangles_.face(triangle));
  PathState state;
  state.uv = entry.uv;
  state.s = atlas_.derivatives(triangles_.face(triangle), entry.uv);
  const Vec3 direction = transport(state_.direction(), path().normal(state_), next.normal(state));
  if (!next.start(entry.uv, direction, state)) return MarchStop::Singular;
  triangle_ = triangle;
  cell_ = inner_ = kUnbounded;
  state_ = state;
  const Vec2 along = triangles_.tangent(other, entry);
  const double inwards = triangles_.turn(triangle) * cross2(along, state.velocity);
  if (inwards > 0 && progress) return std::nullopt;
  return slide(other, entry, direction);
}

// Both sides say that the march goes to the other one, or it turns round at one place: it runs
// along the edge, and is led on there.
std::optional<MarchStop> March::slide(HalfEdge h, const BorderPlace& place, Vec3 direction) {
  const Vec2 along = triangles_.tangent(h, place);
  const Vec3 edge = along.x * state_.s.u + along.y * state_.s.v;
  const double speed = glm::length(edge), cosine = glm::dot(edge, direction) / speed;
  if (!(std::abs(cosine) > kGrazing) || !triangles_.is_border(h)) return MarchStop::Singular;
  const double size = atlas_.size, sign = cosine > 0 ? 1 : -1;
  slide_ = std::clamp(2 * slide_, kFirstSlide * size, kLongestSlide * size);
  const double way = std::min(slide_, length_ - gone_);
  const double share = std::clamp(place.share + sign * way / speed, 0.0, 1.0);
  const BorderPlace there = triangles_.place_at(h, share);
  gone_ += std::abs(share - place.share) * speed;
  PathState at;
  at.uv = there.uv;
  at.s = atlas_.derivatives(triangles_.face(triangle_), there.uv);
  const Vec2 ahead = triangles_.tangent(h, there);
  Vec3 tangent = sign * (ahead.x * at.s.u + ahead.y * at.s.v);
  // A little inwards, which is left of the half-edge.
  const Vec3 left = glm::cross(path().normal(at), sign * tangent);
  tangent += 1e-6 * left;
  if (!path().start(there.uv, tangent, state_)) return MarchStop::Singular;
  return std::nullopt;
}

}  // namespace burin::detail
