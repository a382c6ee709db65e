#include <burin/forms/charted/chart.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

// Sine of the angle between the partials, or ratio of their lengths, below which the second
// derivatives tell the normal better: rounding of 1e-16 over this and the next order agree in size.
constexpr double kDegenerate = 1e-8;

/// `n` as a unit vector, zero where it is but rounding against the products it was made of.
Vec3 significant(Vec3 n, double scale) {
  return glm::length(n) > 1e-10 * scale ? normalize_or(n, Vec3(0)) : Vec3(0);
}

/// Su x Sv a step (h, k) away: the terms of the first order in the step, or else of the second.
Vec3 limit_normal(const SurfaceDerivatives& d, double h, double k) {
  const Vec3 du = h * d.uu + k * d.uv, dv = h * d.uv + k * d.vv;
  const double lu = glm::length(d.u), lv = glm::length(d.v), ldu = glm::length(du),
               ldv = glm::length(dv);
  // A partial that vanished next to the other one is rounding: it must not turn the limit.
  const Vec3 u = lu > kDegenerate * lv ? d.u : Vec3(0), v = lv > kDegenerate * lu ? d.v : Vec3(0);
  const Vec3 first = significant(glm::cross(du, v) + glm::cross(u, dv), ldu * lv + lu * ldv);
  if (first != Vec3(0)) return first;
  const bool both_vanish = std::max(lu, lv) <= kDegenerate * std::max(ldu, ldv);
  return both_vanish ? significant(glm::cross(du, dv), ldu * ldv) : Vec3(0);
}

struct Matrix2 {  // symmetric
  double a, b, c;
};

/// The second fundamental form in an orthonormal tangent basis (e1 along Su, e2 = n x e1), positive
/// where the surface bends away from the normal.
Matrix2 shape_operator(const SurfaceDerivatives& d, Vec3 n, Vec3 e1, Vec3 e2) {
  const double su = glm::length(d.u), v1 = glm::dot(d.v, e1), v2 = glm::dot(d.v, e2);
  const double l = -glm::dot(d.uu, n), m = -glm::dot(d.uv, n), q = -glm::dot(d.vv, n);
  Matrix2 w;
  w.a = l / (su * su);
  w.b = (m / su - w.a * v1) / v2;
  w.c = (q - v1 * (w.a * v1 + 2 * w.b * v2)) / (v2 * v2);
  return w;
}

}  // namespace

Vec3 chart_normal(const SurfaceDerivatives& d, bool reversed, Vec2 uv, Vec2 domain_center) {
  const double sign = reversed ? -1 : 1;
  const Vec3 n = glm::cross(d.u, d.v);
  const double lu = glm::length(d.u), lv = glm::length(d.v), area = glm::length(n);
  if (area > kDegenerate * lu * lv && std::min(lu, lv) > kDegenerate * std::max(lu, lv)) {
    return sign / area * n;
  }
  // The limit from inside: a step into the domain.
  const double h = domain_center.x >= uv.x ? 1 : -1, k = domain_center.y >= uv.y ? 1 : -1;
  return sign * limit_normal(d, h, k);
}

Frame chart_frame(const SurfaceDerivatives& d, Vec3 unit_normal, FaceKind kind, double size) {
  Frame f;
  f.position = d.p;
  f.normal = unit_normal;
  f.du = d.u;
  f.dv = d.v;
  f.kind = kind;
  const double lu = glm::length(d.u), lv = glm::length(d.v);
  const double area = glm::length(glm::cross(d.u, d.v));
  const bool regular = area > kDegenerate * lu * lv &&
                       std::min(lu, lv) > kDegenerate * std::max(lu, lv) && unit_normal != Vec3(0);
  if (!regular || kind == FaceKind::Plane) {
    const Vec3 n = unit_normal == Vec3(0) ? Vec3(0, 0, 1) : unit_normal;
    f.d1 = normalize_or(lu > kDegenerate * lv ? reject(d.u, n) : Vec3(0), any_orthogonal(n));
    f.d2 = glm::cross(n, f.d1);
    return f;
  }
  const Vec3 e1 = d.u / lu, e2 = glm::cross(unit_normal, e1);
  const Matrix2 w = shape_operator(d, unit_normal, e1, e2);
  const double mean = 0.5 * (w.a + w.c), half = 0.5 * (w.a - w.c);
  const double deviator = std::sqrt(half * half + w.b * w.b);
  f.k1 = mean + deviator;
  f.k2 = mean - deviator;
  // cos and sin of half the angle of (half, b), by the root that does not cancel.
  double c = std::sqrt(0.5 * (deviator + std::abs(half))), s = 0.5 * std::abs(w.b) / c;
  if (!(c > 0)) c = 1, s = 0;
  if (half < 0) std::swap(c, s);
  const Vec3 d1 = c * e1 + (w.b < 0 ? -s : s) * e2;
  f.d1 = normalize_or(d1, e1);
  f.d2 = glm::cross(unit_normal, f.d1);
  const double flat = 1e-3 / size;
  if (std::abs(f.k1) < flat) f.k1 = 0;
  if (std::abs(f.k2) < flat) f.k2 = 0;
  const double difference = f.k1 - f.k2, sum = std::abs(f.k1) + std::abs(f.k2);
  // A millionth: what rounding leaves of the difference on a sphere of many spans.
  f.umbilic = kind == FaceKind::Sphere || (f.k1 == 0 && f.k2 == 0) || difference <= 1e-6 * sum;
  if (!f.umbilic) f.confidence = difference / sum;
  return f;
}

bool tangent_components(const SurfaceDerivatives& d, Vec3 tangent, Vec2& components) {
  const Vec3 n = glm::cross(d.u, d.v);
  const double area = glm::length(n);
  if (!(area > 1e-10 * glm::length(d.u) * glm::length(d.v))) return false;
  const Vec3 size = glm::abs(n);
  const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int i = (drop + 1) % 3, j = (drop + 2) % 3;
  // The determinant of the two rows is the component of the normal that was dropped.
  components =
      Vec2(tangent[i] * d.v[j] - tangent[j] * d.v[i], d.u[i] * tangent[j] - d.u[j] * tangent[i]) /
      n[drop];
  return true;
}

}  // namespace burin
