// The vocabulary of solids.

#include <burin/base/box_corners.h>
#include <burin/base/error.h>
#include <burin/base/placement.h>

#include "node.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::implicit {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
void positive(const char* what, double v) {
  if (!(v > 0 && v < 1e12)) {
    throw UsageError(fmt::format("{} has to be a number over 0 and below 1e12, not {}", what, v));
  }
}

void finite(const char* what, double v) {
  if (!std::isfinite(v)) throw UsageError(fmt::format("{} has to be a finite number", what));
}

Box3 around(Vec3 half) { return {-half, half}; }
Box3 grown(Box3 b, double d) { return {b.min - d, b.max + d}; }

Box3 hull_of_boxes(Box3 a, const Box3& b) {
  a.add(b);
  return a;
}

// Two boxes that do not meet leave a box without points.
Box3 common(const Box3& a, const Box3& b) {
  return {glm::max(a.min, b.min), glm::min(a.max, b.max)};
}

bool is_finite(const Box3& b) {
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(b.min[i]) || !std::isfinite(b.max[i])) return false;
  }
  return true;
}

Box3 turned(const Box3& b, const Mat3& m) {
  if (!is_finite(b)) return ImplicitFunction::everywhere();
  if (b.empty()) return b;
  Box3 out;
  for (const Vec3& corner : corners_of(b)) out.add(m * corner);
  return out;
}

// `f` at the point m * p.
Expression mapped(const Expression& f, const Mat3& m) {
  const auto row = [&](int i) {
    return m[0][i] * Expression::x() + m[1][i] * Expression::y() + m[2][i] * Expression::z();
  };
  return substitute(f, row(0), row(1), row(2));
}

Expression length(const Expression& a, const Expression& b) { return sqrt(square(a) + square(b)); }

Expression axis_distance() { return length(Expression::x(), Expression::y()); }
Expression max0(const Expression& a) { return max(a, 0.0); }

}  // namespace

Expression sphere(double r) {
  positive("the radius of a sphere", r);
  const Expression d =
      sqrt(square(Expression::x()) + square(Expression::y()) + square(Expression::z()));
  return with_bounds(d - r, around(Vec3(r)));
}

Expression box(double sx, double sy, double sz) {
  for (const double s : {sx, sy, sz}) positive("the size of a box", s);
  const Expression qx = abs(Expression::x()) - 0.5 * sx, qy = abs(Expression::y()) - 0.5 * sy,
                   qz = abs(Expression::z()) - 0.5 * sz;
  return with_bounds(max(max(qx, qy), qz), around(0.5 * Vec3(sx, sy, sz)));
}

Expression round_box(double sx, double sy, double sz, double r) {
  for (const double s : {sx, sy, sz}) positive("the size of a box", s);
  positive("the radius of a box's edges", r);
  if (2 * r > std::min({sx, sy, sz})) {
    throw UsageError("the radius of a box's edges is more than half of its size");
  }
  const Expression qx = abs(Expression::x()) - (0.5 * sx - r),
                   qy = abs(Expression::y()) - (0.5 * sy - r),
                   qz = abs(Expression::z()) - (0.5 * sz - r);
  const Expression outside = sqrt(square(max0(qx)) + square(max0(qy)) + square(max0(qz)));
  const Expression inside = min(max(max(qx, qy), qz), 0.0);
  return with_bounds(outside + inside - r, around(0.5 * Vec3(sx, sy, sz)));
}

Expression cylinder(double r, double h) {
  positive("the radius of a cylinder", r);
  positive("the height of a cylinder", h);
  return with_bounds(max(axis_distance() - r, abs(Expression::z()) - 0.5 * h),
                     around({r, r, 0.5 * h}));
}

