#include <burin/field/field.h>

#include "fallback.h"

#include <algorithm>
#include <cmath>

namespace burin::field {
namespace {

// Share of what the surface's bending could change the angle by (of 1/distance in perspective, too)
// below which the angle stands still: about half a degree around the places where it is largest or
// smallest. Strokes cannot follow its level lines there, which close around the place.
constexpr double kStill = 0.01;

/// How the cosine between normal and a direction changes along the surface.
struct Slope {
  double cosine = 0;
  Vec3 gradient{0};  // 1 / model mm, tangent
  double most = 0;   // what its length could be with the surface bent as it is
};
using SlopeFn = std::function<Slope(const SurfacePoint&, const Frame&)>;

// d(n.v)/dt = (dn/dt).v, and dn/dt = k1 (t.d1) d1 + k2 (t.d2) d2 (k positive on a sphere whose
// normals point outward).
Vec3 bending(const Frame& f, Vec3 v) {
  return f.k1 * glm::dot(v, f.d1) * f.d1 + f.k2 * glm::dot(v, f.d2) * f.d2;
}

double sharpest(const Frame& f) { return std::max(std::abs(f.k1), std::abs(f.k2)); }

SlopeFn from_direction(Vec3 direction) {
  const Vec3 v = normalize_or(direction, Vec3(0, 0, 1));
  return [v](const SurfacePoint&, const Frame& f) {
    return Slope{glm::dot(f.normal, v), bending(f, v), sharpest(f)};
  };
}

// In perspective the direction to the viewer changes too: dv/dt = -(t - v (t.v)) / distance.
SlopeFn from_viewer(const Camera& camera) {
  if (!camera.perspective()) return from_direction(camera.direction());
  return [camera](const SurfacePoint& p, const Frame& f) {
    const Vec3 v = camera.to_viewer(p.position);
    const double nearness = 1 / camera.distance_to_viewer(p.position);
    const double cosine = glm::dot(f.normal, v);
    const Vec3 turning = nearness * cosine * reject(v, f.normal);
    return Slope{cosine, bending(f, v) + turning, sharpest(f) + nearness};
  };
}

// The arms of a cross, or the one that goes on.
Vec3 arm(const FieldQuery& q, Vec3 first) {
  const Vec3 second = glm::cross(q.frame.normal, first);
  if (q.previous == Vec3(0)) return q.family == 2 ? second : first;
  const double a = glm::dot(first, q.previous), b = glm::dot(second, q.previous);
  const Vec3 d = std::abs(b) > std::abs(a) ? second : first;
  return (std::abs(b) > std::abs(a) ? b : a) < 0 ? -d : d;
}

Field angle_field(const char* name, const SlopeFn& slope, const AngleOptions& options,
                  bool across) {
  const auto direction = [=](const FieldQuery& q) -> std::optional<Vec3> {
    const Frame& f = q.frame;
    const Slope s = slope(q.point, f);
    const double size = glm::length(s.gradient);
    if (s.most <= options.flat) return arm(q, fallback_tangent(options.fallback, f.normal));
    if (!(size > kStill * s.most)) return std::nullopt;
    const Vec3 steepest = s.gradient / size;
    return arm(q, across ? steepest : glm::cross(f.normal, steepest));
  };
  const auto certainty = [=](const FieldQuery& q) {
    const Slope s = slope(q.point, q.frame);
    return s.most > options.flat ? std::min(1.0, glm::length(s.gradient) / s.most) : 0.0;
  };
  const auto level = [=](const SurfacePoint& p, const Frame& f) -> std::optional<Level> {
    const Slope s = slope(p, f);
    if (s.most <= options.flat || !(glm::length(s.gradient) > kStill * s.most)) return std::nullopt;
    return Level{s.cosine, s.gradient};
  };
  return {name, direction, certainty, level};
}

}  // namespace

Field isophote(const Camera& camera, const AngleOptions& options) {
  return angle_field("isophote", from_viewer(camera), options, false);
}

Field isophote(Vec3 light, const AngleOptions& options) {
  return angle_field("isophote-light", from_direction(light), options, false);
}

Field steepest(const Camera& camera, const AngleOptions& options) {
  return angle_field("steepest", from_viewer(camera), options, true);
}

}  // namespace burin::field
