#include "march_path.h"

#include <cmath>

namespace burin::detail {
namespace {

// Squared sine of the angle between the partials from which they span no plane in double
// precision.
constexpr double kParallel = 1e-20;
// A tangent within 1e-9 radians of the normal has no direction in the plane.
constexpr double kAlongNormal = 1e-9;

// A geodesic has no acceleration in the tangent plane: Su u'' + Sv v'' cancels the tangent part of
// the second derivative along the path. @cite doCarmo1976
bool geodesic_acceleration(const SurfaceDerivatives& d, Vec2 w, Vec2& acceleration) {
  const Vec3 q = (w.x * w.x) * d.uu + (2 * w.x * w.y) * d.uv + (w.y * w.y) * d.vv;
  const double e = glm::dot(d.u, d.u), f = glm::dot(d.u, d.v), g = glm::dot(d.v, d.v);
  const double det = e * g - f * f;
  if (!(det > kParallel * e * g)) return false;
  const double a = -glm::dot(d.u, q), b = -glm::dot(d.v, q);
  acceleration = Vec2(g * a - f * b, e * b - f * a) / det;
  return true;
}

}  // namespace

bool GeodesicPath::start(Vec2 uv, Vec3 tangent, PathState& state) const {
  state.uv = uv;
  state.s = derivatives(uv);
  const Vec3 across = glm::cross(state.s.u, state.s.v);
  const double area = glm::length(across);
  if (!(area > 0)) return false;
  const Vec3 flat = reject(tangent, across / area);
  const double length = glm::length(flat);
  if (!(length > kAlongNormal * glm::length(tangent))) return false;
  return tangent_components(state.s, flat / length, state.velocity) &&
         geodesic_acceleration(state.s, state.velocity, state.acceleration);
}

bool GeodesicPath::step(const PathState& from, double h, PathState& to, PathError& error) const {
  const Vec2 w1 = from.velocity, a1 = from.acceleration;
  Vec2 a2, a3, a4;
  const Vec2 w2 = w1 + 0.5 * h * a1;
  if (!geodesic_acceleration(derivatives(from.uv + 0.5 * h * w1), w2, a2)) {
    return false;
  }
  const Vec2 w3 = w1 + 0.5 * h * a2;
  if (!geodesic_acceleration(derivatives(from.uv + 0.5 * h * w2), w3, a3)) {
    return false;
  }
  const Vec2 w4 = w1 + h * a3;
  if (!geodesic_acceleration(derivatives(from.uv + h * w3), w4, a4)) return false;
  to.uv = from.uv + h / 6 * (w1 + 2.0 * (w2 + w3) + w4);
  to.velocity = w1 + h / 6 * (a1 + 2.0 * (a2 + a3) + a4);
  to.s = derivatives(to.uv);
  const double speed = glm::length(to.direction());
  if (!(speed > 0)) return false;
  // The speed is constant on a geodesic: what it drifts is error, and it must not add up.
  to.velocity /= speed;
  if (!geodesic_acceleration(to.s, to.velocity, to.acceleration)) return false;
  const Vec2 dw = 0.1 * h * (w4 - to.velocity), da = 0.1 * h * (a4 - to.acceleration);
  error.position = glm::length(dw.x * to.s.u + dw.y * to.s.v);
  error.direction = glm::length(da.x * to.s.u + da.y * to.s.v) + std::abs(speed - 1);
  return std::isfinite(error.position) && std::isfinite(error.direction);
}

bool GeodesicPath::short_step(const PathState& from, double h, double distance,
                              PathState& to) const {
  const Vec2 w = from.velocity, a = from.acceleration;
  const Vec2 predicted = w + h * a;
  const Vec2 uv = from.uv + h * w + (0.5 * h * h) * a;
  to.s = derivatives(uv);
  if (!geodesic_acceleration(to.s, predicted, to.acceleration)) return false;
  const Vec2 change = to.acceleration - a, shift = h * h / 6 * change;
  // What the correction leaves open is smaller than itself by about the share by which the
  // geometry changes over the step.
  const auto share = [](Vec3 x, Vec3 y) { return glm::length(x - y) / glm::length(x); };
  const Vec2 bend = h * a;
  const double rate = share(from.s.u, to.s.u) + share(from.s.v, to.s.v) +
                      glm::length(bend.x * from.s.u + bend.y * from.s.v);
  const double left_open = rate * glm::length(shift.x * to.s.u + shift.y * to.s.v);
  // A quarter: the error is h^4 k^3 / 24, this h^3 k^2 / 6 times a rate of some 3 h k.
  if (!(0.25 * left_open <= distance)) return false;
  to.uv = uv + shift;
  to.velocity = w + (0.5 * h) * (a + to.acceleration);
  // S at the corrected place by its Taylor series: the shift is of the third order, what is left
  // out of the ninth.
  SurfaceDerivatives& s = to.s;
  s.p += shift.x * s.u + shift.y * s.v + (0.5 * shift.x * shift.x) * s.uu +
         (shift.x * shift.y) * s.uv + (0.5 * shift.y * shift.y) * s.vv;
  s.u += shift.x * s.uu + shift.y * s.uv;
  s.v += shift.x * s.uv + shift.y * s.vv;
  const double speed = glm::length(to.direction());
  to.velocity /= speed;
  return speed > 0 && std::isfinite(speed);
}

Vec2 between(const PathState& from, const PathState& to, double length, double gone) {
  const double x = gone / length, y = 1 - x;
  return (y * y * (1 + 2 * x)) * from.uv + (x * x * (1 + 2 * y)) * to.uv +
         (x * y * length) * (y * from.velocity - x * to.velocity);
}

}  // namespace burin::detail
