#include "revolution.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin::recognised {
namespace {

// Difference of curvatures against their sum below which there are no directions.
constexpr double kUmbilic = 1e-6;
// Cosine: ends of an edge that are farther apart around the axis are at a tip.
constexpr double kNear = 0.5;
// Of an edge: its ends are on one circle around the axis up to so much of it.
constexpr double kRim = 1e-3;
// A slope of the profile's end over its chord: steeper ones are no graph to speak of.
constexpr double kSteepest = 1.0;

}  // namespace

Vec3 Axis::outward(Vec3 p) const {
  const Vec3 d = p - origin;
  const Vec3 out = d - glm::dot(d, direction) * direction;
  const double r = glm::length(out);
  // Nearer than rounding to the axis.
  return r > 1e-14 * (glm::length(d) + 1e-300) ? out / r : any_orthogonal(direction);
}

Patch::Foot Patch::foot(Vec2 rh) const {
  Foot f;
  if (profile == Profile::Circle) {
    const Vec2 v = rh - middle;
    const double away = glm::length(v);
    const Vec2 out = away > 0 ? v / away : Vec2(1, 0);
    f.point = middle + std::abs(radius) * out;
    f.normal = radius > 0 ? out : -out;
    f.curvature = 1 / radius;
    return f;
  }
  f.normal = normal;
  f.point = rh - (glm::dot(normal, rh) - offset) * normal;
  if (profile == Profile::Line) return f;
  const double x = glm::dot(f.point - start, along());
  const double s = std::clamp(x / length, -0.25, 1.25);
  const double m0 = std::clamp(slope0, -kSteepest, kSteepest),
               m1 = std::clamp(slope1, -kSteepest, kSteepest);
  // Hermite: 0 at both ends with slopes m0 and m1.
  const double y = length * (m0 * s * (s - 1) * (s - 1) + m1 * s * s * (s - 1));
  const double dy = m0 * (1 - s) * (1 - 3 * s) + m1 * s * (3 * s - 2);
  const double ddy = (m0 * (6 * s - 4) + m1 * (6 * s - 2)) / length;
  const double g = std::sqrt(1 + dy * dy);
  f.point += y * normal;
  f.normal = (normal - dy * along()) / g;
  f.curvature = -ddy / (g * g * g);
  return f;
}

Vec3 Patch::project(Vec3 p) const {
  if (sheet) return nearest(p).p;
  const Foot f = foot(axis.profile(p));
  return axis.origin + f.point.x * axis.outward(p) + f.point.y * axis.direction;
}

Vec3 Patch::halfway(Vec3 a, Vec3 b) const {
  const Vec3 chord = 0.5 * (a + b);
  const Vec2 from = axis.profile(a), to = axis.profile(b);
  const bool straight =
      profile == Profile::Line || glm::distance(from, to) <= kRim * glm::distance(a, b);
  const bool near = glm::dot(axis.outward(a), axis.outward(b)) > kNear;
  if (kind == FaceKind::Sphere || !straight || !near) return project(chord);
  const Vec2 rh = foot(0.5 * (from + to)).point;
  return axis.origin + rh.x * axis.outward(chord) + rh.y * axis.direction;
}

double Patch::distance(Vec3 p, Vec3& normal_there) const {
  if (sheet) {
    const SurfaceDerivatives d = nearest(p);
    normal_there = outward(d);
    return glm::dot(p - d.p, normal_there);
  }
  const Vec2 rh = axis.profile(p);
  const Foot f = foot(rh);
  normal_there = f.normal.x * axis.outward(p) + f.normal.y * axis.direction;
  return glm::dot(rh - f.point, f.normal);
}

Vec3 Patch::normal_at(Vec3 p) const {
  if (sheet) return outward(nearest(p));
  const Foot f = foot(axis.profile(p));
  return f.normal.x * axis.outward(p) + f.normal.y * axis.direction;
}

Vec3 Patch::outward(const SurfaceDerivatives& d) const {
  return side * normalize_or(glm::cross(d.u, d.v), Vec3(0));
}

Frame Patch::frame(Vec3 p) const {
  if (sheet) {
    const SurfaceDerivatives d = nearest(p);
    Frame frame = chart_frame(d, outward(d), kind, sheet->size());
    frame.position = p;
    return frame;
  }
  const Foot f = foot(axis.profile(p));
  const Vec3 out = axis.outward(p);
  Frame frame;
  frame.position = p;
  frame.kind = kind;
  frame.normal = f.normal.x * out + f.normal.y * axis.direction;
  const Vec3 around = glm::cross(axis.direction, out);
  const Vec3 along_profile = glm::cross(frame.normal, around);
  const double round = f.point.x > 0 ? f.normal.x / f.point.x : f.curvature;
  const bool around_first = round >= f.curvature;
  frame.k1 = std::max(round, f.curvature);
  frame.k2 = std::min(round, f.curvature);
  frame.d1 = around_first ? around : along_profile;
  frame.d2 = glm::cross(frame.normal, frame.d1);
  const double sum = std::abs(frame.k1) + std::abs(frame.k2);
  frame.confidence = sum > 0 ? (frame.k1 - frame.k2) / sum : 0;
  frame.umbilic = frame.confidence < kUmbilic;
  if (frame.umbilic) frame.confidence = 0;
  return frame;
}

Patch patch_on(std::shared_ptr<const Sheet> sheet, const GridWindow& window) {
  Patch p;
  p.profile = Patch::Profile::Sheet;
  p.sagitta = sheet->sagitta();
  p.turn = sheet->turn();
  p.sheet = std::move(sheet);
  p.window = window;
  return p;
}

}  // namespace burin::recognised
