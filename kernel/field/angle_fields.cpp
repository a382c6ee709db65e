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

Field angle_field(const char* name, const SlopeFn& slope, const AngleOptions& options,
                  bool across) {
  return {name, [=](const FieldQuery& q) -> std::optional<Cross> {
            const Vec3 n = q.frame.normal;
            const Slope s = slope(q.point, q.frame);
            const double size = glm::length(s.gradient);
            if (s.most <= options.flat) {
              const Vec3 t = fallback_tangent(options.fallback, n);
              return Cross{t, glm::cross(n, t), 0};
            }
            if (!(size > kStill * s.most)) return std::nullopt;
            const Vec3 steepest = s.gradient / size;
            const Vec3 first = across ? steepest : glm::cross(n, steepest);
            return Cross{first, glm::cross(n, first), std::min(1.0, size / s.most),
                         Level{s.cosine, s.gradient, Vec3(0)}};
          }};
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