Expression cone(double r1, double r2, double h) {
  positive("the height of a cone", h);
  finite("the radius of a cone", r1);
  finite("the radius of a cone", r2);
  if (r1 < 0 || r2 < 0 || r1 + r2 == 0) {
    throw UsageError("the radii of a cone have to be 0 or more, one of them over 0");
  }
  // Steepness 1 at a right angle to the side.
  const double slope = (r2 - r1) / h, cosine = 1 / std::sqrt(1 + slope * slope);
  const Expression radius = 0.5 * (r1 + r2) + slope * Expression::z();
  const double r = std::max(r1, r2);
  return with_bounds(max((axis_distance() - radius) * cosine, abs(Expression::z()) - 0.5 * h),
                     around({r, r, 0.5 * h}));
}

Expression torus(double major, double minor) {
  positive("the radius of a torus", major);
  positive("the radius of a torus's tube", minor);
  const double r = major + minor;
  return with_bounds(length(axis_distance() - major, Expression::z()) - minor,
                     around({r, r, minor}));
}

Expression capsule(double r, double h) {
  positive("the radius of a capsule", r);
  positive("the height of a capsule", h);
  const Expression dz = max0(abs(Expression::z()) - 0.5 * h);
  return with_bounds(sqrt(square(Expression::x()) + square(Expression::y()) + square(dz)) - r,
                     around({r, r, 0.5 * h + r}));
}

Expression plane(double nx, double ny, double nz, double d) {
  const double n = std::sqrt(nx * nx + ny * ny + nz * nz);
  positive("the length of a plane's normal", n);
  finite("the distance of a plane", d);
  return (nx / n) * Expression::x() + (ny / n) * Expression::y() + (nz / n) * Expression::z() - d;
}

Expression gyroid(double period, double thickness) {
  positive("the period of a gyroid", period);
  positive("the thickness of a gyroid", thickness);
  const double k = 2 * std::numbers::pi / period;
  const Expression x = k * Expression::x(), y = k * Expression::y(), z = k * Expression::z();
  const Expression g = sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x);
  // The gradient of g on g = 0 lies between 1.22 k and 1.73 k, 1.5 k in the mean.
  return abs(g) * (1 / (1.5 * k)) - 0.5 * thickness;
}

Expression superquadric(double a, double b, double c, double e1, double e2) {
  for (const double s : {a, b, c}) positive("the size of a superquadric", s);
  for (const double e : {e1, e2}) positive("the exponent of a superquadric", e);
  const auto term = [](const Expression& v, double size, double e) {
    return e == 1 ? square(v * (1 / size)) : pow(abs(v) * (1 / size), 2 / e);
  };
  const Expression round = term(Expression::x(), a, e2) + term(Expression::y(), b, e2);
  const Expression sum = (e1 == e2 ? round : pow(round, e2 / e1)) + term(Expression::z(), c, e1);
  // Homogeneous of degree 1, in model mm.
  return with_bounds((pow(sum, 0.5 * e1) - 1.0) * std::min({a, b, c}), around({a, b, c}));
}

Expression blob(double r) {
  positive("the radius of a blob", r);
  return exp(1.0 - (square(Expression::x()) + square(Expression::y()) + square(Expression::z())) *
                       (1 / (r * r)));
}

Expression unite(const Expression& a, const Expression& b) {
  return with_bounds(min(a, b), hull_of_boxes(a.bounds(), b.bounds()));
}
Expression intersect(const Expression& a, const Expression& b) {
  return with_bounds(max(a, b), common(a.bounds(), b.bounds()));
}
Expression subtract(const Expression& a, const Expression& b) {
  return with_bounds(max(a, -b), a.bounds());
}

Expression smooth_unite(const Expression& a, const Expression& b, double radius) {
  positive("the radius of a blend", radius);
  const Expression f = max(min(a, b), radius) - length(max0(radius - a), max0(radius - b));
  // The fillet fills the corner between both: it stays inside the hull where both are convex, and
  // within the radius of them in any case.
  return with_bounds(f, grown(hull_of_boxes(a.bounds(), b.bounds()), radius));
}
Expression smooth_intersect(const Expression& a, const Expression& b, double radius) {
  return with_bounds(-smooth_unite(-a, -b, radius), common(a.bounds(), b.bounds()));
}
Expression smooth_subtract(const Expression& a, const Expression& b, double radius) {
  return with_bounds(-smooth_unite(-a, b, radius), a.bounds());
}

