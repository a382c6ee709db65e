#include "schneider.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

/// More simplified points than one cubic can span within usual tolerances; bounds the cost of a
/// split.
constexpr std::size_t kMaxSpan = 48;
constexpr int kMaxReparametrisations = 4;

double segment_distance2(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a, v = p - a;
  const double t = std::clamp(glm::dot(v, d) / glm::dot(d, d), 0.0, 1.0);
  const Vec2 w = v - t * d;
  return glm::dot(w, w);
}

/// Points and their parameters on the curve under trial.
struct Span {
  std::span<const Vec2> points;
  std::array<double, kMaxSpan> u{};
  double length = 0;

  explicit Span(std::span<const Vec2> p) : points(p) {
    for (std::size_t i = 1; i < p.size(); ++i) {
      u[i] = u[i - 1] + glm::distance(p[i - 1], p[i]);
    }
    length = u[p.size() - 1];
    for (std::size_t i = 1; i < p.size(); ++i) u[i] /= length;
  }
};

/// The least-squares cubic for the present parameters: the ends are given, the two inner control
/// points lie on the tangents (Schneider's equation for alpha 1 and 2).
CubicBezier least_squares(const Span& s, Vec2 start, Vec2 end) {
  const Vec2 p0 = s.points.front(), p3 = s.points.back();
  double c00 = 0, c01 = 0, c11 = 0, x0 = 0, x1 = 0;
  for (std::size_t i = 1; i + 1 < s.points.size(); ++i) {
    const double u = s.u[i], v = 1 - u;
    const double b1 = 3 * u * v * v, b2 = 3 * u * u * v;
    const Vec2 a0 = start * b1, a1 = -end * b2;
    c00 += b1 * b1;
    c01 += glm::dot(a0, a1);
    c11 += b2 * b2;
    const Vec2 rest = s.points[i] - (p0 * (v * v * v + b1) + p3 * (u * u * u + b2));
    x0 += glm::dot(a0, rest);
    x1 += glm::dot(a1, rest);
  }
  const double det = c00 * c11 - c01 * c01;
  // Where the system says nothing useful (no inner points, parallel tangents) a third of the length
  // is the Hermite choice; handles longer than twice the length or near zero would make loops and
  // cusps.
  double alpha0 = s.length / 3, alpha1 = alpha0;
  if (det > 1e-9 * c00 * c11) {
    const double l0 = (x0 * c11 - x1 * c01) / det, l1 = (c00 * x1 - c01 * x0) / det;
    const double low = 0.02 * s.length, high = 2 * s.length;
    if (l0 > low && l0 < high && l1 > low && l1 < high) {
      alpha0 = l0;
      alpha1 = l1;
    }
  }
  return {p0, p0 + start * alpha0, p3 - end * alpha1, p3};
}

struct Misfit {
  double squared = 0;
  std::size_t vertex = 1;
};

/// The largest squared distance of curve and polyline, tested at the points and densely between
/// them, where a curve of few points could bow.
Misfit misfit(const Span& s, const CubicBezier& c) {
  const std::size_t n = s.points.size();
  const int samples = n > 8 ? 1 : static_cast<int>(8 / (n - 1)) + 1;
  Misfit worst;
  const auto take = [&](double d2, std::size_t vertex) {
    if (d2 > worst.squared) worst = {d2, vertex};
  };
  for (std::size_t i = 0; i + 1 < n; ++i) {
    for (int k = 1; k <= samples; ++k) {
      const double t = s.u[i] + (s.u[i + 1] - s.u[i]) * k / (samples + 1);
      take(segment_distance2(evaluate(c, t), s.points[i], s.points[i + 1]), i == 0 ? 1 : i);
    }
    if (i == 0) continue;
    const Vec2 d = evaluate(c, s.u[i]) - s.points[i];
    take(glm::dot(d, d), i);
  }
  return worst;
}

/// One Newton step of each parameter towards the foot of its point; false where they lose their
/// order.
bool reparametrise(Span& s, const CubicBezier& c) {
  const Vec2 d0 = 3.0 * (c[1] - c[0]), d1 = 3.0 * (c[2] - c[1]), d2 = 3.0 * (c[3] - c[2]);
  const Vec2 e0 = 2.0 * (d1 - d0), e1 = 2.0 * (d2 - d1);
  double previous = 0;
  for (std::size_t i = 1; i + 1 < s.points.size(); ++i) {
    const double u = s.u[i], v = 1 - u;
    const Vec2 q = evaluate(c, u) - s.points[i];
    const Vec2 q1 = v * v * d0 + 2 * u * v * d1 + u * u * d2, q2 = v * e0 + u * e1;
    const double slope = glm::dot(q1, q1) + glm::dot(q, q2);
    if (slope > 0) s.u[i] = u - glm::dot(q, q1) / slope;
    if (!(s.u[i] > previous && s.u[i] < 1)) return false;
    previous = s.u[i];
  }
  return true;
}

/// Tries one cubic; where it fails `split` is the point to divide at.
bool fit_one(std::span<const Vec2> points, Vec2 start, Vec2 end, double tolerance,
             CubicBezier& curve, std::size_t& split) {
  const double limit = tolerance * tolerance;
  Span s(points);
  Misfit best;
  for (int k = 0; k <= kMaxReparametrisations; ++k) {
    curve = least_squares(s, start, end);
    const Misfit m = misfit(s, curve);
    if (m.squared <= limit) return true;
    if (k == 0 || m.squared < best.squared) best = m;
    // Reparametrisation rarely wins more than a factor of four in distance; stalled rounds are not
    // worth their cost.
    if (m.squared > 16 * limit || m.squared > 1.5 * best.squared || !reparametrise(s, curve)) break;
  }
  split = best.vertex;
  return false;
}

}  // namespace

Vec2 direction(Vec2 a, Vec2 b) { return (b - a) / glm::distance(a, b); }

Vec2 circle_tangent(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 ab = b - a, bc = c - b;
  const Vec2 t = ab / glm::dot(ab, ab) + bc / glm::dot(bc, bc);
  const double n = glm::length(t);
  return n > 0 ? t / n : direction(a, b);
}

CubicBezier straight(Vec2 a, Vec2 b) { return {a, a + (b - a) / 3.0, b - (b - a) / 3.0, b}; }

void fit_run(std::span<const Vec2> points, Vec2 start, Vec2 end, double tolerance,
             std::vector<CubicBezier>& out) {
  const std::size_t n = points.size();
  std::size_t split = n / 2;
  if (n <= kMaxSpan) {
    CubicBezier curve;
    if (fit_one(points, start, end, tolerance, curve, split)) {
      out.push_back(curve);
      return;
    }
    if (n == 2) {
      out.push_back(straight(points[0], points[1]));
      return;
    }
  }
  const Vec2 middle = circle_tangent(points[split - 1], points[split], points[split + 1]);
  fit_run(points.first(split + 1), start, middle, tolerance, out);
  fit_run(points.subspan(split), middle, end, tolerance, out);
}

}  // namespace burin
