#include "guide.h"

#include "tracer.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace burin::detail {
namespace {

constexpr double kAhead = 0.8;  // paper mm: where a stroke aims

// A stroke on an exact form turns off the field by no more than this to keep to its level line; on
// a face of which everybody knows how lines run, only where it would be lost.
constexpr double kMostTurn = 6 * std::numbers::pi / 180;
constexpr double kFree = 0.2;  // gaps that it may be off there
// Cosines: where a surface is slanted more than the first a level line says nothing of the way on
// it (a hair on paper is many degrees there), and all where it is seen squarer than the second.
constexpr double kSlantedLevel = 0.2, kSquareLevel = 0.5;
constexpr double kEdgeOn = 0.02;  // ... and no direction on paper anything of one on the surface
// Gaps off its level line from which on a stroke turns back to it all the same, the more the nearer
// it is to being lost.
constexpr double kNearlyLost = 0.3;
constexpr double kTurnOver = 0.8;  // paper mm over which it would be back
constexpr double kCloseOver = 3;   // ... where it is to fill the place of one that ended

// A tangent of the surface, and how it and the direction to its left show on paper.
struct Shown {
  Vec3 tangent, left;
  Vec2 t, b;
  double area;

  Shown(const Picture& picture, const StrokeSample& at, Vec3 along)
      : tangent(along),
        left(glm::cross(at.normal, along)),
        t(picture.camera.velocity(at.point.position, tangent)),
        b(picture.camera.velocity(at.point.position, left)),
        area(cross2(t, b)) {}

  // Turned to the left as seen on paper by so many radians on the surface, or as many as allowed.
  Vec3 turned(double by) const {
    const double turn = std::clamp(by, -kMostTurn, kMostTurn);
    return std::cos(turn) * tangent + (area < 0 ? -1.0 : 1.0) * std::sin(turn) * left;
  }
  // What shows as a direction on paper.
  Vec3 showing(Vec2 ahead) const {
    return cross2(ahead, b) / area * tangent + cross2(t, ahead) / area * left;
  }
};

}  // namespace

Guide::Heading Guide::at(Vec2 paper) {
  const std::vector<Vec2>& p = line_->points;
  Heading out;
  if (last(at_)) {  // a line whose end is its start
    out.past = true;
    out.inside = way_ > 0 ? line_->end_inside : line_->begin_inside;
    return out;
  }
  double along = 0;
  Vec2 step{0};
  // Once around a closed line at the most.
  for (std::size_t i = 0; i < size(); ++i) {
    step = p[next(at_)] - p[at_];
    const double square = glm::dot(step, step);
    along = square > 0 ? glm::dot(paper - p[at_], step) / square : 1;
    if (along <= 1 || last(next(at_))) break;
    at_ = next(at_);
  }
  const double length = glm::length(step);
  const Vec2 unit = length > 0 ? step / length : Vec2(1, 0);
  out.off = cross2(unit, paper - p[at_]);
  out.gap = line_->gaps[at_];
  out.beside_end = line_->beside_end;
  out.past = along > 1 && last(next(at_));
  out.inside = way_ > 0 ? line_->end_inside : line_->begin_inside;
  // The place ahead, on the line or on its last step drawn out.
  double left = kAhead + std::max(0.0, along) * length;
  std::size_t i = at_;
  Vec2 target = p[i];
  while (true) {
    const Vec2 s = p[next(i)] - p[i];
    const double n = glm::length(s);
    if (n >= left || last(next(i))) {
      target = p[i] + (n > 0 ? left / n : 0) * s;
      break;
    }
    left -= n;
    i = next(i);
    if (i == at_) {
      target = p[i];
      break;
    }
  }
  const Vec2 way = target - paper;
  const double n = glm::length(way);
  out.ahead = n > 0 ? way / n : unit;
  return out;
}

Vec3 turned_by(const Picture& picture, const StrokeSample& at, double left) {
  return Shown(picture, at, at.tangent).turned(left / kTurnOver);
}

Vec3 steer(const Picture& picture, std::int32_t part, const StrokeSample& at, Vec3 tangent,
           const Guide::Heading& heading) {
  const Shown shown(picture, at, tangent);
  if (ruled(at.kind) || !at.bent) {
    const double free = kFree * heading.gap;
    const double off = heading.off - std::clamp(heading.off, -free, free);
    const double closing = heading.beside_end * (heading.off - off) / kCloseOver;
    return shown.turned(-off / kTurnOver - closing);
  }
  const double scale = picture.camera.scale_at(at.point.position);
  const bool edge_on = std::abs(shown.area) < kEdgeOn * scale * scale;
  const bool exact = picture.surface(part).exact();
  const double lost = (std::abs(heading.off) / heading.gap - kNearlyLost) / (kLost - kNearlyLost);
  const double trust = std::clamp(
      std::max((at.facing - kSlantedLevel) / (kSquareLevel - kSlantedLevel), lost), 0.0, 1.0);
  if (edge_on || (trust == 0 && !exact)) return shown.turned(-heading.off / kTurnOver);
  const Vec3 along = normalize_or(shown.showing(heading.ahead), tangent);
  if (exact) {
    const double angle = std::atan2(glm::dot(along, shown.left), glm::dot(along, tangent));
    return shown.turned(shown.area < 0 ? -angle : angle);
  }
  const Vec3 field = shown.turned(-heading.off / kTurnOver);
  return normalize_or(trust * along + (1 - trust) * field, tangent);
}

std::optional<Vec2> border_normal(const Picture& picture, const TracedStroke& stroke, bool begin) {
  const StrokeEnd reason = begin ? stroke.begin_reason : stroke.end_reason;
  const StrokeSample& at = begin ? stroke.samples.front() : stroke.samples.back();
  const Camera& camera = picture.camera;
  const auto unit = [](Vec2 v) {
    const double n = glm::length(v);
    return n > 0 ? std::optional(v / n) : std::nullopt;
  };
  if (reason == StrokeEnd::Away) return unit(camera.velocity(at.point.position, at.normal));
  if (reason != StrokeEnd::Edge) return std::nullopt;
  const ProxyMesh& proxy = picture.surface(stroke.part).proxy();
  const Triangle& corners = proxy.mesh.triangles[at.face];
  std::optional<Vec2> found;
  double least = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < 3; ++k) {
    if (proxy.edge_kind[3 * std::size_t{at.face} + k] == EdgeKind::Smooth) continue;
    const Vec2 a = camera.to_paper(proxy.mesh.positions[corners[k]]),
               b = camera.to_paper(proxy.mesh.positions[corners[(k + 1) % 3]]);
    const auto across = unit({a.y - b.y, b.x - a.x});
    if (!across) continue;
    const double off = std::abs(glm::dot(*across, at.paper - a));
    if (off < least) least = off, found = across;
  }
  return found;
}

}  // namespace burin::detail
