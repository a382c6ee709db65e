#include "schneider.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// More simplified points than one cubic can span within usual tolerances; bounds the cost of a
/// split.
constexpr std::size_t kMaxSpan = 48;
constexpr int kMaxReparametrisations = 4;
/// Squared misfit over its limit that reparametrisation will not mend.
constexpr double kHopeless = 9;

/// Points and their parameters on the curve under trial.
struct Span {
  std::span<const Vec2> points;
  std::array<double, kMaxSpan> u;
  double length = 0;

  explicit Span(std::span<const Vec2> p) : points(p) {
    u[0] = 0;
    for (std::size_t i = 1; i < p.size(); ++i) u[i] = u[i - 1] + glm::distance(p[i - 1], p[i]);
    length = u[p.size() - 1];
    for (std::size_t i = 1; i < p.size(); ++i) u[i] /= length;
  }

  /// Squared distance of q from segment i.
  double distance2(Vec2 q, std::size_t i) const {
    const Vec2 d = points[i + 1] - points[i], v = q - points[i];
    const double along = glm::dot(v, d), dd = glm::dot(d, d);
    if (along <= 0) return glm::dot(v, v);
    if (along < dd) return cross2(d, v) * cross2(d, v) / dd;
    const Vec2 w = q - points[i + 1];
    return glm::dot(w, w);
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

/// The largest squared distance of curve and polyline, tested at the points and densely between
/// them, where a curve of few points could bow. Gives up, with some number beyond it, past
/// `hopeless`.
double misfit(const Span& s, const CubicBezier& c, double hopeless) {
  const std::size_t n = s.points.size();
  const int samples = n > 8 ? 1 : static_cast<int>(8 / (n - 1)) + 1;
  double worst = 0;
  for (std::size_t i = 0; i + 1 < n && worst <= hopeless; ++i) {
    for (int k = 1; k <= samples; ++k) {
      const double t = s.u[i] + (s.u[i + 1] - s.u[i]) * k / (samples + 1);
      worst = std::max(worst, s.distance2(evaluate(c, t), i));
    }
    if (i == 0) continue;
    const Vec2 d = evaluate(c, s.u[i]) - s.points[i];
    worst = std::max(worst, glm::dot(d, d));
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

/// The best cubic for the points, and its squared misfit: exact up to the limit, a hint beyond it.
double fit_one(std::span<const Vec2> points, Vec2 start, Vec2 end, double limit,
               CubicBezier& curve) {
  Span s(points);
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0;; ++k) {
    curve = least_squares(s, start, end);
    const double m = misfit(s, curve, kHopeless * limit);
    // Stalled rounds are not worth their cost.
    const bool stalled = m > 0.9 * best;
    best = std::min(best, m);
    if (m <= limit) return m;
    if (k == kMaxReparametrisations || stalled || m > kHopeless * limit) return best;
    if (!reparametrise(s, curve)) return best;
  }
}

/// The first cubic of a run and how many segments it spans.
struct Piece {
  std::size_t segments = 0;
  CubicBezier curve{};
};

/// The longest piece, nearly, that one cubic can span: trials start from `guess`, and the misfit,
/// which grows with about the fourth power of the length, tells the next.
Piece longest_piece(std::span<const Vec2> points, Vec2 start, Vec2 end, double tolerance,
                    std::size_t guess) {
  const double limit = tolerance * tolerance;
  const std::size_t most = std::min(points.size(), kMaxSpan) - 1;
  Piece best;
  std::size_t failed = most + 1, k = std::min(guess, most);
  while (best.segments < k && k < failed) {
    const Vec2 tangent =
        k + 1 == points.size() ? end : circle_tangent(points[k - 1], points[k], points[k + 1]);
    CubicBezier curve;
    const double m = fit_one(points.first(k + 1), start, tangent, limit, curve);
    const double factor = std::clamp(std::pow(limit / std::max(m, 1e-4 * limit), 0.125), 0.4, 2.0);
    const auto next = static_cast<std::size_t>(std::lround(static_cast<double>(k) * factor));
    if (m <= limit) {
      best = {k, curve};
      k = std::min(next, failed - 1);
    } else {
      failed = k;
      k = std::clamp(next, best.segments, k - 1);
    }
  }
  // Two points whose tangents make even one segment bow: a straight line breaks them by a degree or
  // so.
  if (best.segments == 0) best = {1, straight(points[0], points[1])};
  return best;
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
  std::size_t guess = kMaxSpan;
  while (points.size() > 1) {
    const Piece piece = longest_piece(points, start, end, tolerance, guess);
    guess = piece.segments;
    out.push_back(piece.curve);
    if (guess + 1 == points.size()) return;
    start = circle_tangent(points[guess - 1], points[guess], points[guess + 1]);
    points = points.subspan(guess);
  }
}

}  // namespace burin
