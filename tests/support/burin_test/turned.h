#pragma once
// Facets around an axis, as OpenSCAD makes them of what was round.

#include <burin/repair/repair.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace burin::test {

/// Rounded to single precision. Volatile, as g++ 12 leaves some of these conversions out when it
/// makes vectors of neighbouring ones.
inline double single(double x) {
  const volatile float f = static_cast<float>(x);
  return f;
}

/// A polygon turned round the z axis in `sides` steps: (r, z) pairs from the bottom up, closed at
/// both ends by flat caps. Corners are rounded to float as in a binary STL.
inline TriMesh turned(const std::vector<Vec2>& profile, int sides, bool closed = false) {
  PolygonSoup soup;
  const auto at = [&](const Vec2& p, int i) {
    const double a = 2 * kPi * i / sides;
    return Vec3(single(p.x * std::cos(a)), single(p.x * std::sin(a)), single(p.y));
  };
  const auto polygon = [&](const std::vector<Vec3>& points) {
    for (const Vec3& p : points) {
      soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
      soup.positions.push_back(p);
    }
    soup.offsets.push_back(soup.indices.size());
  };
  const std::size_t n = profile.size();
  for (std::size_t k = 0; k + (closed ? 0 : 1) < n; ++k) {
    const Vec2 p = profile[k], q = profile[(k + 1) % n];
    for (int i = 0; i < sides; ++i) {
      const int j = (i + 1) % sides;
      polygon({at(p, i), at(p, j), at(q, j), at(q, i)});
    }
  }
  for (const bool top : {false, true}) {
    if (closed) break;
    std::vector<Vec3> cap;
    for (int i = 0; i < sides; ++i) cap.push_back(at(top ? profile.back() : profile.front(), i));
    if (!top) std::reverse(cap.begin(), cap.end());
    polygon(cap);
  }
  Diagnostics diagnostics;
  TriMesh mesh = repair(std::move(soup), {}, diagnostics, RunContext());
  EXPECT_TRUE(diagnostics.empty()) << diagnostics.entries().front().message;
  return mesh;
}

/// OpenSCAD's sphere: rings at half steps from the poles.
inline std::vector<Vec2> sphere_profile(double radius, int fn) {
  std::vector<Vec2> profile;
  const int rings = (fn + 1) / 2;
  for (int i = rings - 1; i >= 0; --i) {
    const double a = kPi * (i + 0.5) / rings;
    profile.push_back(radius * Vec2(std::sin(a), std::cos(a)));
  }
  return profile;
}

inline TriMesh moved(TriMesh mesh, const Mat3& linear, Vec3 offset) {
  for (Vec3& p : mesh.positions) p = linear * p + offset;
  return mesh;
}

inline Mat3 tilted() {
  const Vec3 x = glm::normalize(Vec3(1, 2, -1)), z = glm::normalize(glm::cross(x, Vec3(0, 1, 4)));
  return {x, glm::cross(z, x), z};
}

}  // namespace burin::test
