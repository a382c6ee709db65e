#include "quadric_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

constexpr std::size_t kTerms = 5;
/// Holds the curved terms down a little (rows are of about unit size) so that there is always one
/// solution.
constexpr double kRidge = 1e-6;
/// The same for rings that do not determine the curved terms, as those on two parallel rims.
constexpr double kStrongRidge = 1e-2;
/// Such rings are told by a curved term of which the other terms leave less than this share.
constexpr double kUndetermined = 1e-1;

using Row = std::array<double, kTerms>;

/// Normal equations, upper triangle.
struct System {
  std::array<Row, kTerms> m{};
  Row r{};

  void add(const Row& row, double z, double weight) {
    for (std::size_t i = 0; i < kTerms; ++i) {
      for (std::size_t k = i; k < kTerms; ++k) m[i][k] += weight * row[i] * row[k];
      r[i] += weight * row[i] * z;
    }
  }

  /// Solves by L D L^T, the solution in `r`. Returns the least share of a curved term that is
  /// independent of the terms before it; 0 where there is no solution.
  double solve(double ridge) {
    double least = 1;
    Row whole;
    for (std::size_t i = 0; i < kTerms; ++i) {
      whole[i] = m[i][i];
      if (i >= 2) m[i][i] += ridge * whole[i];
    }
    for (std::size_t j = 0; j < kTerms; ++j) {
      if (!(m[j][j] > 1e-13)) return 0;
      if (j >= 2) least = std::min(least, m[j][j] / whole[j] - ridge);
      for (std::size_t i = j + 1; i < kTerms; ++i) {
        const double factor = m[j][i] / m[j][j];
        for (std::size_t k = i; k < kTerms; ++k) m[i][k] -= factor * m[j][k];
        r[i] -= factor * r[j];
      }
    }
    for (std::size_t j = kTerms; j-- > 0;) {
      for (std::size_t k = j + 1; k < kTerms; ++k) r[j] -= m[j][k] * r[k];
      r[j] /= m[j][j];
    }
    return std::max(least, 1e-300);
  }
};

}  // namespace

Vec3 quadric_normal(Vec3 normal, std::span<const Vec3> points, std::size_t ring) {
  // Axes along the longer extent, so that those of a ring of long thin triangles do not mix its
  // scales.
  double size = 0;
  Vec3 longest(0);
  for (const Vec3& p : points) {
    size += glm::length(p);
    if (glm::dot(p, p) > glm::dot(longest, longest)) longest = p;
  }
  const Vec3 u = normalize_or(reject(longest, normal), any_orthogonal(normal));
  const Vec3 v = glm::cross(normal, u);
  const double scale = static_cast<double>(points.size()) / size;
  const auto system_of = [&](std::span<const Vec3> some) {
    System system;
    for (const Vec3& p : some) {
      const double x = glm::dot(p, u) * scale, y = glm::dot(p, v) * scale;
      const double z = glm::dot(p, normal) * scale, distance2 = x * x + y * y + z * z;
      if (distance2 > 0) system.add({x, y, x * x, x * y, y * y}, z, 1 / distance2);
    }
    return system;
  };
  System system = system_of(points);
  double share = system.solve(kRidge);
  if (share < kUndetermined) {
    system = system_of(points.first(ring));
    share = system.solve(kStrongRidge);
  }
  if (share == 0) return Vec3(0);
  return normalize_or(normal - system.r[0] * u - system.r[1] * v, Vec3(0));
}

}  // namespace burin
