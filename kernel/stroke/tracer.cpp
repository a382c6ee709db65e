#include "tracer.h"

#include <cmath>
#include <numbers>

namespace burin::detail {
namespace {

constexpr double kLeastStep = 0.05;  // ... that the last one is not shorter than
constexpr double kProbeEvery = 2;    // samples between two tests of visibility
constexpr double kHiddenTail = 1.2;  // paper mm that a stroke goes on unseen, to be cut later
constexpr double kHiddenReach = 15;  // paper mm: behind less a stroke comes out as the same line
constexpr double kMinFacing = 0.02;  // cosine: the surface is seen edge-on and turns away
constexpr double kMinRun = 0.12;     // share of its length that a step must keep on paper
constexpr double kMaxTurn = 0.7;     // cosine of the turn in one step that still is a smooth stroke
constexpr double kOwnDirection = 0.7;  // cosine up to which a direction is that of the family
constexpr double kForeign = 1.2;       // paper mm that a stroke may run along another family's arm
constexpr double kAlongLevel = 0.5;    // sine of the angle to a level line up to which it is one
constexpr double kMostOff = 0.25;      // of a step that a stroke may be off its level line
constexpr double kLeastOff = 1e-4;     // ... that it is left off
constexpr int kMaxSamples = 20000;     // a bound where length_max is set absurdly high

constexpr double kUnguided = 1.5;  // paper mm that a stroke is seen beyond its level line
// Gaps that it keeps from its neighbours there, and on its way to where the surface turns away.
constexpr double kApart = 0.55, kTurningApart = 0.25;
// Gaps between the neighbours of a tip up to which it goes on into their wedge, how far at the
// most, and how near to one of them. Lines that do not swell would be too dark there: paper mm.
constexpr double kClosed = 2 * kApart, kDeepest = 5, kTouching = 0.4, kDeepestStiff = 0.7;
constexpr double kSameFacing = 0.001;  // cosine by which it may rise on the way to a contour

// Model mm along a stroke that show as so many on paper.
double length_of(const Camera& camera, const StrokeSample& at, double paper) {
  const double scale = camera.scale_at(at.point.position);
  const double speed = glm::length(camera.velocity(at.point.position, at.tangent)) / scale;
  return paper / (scale * std::max(speed, kMinRun));
}

}  // namespace

double TracedStroke::length() const {
  double sum = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    sum += glm::length(samples[i].paper - samples[i - 1].paper);
  }
  return sum;
}

void look_at(const Picture& picture, std::int32_t part, const SurfacePoint& point,
             const Frame& frame, StrokeSample& out) {
  const Surface& surface = picture.surface(part);
  const Camera& camera = picture.camera;
  const ProxyPoint place = surface.to_proxy(point);
  out.point = point;
  out.normal = frame.normal;
  out.kind = frame.kind;
  out.bent = frame.k1 != 0 || frame.k2 != 0;
  out.paper = camera.to_paper(point.position);
  out.depth = camera.depth(point.position);
  const double cosine = glm::dot(frame.normal, camera.to_viewer(point.position));
  out.facing = std::abs(cosine);
  out.slope = Picture::slope(out.facing, camera.scale_at(point.position));
  out.face = place.face;
  out.region = surface.proxy().face_region[place.face];
  out.darkness = picture.darkness(part, out.region, point, frame, cosine);
  out.front = cosine > 0;
  out.visible = out.front || !surface.proxy().closed(place.face);
}

bool may_begin(const Picture& picture, const StrokeSample& at) {
  return at.visible && at.facing > kMinFacing && picture.on_sheet(at.paper);
}

GridSample grid_sample(const StrokeSample& s, std::int32_t part, std::int32_t stroke) {
  return {s.paper, s.direction, 0.6 * kStep, s.depth, s.slope, part, s.region, stroke, s.weight};
}

bool Tracer::fill(std::int32_t part, const SurfacePoint& point, Vec3 previous,
                  StrokeSample& out) const {
  const Frame frame = picture_.surface(part).frame(point);
  const auto cross = picture_.field.cross({part, point, frame});
  if (!cross) return false;
  const Vec3 own = family_direction(*cross, family_);
  const Vec3 direction = previous == Vec3(0) ? own : direction_along(*cross, previous);
  out.own = std::abs(glm::dot(own, direction)) > kOwnDirection;
  out.tangent = direction;
  const Vec2 v = picture_.camera.velocity(point.position, out.tangent);
  const double speed = glm::length(v);
  out.direction = speed > 0 ? v / speed : Vec2(1, 0);
  look_at(picture_, part, point, frame, out);
  return true;
}

