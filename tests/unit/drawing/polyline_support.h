#pragma once
/// Measures between curves and polylines.

#include <burin/drawing/bezier.h>

#include "burin_test/ring_size.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace burin::test {

inline constexpr double kTau = 2 * std::numbers::pi;

inline double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double dd = glm::dot(d, d);
  const double t = dd > 0 ? std::clamp(glm::dot(p - a, d) / dd, 0.0, 1.0) : 0;
  return glm::distance(p, a + t * d);
}

inline double distance_to_polyline(Vec2 p, std::span<const Vec2> line, bool closed) {
  double best = glm::distance(p, line[0]);
  for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
    best = std::min(best, distance_to_segment(p, line[i], line[(i + 1) % line.size()]));
  }
  return best;
}

inline std::vector<Vec2> sampled(std::span<const CubicBezier> curves, int per_curve = 64) {
  std::vector<Vec2> out;
  for (const CubicBezier& c : curves) {
    for (int k = 0; k < per_curve; ++k) out.push_back(evaluate(c, double(k) / per_curve));
  }
  if (!curves.empty()) out.push_back(curves.back()[3]);
  return out;
}

/// The largest distance of the points of one line from another line.
inline double farthest(std::span<const Vec2> from, std::span<const Vec2> line, bool closed) {
  double worst = 0;
  for (const Vec2& p : from) worst = std::max(worst, distance_to_polyline(p, line, closed));
  return worst;
}

inline int winding(Vec2 p, std::span<const Vec2> loop) {
  int count = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
    if (a.y <= p.y && b.y > p.y && cross2(b - a, p - a) > 0) ++count;
    if (a.y > p.y && b.y <= p.y && cross2(b - a, p - a) < 0) --count;
  }
  return count;
}

inline std::vector<Vec2> circle(double radius, int n, Vec2 center = Vec2(0)) {
  std::vector<Vec2> out;
  for (int i = 0; i < n; ++i) {
    out.push_back(center + radius * Vec2(std::cos(kTau * i / n), std::sin(kTau * i / n)));
  }
  return out;
}

}  // namespace burin::test
