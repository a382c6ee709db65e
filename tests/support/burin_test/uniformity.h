#pragma once
/// Whether points are spread evenly over a surface whose areas are known.

#include <burin/base/vec.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace burin::test {

/// Chi-square of the counts over equal cells of the unit square, as a deviation from its mean in
/// standard deviations.
inline double chi_square(const std::vector<Vec2>& shares, int side) {
  std::vector<double> count(static_cast<std::size_t>(side * side), 0.0);
  for (const Vec2& s : shares) {
    const int i = std::min(side - 1, static_cast<int>(s.x * side));
    const int j = std::min(side - 1, static_cast<int>(s.y * side));
    ++count[static_cast<std::size_t>(i * side + j)];
  }
  const double expected = static_cast<double>(shares.size()) / (side * side);
  double chi2 = 0;
  for (const double c : count) chi2 += (c - expected) * (c - expected) / expected;
  const double freedom = side * side - 1;
  return (chi2 - freedom) / std::sqrt(2 * freedom);
}

/// An angle as a share of a whole turn, in [0,1].
inline double turns(double y, double x) {
  const double a = std::atan2(y, x) / (2 * std::numbers::pi);
  return a < 0 ? a + 1 : a;
}

/// Shares of the area of a torus about z before its two angles: cells of equal size are of equal
/// area.
inline Vec2 torus_shares(Vec3 p, double major, double minor) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double ring = std::hypot(p.x, p.y);
  const double angle = kTurn * turns(p.z, ring - major);
  return {turns(p.y, p.x), (major * angle + minor * std::sin(angle)) / (kTurn * major)};
}

/// The same of a sphere about the origin, by Archimedes.
inline Vec2 sphere_shares(Vec3 p, double radius) {
  return {turns(p.y, p.x), std::clamp(0.5 * (1 + p.z / radius), 0.0, 1.0)};
}

}  // namespace burin::test