bool Tracer::seed(std::int32_t part, const SurfacePoint& point, Vec3 toward,
                  StrokeSample& out) const {
  return fill(part, point, toward, out) && may_begin(picture_, out);
}

bool Tracer::seed_along(std::int32_t part, const SurfacePoint& point, Vec2 paper,
                        StrokeSample& out) const {
  if (!seed(part, point, Vec3(0), out)) return false;
  const auto agrees = [&](const StrokeSample& s) {
    return std::abs(glm::dot(s.direction, glm::normalize(paper)));
  };
  if (StrokeSample other; agrees(out) < kOwnDirection &&
                          seed(part, point, glm::cross(out.normal, out.tangent), other) &&
                          agrees(other) > kOwnDirection) {
    out = other;
  }
  if (glm::dot(out.direction, paper) < 0) {
    out.direction = -out.direction;
    out.tangent = -out.tangent;
  }
  return true;
}

// What a stroke from a seed keeps: the field's level, where it runs along a level line.
std::optional<double> Tracer::level_kept(std::int32_t part, const StrokeSample& seed) const {
  const auto level = picture_.level(part, seed.point, picture_.surface(part).frame(seed.point));
  if (!level) return std::nullopt;
  const double climb = std::abs(glm::dot(seed.tangent, level->gradient));
  if (climb > kAlongLevel * glm::length(level->gradient)) return std::nullopt;
  if (!(picture_.level_step > 0)) return level->value;
  return picture_.level_step * std::round(level->value / picture_.level_step);
}

// Brings the end of a step of some length back to the level that its stroke keeps, by Newton's
// method: near outlines steps are long on the surface, and errors add up. False where the level
// cannot be kept: its line turns more sharply than steps can follow.
bool Tracer::keep_level(std::int32_t part, double level, double length, MarchStep& step) const {
  constexpr int kMost = 4;
  const Surface& surface = picture_.surface(part);
  for (int i = 0; i < kMost; ++i) {
    const Frame frame = surface.frame(step.end);
    const auto here = picture_.level(part, step.end, frame);
    if (!here) return true;
    const double slope = glm::length(here->gradient), off = (level - here->value) / slope;
    if (std::abs(off) < kLeastOff * length) return true;
    if (!(std::abs(off) < kMostOff * length)) return false;
    const MarchStep back = surface.march(step.end, off / slope * here->gradient, std::abs(off));
    if (back.stop != MarchStop::Completed) return true;
    step.direction = transport(step.direction, frame.normal, surface.frame(back.end).normal);
    step.end = back.end;
  }
  return true;
}

// Turns a step that ends at an edge of the surface until it ends there on the level: moved along
// the level's gradient its end would leave the edge.
void Tracer::aim(std::int32_t part, const SurfacePoint& from, Vec3 tangent, double level,
                 double length, MarchStep& step) const {
  constexpr int kMost = 4;
  const Surface& surface = picture_.surface(part);
  const Vec3 normal = surface.frame(from).normal;
  MarchStep best = step;
  double least = kMostOff * length;
  for (int i = 0; i < kMost; ++i) {
    const Frame frame = surface.frame(step.end);
    const auto here = picture_.level(part, step.end, frame);
    if (!here) break;
    const double slope = glm::length(here->gradient), off = (level - here->value) / slope;
    if (!(std::abs(off) < least)) break;
    least = std::abs(off);
    best = step;
    if (least < kLeastOff * length || !(step.length > least)) break;
    tangent = glm::normalize(tangent + off / step.length *
                                           transport(here->gradient / slope, frame.normal, normal));
    step = surface.march(from, tangent, length);
    if (step.stop != best.stop) break;
  }
  step = best;
}

// A stroke that went on unseen and did not come out again ends behind what hides it.
StrokeEnd Tracer::extend(std::int32_t part, const StrokeSample& seed, const StrokeWay& way,
                         std::optional<double> level, double sign,
                         std::vector<StrokeSample>& out) const {
  const StrokeEnd end = advance(part, seed, way, level, sign, out);
  // The last sample of a stroke whose surface turns away is not visible for that reason.
  std::size_t seen = out.size() - (end == StrokeEnd::Away ? 1 : 0);
  while (seen > 0 && !out[seen - 1].visible) --seen;
  double tail = 0;
  for (std::size_t i = std::max<std::size_t>(seen, 1); i < out.size(); ++i) {
    tail += glm::length(out[i].paper - out[i - 1].paper);
    if (tail <= kHiddenTail) continue;
    out.resize(i);
    return StrokeEnd::Hidden;
  }
  return end;
}

