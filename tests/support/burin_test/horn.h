#pragma once
/// The horn: a circular cross section that sweeps a helix while its radius grows.

#include <burin/forms/charted/nurbs.h>

#include <cmath>
#include <numbers>

namespace burin::test {

struct HornShape {
  double turns = 2.25;
  /// Of the helix, at the tip and at the mouth.
  double helix_tip = 20, helix_mouth = 30;
  /// Rise over the whole length.
  double rise = 60;
  /// Radius of the cross section, at the tip and at the mouth.
  double radius_tip = 3, radius_mouth = 14;
};

/// A frame of the helix: the point, and two unit vectors that span the cross section.
struct HornSection {
  Vec3 center, normal, binormal;
  double radius;
};

/// `t` in [0, 1] from the tip to the mouth (a little beyond is defined, too).
inline HornSection horn_section(const HornShape& shape, double t) {
  const auto at = [&](double x) {
    const double angle = 2 * std::numbers::pi * shape.turns * x;
    const double r = shape.helix_tip + (shape.helix_mouth - shape.helix_tip) * x;
    return Vec3(r * std::cos(angle), r * std::sin(angle), shape.rise * x);
  };
  const double angle = 2 * std::numbers::pi * shape.turns * t, h = 1e-5;
  const Vec3 tangent = glm::normalize(at(t + h) - at(t - h));
  const Vec3 outward(std::cos(angle), std::sin(angle), 0);
  const Vec3 normal = glm::normalize(reject(outward, tangent));
  return {at(t), normal, glm::cross(tangent, normal),
          shape.radius_tip + (shape.radius_mouth - shape.radius_tip) * t};
}

/// The horn as a bicubic B-spline over uniform knots that do not repeat at the ends: u goes round
/// the section (period 12), v from the tip (0) to the mouth (`spans`). Sections are circles within
/// 3e-4 of their radius. Su x Sv points outward.
inline NurbsData horn_nurbs(const HornShape& shape = {}, int spans = 64) {
  constexpr int kRound = 12;
  NurbsData data;
  data.degree_u = data.degree_v = 3;
  data.count_u = kRound + 3;
  data.count_v = spans + 3;
  data.periodic_u = true;
  for (int i = 0; i < data.count_u + 4; ++i) data.knots_u.push_back(i - 3);
  for (int i = 0; i < data.count_v + 4; ++i) data.knots_v.push_back(i - 3);
  // On a circle control points at this distance give a curve through the circle's points.
  const double swell = 3 / (2 + std::cos(2 * std::numbers::pi / kRound));
  const auto ring = [&](int i, double j) {
    const HornSection s = horn_section(shape, j / spans);
    const double angle = 2 * std::numbers::pi * i / kRound;
    return s.center +
           swell * s.radius * (std::cos(angle) * s.normal + std::sin(angle) * s.binormal);
  };
  for (int i = 0; i < data.count_u; ++i) {
    for (int k = 0; k < data.count_v; ++k) {
      // The control point that lets a uniform cubic pass the ring to the fourth order.
      const double j = k - 1;
      data.points.push_back(ring(i, j) -
                            (ring(i, j - 1) - 2.0 * ring(i, j) + ring(i, j + 1)) / 6.0);
    }
  }
  return data;
}

}  // namespace burin::test
