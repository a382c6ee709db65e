#include "march.h"

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Shares of the part's size: what the steps of a long march and a march of one step may leave open
// by their estimates, and the step below which the path is taken for singular.
constexpr double kStepError = 3e-10, kShortError = 1e-9;
constexpr double kShortestStep = 1e-11;
// Steps of one march at the most, so that it ends whatever the surface is.
constexpr int kMaxSteps = 20'000;
// Share of a march that is stepped however near a border is ahead: a march along a border always
// has it ahead, within rounding.
constexpr double kAlongBorder = 0.05;

}  // namespace

MarchStep March::run(const SurfacePoint& from, Vec3 tangent) {
  Vec2 uv(from.coords.x, from.coords.y);
  triangle_ = triangles_.locate(from.triangle, uv);
  MarchStep none;
  none.end = from;
  if (!start(uv, tangent)) {
    none.stop = MarchStop::Singular;
    return none;
  }
  if (!(length_ > 0)) {
    none.direction = state_.direction();
    return none;
  }
  const double size = atlas_.size;
  double trial = length_;
  for (int i = 0; i < kMaxSteps; ++i) {
    if (const auto stop = enter_cell()) return result(*stop);
    const double rest = length_ - gone_;
    // A domain ends with a border, and beyond it S is clamped: no step goes much farther.
    const double side = triangles_.to_side(triangle_, state_.uv, state_.velocity);
    double h = std::min({trial, rest, 1.001 * std::max(side, kAlongBorder * length_)});
    PathState to;
    // Strokes are made of such steps.
    if (h == length_ && path().short_step(state_, h, kShortError * size, to)) {
      stop_at_line(to, h);
      if (const auto stop = advance(to, h)) return result(*stop);
      if (gone_ >= length_) return result(MarchStop::Completed);
      trial = length_;
      continue;
    }
    PathError error;
    double excess = 1e4;
    if (path().step(state_, h, to, error)) {
      const double ahead = std::max(h, 0.1 * rest);
      excess = (error.position + error.direction * ahead) / (kStepError * size);
    }
    // The embedded method is of the third order: its error goes with the fourth power of the step.
    const double scale = excess > 0 ? 0.9 / std::sqrt(std::sqrt(excess)) : 4;
    if (excess > 1) {
      trial = h * std::max(scale, 0.1);
      if (trial < kShortestStep * size) return result(MarchStop::Singular);
      continue;
    }
    trial = std::max(h * std::min(scale, 4.0), kShortestStep * size);
    stop_at_line(to, h);
    if (const auto stop = advance(to, h)) return result(*stop);
    if (gone_ >= length_) return result(MarchStop::Completed);
  }
  return result(MarchStop::NotConverged);
}

MarchStep March::result(MarchStop stop) const {
  MarchStep step;
  step.end.chart = triangles_.face(triangle_);
  step.end.coords = Vec3(state_.uv, 0);
  step.end.triangle = triangle_;
  step.end.position = state_.s.p;
  step.direction = state_.direction();
  step.length = std::min(gone_, length_);
  step.stop = stop;
  return step;
}

std::optional<MarchStop> March::advance(PathState& to, double length) {
  const Crossing crossing = pass(to);
  if (lost_) return MarchStop::NotConverged;
  if (crossing.edge != kNoHalfEdge) return cross(crossing, to, length);
  double share = 1;
  if (triangles_.meets_pole(triangle_, state_.uv, to.uv, share)) {
    PathState at;
    PathError error;
    if (share > 0 && path().step(state_, share * length, at, error)) {
      state_ = at;
      gone_ += share * length;
    }
    return MarchStop::Singular;
  }
  state_ = to;
  turns_ = 0;
  const double rest = length_ - gone_;
  gone_ = length < rest ? gone_ + length : length_;
  return std::nullopt;
}