// Goes straight on from a stroke's last sample to the seam where the families change names, found
// by bisection: the lines of the other side begin there.
void Tracer::end_at_seam(std::int32_t part, const StrokeSample& last,
                         std::vector<StrokeSample>& out) const {
  constexpr int kHalvings = 6;
  const Surface& surface = picture_.surface(part);
  const double length = length_of(picture_.camera, last, kStep);
  std::optional<StrokeSample> end;
  double low = 0, high = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const MarchStep step = surface.march(last.point, last.tangent, middle * length);
    StrokeSample next;
    const bool own =
        step.stop == MarchStop::Completed && fill(part, step.end, step.direction, next) && next.own;
    (own ? low : high) = middle;
    if (!own) continue;
    next.visible = last.visible;
    end = next;
  }
  if (end && glm::distance(end->paper, last.paper) > kLeastStep) out.push_back(*end);
}

StrokeEnd Tracer::advance(std::int32_t part, const StrokeSample& seed, const StrokeWay& way,
                          std::optional<double> level, double sign,
                          std::vector<StrokeSample>& out) const {
  const Surface& surface = picture_.surface(part);
  const Camera& camera = picture_.camera;
  std::optional<Guide> guide;
  if (way.line) guide.emplace(*way.line, way.point, sign > 0 ? 1 : -1);
  double unguided = 0;
  bool unseen_once = false;
  StrokeSample at = seed;
  at.tangent *= sign;
  const StrokeSample start = at;
  double travelled = 0, unseen = 0, foreign = 0;
  std::size_t last_own = 0;
  for (int i = 0; i < kMaxSamples; ++i) {
    const double length = length_of(camera, at, std::min(kStep, way.reach - travelled));
    // Second order: half a step, the direction there, the whole step along it.
    Vec3 tangent = at.tangent;
    const MarchStep half = surface.march(at.point, tangent, 0.5 * length);
    if (half.stop == MarchStop::Completed) {
      const Frame frame = surface.frame(half.end);
      if (const auto cross = picture_.field.cross({part, half.end, frame})) {
        tangent = transport(direction_along(*cross, half.direction), frame.normal, at.normal);
      }
    }
    Guide::Heading heading;
    if (guide) heading = guide->at(at.paper);
    const bool guided = guide && !heading.past;
    // Where a surface turns away, gaps shrink until any line is lost.
    const bool lost = guided && !level && std::abs(heading.off) > kLost * heading.gap;
    if (lost && at.facing > kTurning) return StrokeEnd::Crowded;
    const bool tip = guide && heading.past && heading.inside;
    if (tip && picture_.swells()) return StrokeEnd::Tip;
    const bool steered = guided && !level && !lost;
    if (steered) tangent = steer(picture_, part, at, tangent, heading);
    MarchStep step = surface.march(at.point, tangent, length);
    if (level && step.stop == MarchStop::Completed && !keep_level(part, *level, length, step)) {
      return StrokeEnd::Singular;
    }
    if (level && (step.stop == MarchStop::Crease || step.stop == MarchStop::Boundary)) {
      aim(part, at.point, tangent, *level, length, step);
    }
    if (step.stop == MarchStop::Singular || step.stop == MarchStop::NotConverged) {
      return StrokeEnd::Singular;
    }
    StrokeSample next;
    const bool ends = step.stop != MarchStop::Completed;
    if (!fill(part, step.end, step.direction, next)) return StrokeEnd::Singular;
    if (ends || (steered && !surface.exact() && at.bent)) {
      next.tangent = normalize_or(step.direction, at.tangent);
      const Vec2 v = camera.velocity(next.point.position, next.tangent);
      const double n = glm::length(v);
      if (n > 0) next.direction = v / n;
    }
    if (glm::dot(next.tangent, step.direction) < kMaxTurn * glm::length(step.direction)) {
      return StrokeEnd::Singular;
    }
    // Of an open sheet the other side comes into sight behind the fold.
    if (!next.visible || next.facing < kMinFacing || next.front != at.front) {
      out.push_back(next);
      return StrokeEnd::Away;
    }
    if (!picture_.on_sheet(next.paper)) {
      out.push_back(next);
      return StrokeEnd::Edge;
    }
    const double ds = glm::length(next.paper - at.paper);
    // The families change names along seams of the field. A stroke that ran on there would cross
    // the other side's strokes' way and leave stubs of them.
    foreign = next.own ? 0 : foreign + ds;
    if (foreign == 0) last_own = out.size() + 1;
    if (foreign > kForeign) {
      out.resize(std::min(out.size(), last_own));
      end_at_seam(part, out.empty() ? start : out.back(), out);
      return StrokeEnd::Met;
    }
    if (unseen > 0 || i % static_cast<int>(kProbeEvery) == 0) {
      unseen = picture_.seen(part, next.face, next.paper, next.depth)
                   ? 0
                   : unseen + std::max(ds, 0.1 * kStep);
    }
    next.visible = unseen == 0;
    next.gap = heading.gap;
    unseen_once |= !next.visible;
    if (unseen > kHiddenReach) return StrokeEnd::Hidden;
    if (guide) {
      if (tip && unguided > kDeepestStiff) return StrokeEnd::Crowded;
      unguided = heading.past || lost ? unguided + ds : 0;
      if (unguided > 0 && next.visible) {
        // Its line went on, as far as is known, beside a border that the cells show as stairs.
        const bool known = surface.exact() || !next.bent;
        const bool turning = next.facing < kTurning && next.facing < at.facing + kSameFacing;
        if (lost && !turning) return StrokeEnd::Crowded;
        if (unguided > kUnguided && (!(known || turning) || unseen_once)) return StrokeEnd::Crowded;
        // Lines draw together up to where the surface turns away, and nowhere else.
        const double apart = turning ? kTurningApart * heading.gap
                                     : kApart * std::max(heading.gap, picture_.options.spacing_min);
        if (way.neighbours && way.neighbours->nearest(grid_sample(next, part, -1), apart) < apart) {
          return StrokeEnd::Crowded;
        }
      }
    }
    if (next.visible) {
      if (picture_.share(next.darkness, family_) < way.least_ink) return StrokeEnd::Light;
      const Vec2 gap = next.paper - seed.paper;
      if (travelled > 4 * kStep && next.region == seed.region &&
          std::abs(next.depth - seed.depth) < kStep * seed.slope) {
        if (glm::length(gap) < 0.75 * kStep && glm::dot(next.tangent, sign * seed.tangent) > 0.9) {
          return StrokeEnd::Closed;
        }
      }
    }
    out.push_back(next);
    if (ends) return StrokeEnd::Edge;
    travelled += ds;
    if (travelled > way.reach - kLeastStep) return StrokeEnd::Length;
    at = next;
  }
  return StrokeEnd::Length;
}

