#include <burin/forms/parametric/chart.h>

#include <cmath>

namespace burin {
namespace {

// Sine of the angle between the partials, or ratio of their lengths, below which double precision
// leaves no digits of the normal's direction that second derivatives would not give better.
constexpr double kDegenerate = 1e-10;

Vec3 unit_or_zero(Vec3 v) { return normalize_or(v, Vec3(0)); }

}  // namespace

Vec3 chart_normal(const SurfaceDerivatives& d, bool reversed, Vec2 uv, Vec2 domain_center) {
  const double sign = reversed ? -1 : 1;
  const Vec3 n = glm::cross(d.u, d.v);
  const double lu = glm::length(d.u), lv = glm::length(d.v);
  if (glm::length(n) > kDegenerate * lu * lv && std::min(lu, lv) > kDegenerate * std::max(lu, lv)) {
    return sign * unit_or_zero(n);
  }
  // The limit from inside: along a step (du, dv) into the domain Su grows by Suu du + Suv dv.
  const double du = domain_center.x >= uv.x ? 1 : -1, dv = domain_center.y >= uv.y ? 1 : -1;
  Vec3 limit(0);
  if (lu <= kDegenerate * lv) {
    limit = glm::cross(d.uv, d.v) * dv;
  } else if (lv <= kDegenerate * lu) {
    limit = glm::cross(d.u, d.uv) * du;
  }
  return sign * unit_or_zero(limit);
}

}  // namespace burin
