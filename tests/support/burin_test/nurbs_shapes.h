#pragma once
/// NURBS surfaces whose truth is known: revolutions as rational quadratics, and random ones.

#include <burin/base/rng.h>
#include <burin/forms/charted/nurbs.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace burin::test {

/// A sheet of 40 mm in the plane y = 0, which the front view sees square on; u along x, v along z.
inline NurbsData front_sheet() {
  return bezier_patch(1, 1, {{-20, 0, -20}, {-20, 0, 20}, {20, 0, -20}, {20, 0, 20}});
}

/// A rational quadratic curve of quarter circles: points in the plane, weights, knots 0 0 0 1 1 2 2
/// ...
struct ArcCurve {
  std::vector<Vec2> points;
  std::vector<double> weights, knots;
};

inline ArcCurve circle_arcs(int quarters, double start, Vec2 center, double radius) {
  ArcCurve arcs;
  for (int i = 0; i <= 2 * quarters; ++i) {
    const double angle = start + i * std::numbers::pi / 4;
    const double w = i % 2 == 0 ? 1 : std::numbers::sqrt2 / 2;
    arcs.points.push_back(center + radius / w * Vec2(std::cos(angle), std::sin(angle)));
    arcs.weights.push_back(w);
  }
  arcs.knots = {0, 0, 0};
  for (int i = 1; i < quarters; ++i) arcs.knots.insert(arcs.knots.end(), 2, i);
  arcs.knots.insert(arcs.knots.end(), 3, quarters);
  return arcs;
}

/// The curve (x = distance from the axis, y = height), degree 1 or 2, turned about z. u runs round
/// the axis (0 to 4), v along the curve; Su x Sv points outward for curves that run upwards.
inline NurbsData revolve(const ArcCurve& curve, int degree) {
  const ArcCurve circle = circle_arcs(4, 0, Vec2(0), 1);
  NurbsData data;
  data.degree_u = 2;
  data.degree_v = degree;
  data.knots_u = circle.knots;
  data.knots_v = curve.knots;
  data.count_u = 9;
  data.count_v = static_cast<int>(curve.points.size());
  data.periodic_u = true;
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = 0; j < curve.points.size(); ++j) {
      const Vec2 c = circle.points[i] * curve.points[j].x;
      data.points.emplace_back(c.x, c.y, curve.points[j].y);
      data.weights.push_back(circle.weights[i] * curve.weights[j]);
    }
  }
  return data;
}

inline NurbsData torus_nurbs(double major, double minor) {
  NurbsData data = revolve(circle_arcs(4, 0, Vec2(major, 0), minor), 2);
  data.periodic_v = true;
  return data;
}

/// From the south pole (v = 0) to the north pole (v = 2).
inline NurbsData sphere_nurbs(double radius) {
  ArcCurve half = circle_arcs(2, -std::numbers::pi / 2, Vec2(0), radius);
  half.points.front().x = half.points.back().x = 0;
  return revolve(half, 2);
}

inline NurbsData cone_nurbs(double radius_bottom, double radius_top, double height) {
  return revolve({{Vec2(radius_bottom, 0), Vec2(radius_top, height)}, {1, 1}, {0, 0, 1, 1}}, 1);
}

/// A surface over uneven knots (some double) with wavy random points; `clamped` false gives knots
/// that do not repeat at the ends.
inline NurbsData random_nurbs(int degree_u, int degree_v, int count_u, int count_v, bool rational,
                              bool clamped, std::uint64_t seed) {
  const Rng rng(seed);
  std::uint64_t n = 0;
  const auto knots = [&](int degree, int count) {
    std::vector<double> k;
    double x = -0.7;
    for (int i = 0; i < count + degree + 1; ++i) {
      k.push_back(x);
      const bool end = clamped && (i < degree || i >= count);
      const bool twice = degree > 1 && i > degree && i < count - 1 && i % 5 == 0;
      if (!end && !twice) x += 0.3 + rng.uniform(n++);
    }
    return k;
  };
  NurbsData data;
  data.degree_u = degree_u;
  data.degree_v = degree_v;
  data.count_u = count_u;
  data.count_v = count_v;
  data.knots_u = knots(degree_u, count_u);
  data.knots_v = knots(degree_v, count_v);
  for (int i = 0; i < count_u; ++i) {
    for (int j = 0; j < count_v; ++j) {
      data.points.emplace_back(i + 0.5 * rng.uniform(n), j + 0.5 * rng.uniform(n + 1),
                               2 * rng.uniform(n + 2));
      n += 3;
      if (rational) data.weights.push_back(0.4 + 1.6 * rng.uniform(n++));
    }
  }
  return data;
}

}  // namespace burin::test