std::vector<StrokeSample> Tracer::wedge(const TracedStroke& stroke, StrokeSample tip, double gap,
                                        double least_ink, const SampleGrid& neighbours,
                                        std::int32_t number) const {
  const std::int32_t part = stroke.part;
  const Surface& surface = picture_.surface(part);
  const double none = kClosed * 1.5 * gap;  // farther off a line is no neighbour
  std::vector<StrokeSample> out;
  for (double travelled = 0; travelled < kDeepest * gap; travelled += 0.5 * kStep) {
    const SampleGrid::Sides to = neighbours.sides(grid_sample(tip, part, number), none);
    if (to.left >= none || to.right >= none || to.left + to.right < kClosed * gap ||
        std::min(to.left, to.right) < kTouching * gap) {
      break;
    }
    const double aside = stroke.level ? 0 : 0.5 * (to.left - to.right);
    const double length = length_of(picture_.camera, tip, 0.5 * kStep);
    MarchStep step = surface.march(tip.point, turned_by(picture_, tip, aside), length);
    if (stroke.level && step.stop == MarchStop::Completed &&
        !keep_level(part, *stroke.level, length, step)) {
      break;
    }
    StrokeSample next;
    if (step.stop != MarchStop::Completed || !fill(part, step.end, step.direction, next)) break;
    if (!next.own || !may_begin(picture_, next) || next.region != tip.region ||
        picture_.share(next.darkness, family_) < least_ink ||
        !picture_.seen(part, next.face, next.paper, next.depth)) {
      break;
    }
    out.push_back(next);
    tip = next;
  }
  return out;
}

TracedStroke Tracer::trace(std::int32_t part, const StrokeSample& seed,
                           const StrokeWay& way) const {
  TracedStroke stroke;
  stroke.part = part;
  stroke.family = family_;
  stroke.level = level_kept(part, seed);
  std::vector<StrokeSample> forward, backward;
  stroke.end_reason = extend(part, seed, way, stroke.level, 1, forward);
  if (stroke.end_reason == StrokeEnd::Closed) {
    stroke.closed = true;
    stroke.begin_reason = StrokeEnd::Closed;
  } else {
    stroke.begin_reason = extend(part, seed, way, stroke.level, -1, backward);
    if (stroke.begin_reason == StrokeEnd::Closed) stroke.begin_reason = StrokeEnd::Crowded;
  }
  for (auto it = backward.rbegin(); it != backward.rend(); ++it) {
    it->tangent = -it->tangent;
    it->direction = -it->direction;
    stroke.samples.push_back(*it);
  }
  stroke.samples.push_back(seed);
  stroke.samples.insert(stroke.samples.end(), forward.begin(), forward.end());
  return stroke;
}

}  // namespace burin::detail
