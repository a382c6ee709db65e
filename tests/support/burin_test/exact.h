#pragma once
/// Exact local geometry of analytic shapes, and how far estimates are from it.

#include <burin/base/vec.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace burin::test {

/// Unit outward normal, principal curvatures k1 >= k2 (positive on a sphere), unit direction of k1.
struct ExactFrame {
  Vec3 normal{0, 0, 1};
  double k1 = 0, k2 = 0;
  Vec3 d1{1, 0, 0};
};
using ExactSurface = std::function<ExactFrame(Vec3)>;

/// From gradient (outward) and Hessian of an implicit function.
inline ExactFrame exact_implicit(Vec3 gradient, const Mat3& hessian) {
  const double length = glm::length(gradient);
  ExactFrame result;
  result.normal = gradient / length;
  const Vec3 u = any_orthogonal(result.normal), v = glm::cross(result.normal, u);
  const double a = glm::dot(u, hessian * u) / length, b = glm::dot(u, hessian * v) / length,
               c = glm::dot(v, hessian * v) / length;
  const double angle = 0.5 * std::atan2(b, 0.5 * (a - c)), d = std::hypot(0.5 * (a - c), b);
  result.k1 = 0.5 * (a + c) + d;
  result.k2 = 0.5 * (a + c) - d;
  result.d1 = std::cos(angle) * u + std::sin(angle) * v;
  return result;
}

/// Torus about z.
inline ExactSurface exact_torus(double major, double minor) {
  return [=](Vec3 p) {
    const Vec3 radial = glm::normalize(Vec3(p.x, p.y, 0));
    ExactFrame result;
    result.normal = glm::normalize(p - major * radial);
    const double c = glm::dot(result.normal, radial);
    result.k1 = 1 / minor;
    result.k2 = c / (major + minor * c);
    result.d1 = glm::cross(Vec3(-radial.y, radial.x, 0), result.normal);
    return result;
  };
}

/// Ellipsoid about the origin with the given half axes.
inline ExactSurface exact_ellipsoid(Vec3 half) {
  return [=](Vec3 p) {
    const Vec3 s = 1.0 / (half * half);
    return exact_implicit(p * s, Mat3(s.x, 0, 0, 0, s.y, 0, 0, 0, s.z));
  };
}

/// Nearest point of the torus.
inline std::function<Vec3(Vec3)> onto_torus(double major, double minor) {
  return [=](Vec3 p) {
    const Vec3 ring = major * glm::normalize(Vec3(p.x, p.y, 0));
    return ring + minor * glm::normalize(p - ring);
  };
}

/// A near point of the ellipsoid, along the gradient.
inline std::function<Vec3(Vec3)> onto_ellipsoid(Vec3 half) {
  return [=](Vec3 p) {
    for (int i = 0; i < 6; ++i) {
      const Vec3 q = p / half, g = 2.0 * q / half;
      p -= g * ((glm::dot(q, q) - 1) / glm::dot(g, g));
    }
    return p;
  };
}

/// The value below which `share` of the values lie.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto n = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + n, values.end());
  return values[static_cast<std::size_t>(n)];
}

/// The angle between two lines in degrees.
inline double line_angle(Vec3 a, Vec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), std::abs(glm::dot(a, b))) * 180 /
         std::numbers::pi;
}

}  // namespace burin::test