Expression translate(const Expression& f, Vec3 by) {
  for (int i = 0; i < 3; ++i) finite("a translation", by[i]);
  const Expression moved =
      substitute(f, Expression::x() - by.x, Expression::y() - by.y, Expression::z() - by.z);
  const Box3 b = f.bounds();
  return with_bounds(moved, {b.min + by, b.max + by});
}

Expression rotate(const Expression& f, Vec3 degrees) {
  for (int i = 0; i < 3; ++i) finite("an angle", degrees[i]);
  const Mat3 m = rotation(degrees);
  return with_bounds(mapped(f, glm::transpose(m)), turned(f.bounds(), m));
}

Expression scale(const Expression& f, double s) {
  positive("a scale", s);
  const Expression k = 1 / s;
  const Box3 b = f.bounds();
  return with_bounds(
      substitute(f, k * Expression::x(), k * Expression::y(), k * Expression::z()) * s,
      {b.min * s, b.max * s});
}

Expression transform(const Expression& f, const Mat3& linear, Vec3 offset) {
  for (int i = 0; i < 3; ++i) finite("a translation", offset[i]);
  const double volume = std::abs(glm::determinant(linear));
  positive("the factor by which a transformation changes volumes", volume);
  const Mat3 back = glm::inverse(linear);
  double squares = 0;
  for (int i = 0; i < 3; ++i) squares += glm::dot(back[i], back[i]);
  const Expression stood = mapped(f, back) * std::sqrt(3 / squares);
  return translate(with_bounds(stood, turned(f.bounds(), linear)), offset);
}

Expression mirror(const Expression& f, Vec3 normal) {
  const double n = glm::length(normal);
  positive("the length of a mirror's normal", n);
  const Vec3 u = normal / n;
  const Mat3 m = Mat3(1) - 2.0 * glm::outerProduct(u, u);
  return with_bounds(mapped(f, m), turned(f.bounds(), m));
}

Expression shell(const Expression& f, double thickness) {
  positive("the thickness of a shell", thickness);
  return with_bounds(abs(f) - 0.5 * thickness, grown(f.bounds(), 0.5 * thickness));
}

Expression offset(const Expression& f, double d) {
  finite("an offset", d);
  return with_bounds(f - d, grown(f.bounds(), std::max(d, 0.0)));
}

Expression twist(const Expression& f, double degrees_per_mm) {
  finite("a twist", degrees_per_mm);
  const Expression a = (degrees_per_mm * std::numbers::pi / 180) * Expression::z();
  const Expression c = cos(a), s = sin(a);
  const Expression out = substitute(f, c * Expression::x() + s * Expression::y(),
                                    c * Expression::y() - s * Expression::x(), Expression::z());
  Box3 b = f.bounds();
  const Vec3 far = glm::max(glm::abs(b.min), glm::abs(b.max));
  const double r = std::hypot(far.x, far.y);
  b.min.x = b.min.y = -r;
  b.max.x = b.max.y = r;
  return with_bounds(out, b);
}

Expression repeat(const Expression& f, Vec3 period) {
  Box3 b = f.bounds();
  const Expression v[3] = {Expression::x(), Expression::y(), Expression::z()};
  Expression w[3] = {v[0], v[1], v[2]};
  for (int i = 0; i < 3; ++i) {
    finite("a period", period[i]);
    if (period[i] < 0) throw UsageError("a period has to be 0 (none) or more");
    if (period[i] == 0) continue;
    w[i] = v[i] - period[i] * round(v[i] * (1 / period[i]));
    b.min[i] = -kInfinity;
    b.max[i] = kInfinity;
  }
  return with_bounds(substitute(f, w[0], w[1], w[2]), b);
}

}  // namespace burin::implicit