// Walks through the triangles under a step. Afterwards state_, `to` and triangle_ are those of the
// triangle where the step ends, or of the one whose border it crosses.
March::Crossing March::pass(PathState& to) {
  Way way{state_.uv, to.uv, Vec2(0), triangle_};
  Crossing crossing;
  WalkGuard guard;
  for (;;) {
    if (!guard.go_on(way.triangle, way.step)) {
      lost_ = true;
      break;
    }
    const UvExit exit = triangles_.exit(way.triangle, way.from, way.to);
    if (triangles_.curved(way.triangle) && passes_curve(way, exit, crossing)) break;
    if (exit.edge == kNoHalfEdge) break;
    if (triangles_.is_border(exit.edge) || triangles_.opposite(exit.edge) == kNoHalfEdge) {
      crossing = leave(exit.edge, way);
      break;
    }
    way.move(triangles_.branch_step(exit.edge));
    way.triangle = face_of(triangles_.opposite(exit.edge));
  }
  triangle_ = way.triangle;
  state_.uv += way.step;
  to.uv += way.step;
  return crossing;
}

// A curve that bends into its triangle can be met before its chord.
bool March::passes_curve(const Way& way, const UvExit& exit, Crossing& crossing) const {
  const double upto = std::clamp(exit.share, 0.0, 1.0);
  const Vec2 q = way.at(upto);
  for (int k = 0; k < 3; ++k) {
    const auto h = static_cast<HalfEdge>(3 * way.triangle) + k;
    if (h == exit.edge || !triangles_.is_border(h)) continue;
    const double bulge = triangles_.bulge(h);
    if (bulge == 0 || triangles_.inside_chord(h, q) >= bulge) continue;
    if (triangles_.inside(h, q) >= -triangles_.noise(h)) continue;
    crossing = {h, upto};
    return true;
  }
  return false;
}

// The way leaves through the chord of a border half-edge: does it pass the curve, too?
March::Crossing March::leave(HalfEdge h, Way& way) const {
  Crossing crossing;
  if (!triangles_.is_border(h)) {
    crossing.edge = h;
    return crossing;
  }
  HalfEdge before = kNoHalfEdge;
  for (int i = 0; i < kMaxHandOvers; ++i) {
    const double noise = triangles_.noise(h), bulge = triangles_.bulge(h);
    const double begin = triangles_.inside_chord(h, way.from);
    const double end = triangles_.inside_chord(h, way.to);
    const double beyond = 1.01 * bulge + 2 * noise;
    double upto = 1;
    if (end < -beyond && begin > end) {
      upto = std::clamp((begin + beyond) / (begin - end), 0.0, 1.0);
    }
    const double share = triangles_.share(h, way.at(upto));
    if (bulge > 0 && (share < 0 || share > 1)) {
      Vec2 step(0);
      const HalfEdge other =
          share > 1 ? triangles_.next_border(h, step) : triangles_.previous_border(h, step);
      if (other != kNoHalfEdge && other != before) {
        way.move(step);
        before = h;
        h = other;
        continue;
      }
    }
    way.triangle = face_of(h);
    if (triangles_.inside(h, way.at(upto)) < -noise) {
      crossing = {h, upto};
      return crossing;
    }
    if (upto < 1 && triangles_.inside(h, way.to) < -noise) {
      crossing = {h, 1};
      return crossing;
    }
    break;
  }
  // Between chord and curve: still on this face.
  way.triangle = face_of(h);
  Vec2 to = way.to;
  way.triangle = triangles_.locate(way.triangle, to);
  way.move(to - way.to);
  crossing.edge = beyond(way);
  return crossing;
}

// The border half-edge that the end of the way lies beyond, if any. A way along a border leaves
// the face where the next one turns off from it, though it never crosses its own.
HalfEdge March::beyond(Way& way) const {
  const auto outside = [&](HalfEdge h, Vec2 at) {
    return triangles_.inside(h, at) < -triangles_.noise(h);
  };
  const Vec2 middle = triangles_.uv(way.triangle, Vec3(1.0 / 3));
  const HalfEdge h = triangles_.exit(way.triangle, middle, way.to).edge;
  if (h == kNoHalfEdge || !triangles_.is_border(h)) return kNoHalfEdge;
  if (outside(h, way.to)) return h;
  const double share = triangles_.share(h, way.to);
  if (share >= 0 && share <= 1) return kNoHalfEdge;
  Vec2 step(0);
  const HalfEdge other =
      share > 1 ? triangles_.next_border(h, step) : triangles_.previous_border(h, step);
  if (other == kNoHalfEdge || !outside(other, way.to + step)) return kNoHalfEdge;
  way.move(step);
  way.triangle = face_of(other);
  return other;
}

}  // namespace burin::detail
