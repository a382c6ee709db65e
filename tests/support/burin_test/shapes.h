#pragma once
/// Analytic shapes as triangle meshes, shared by tests and benchmarks. All are closed and oriented
/// outwards.

#include <burin/mesh/tri_mesh.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>

namespace burin::test {

inline constexpr double kPi = std::numbers::pi;

/// Triangles of a grid of nu x nv points `f(i, j)`, periodic in the directions asked for.
inline TriMesh grid(std::uint32_t nu, std::uint32_t nv, bool wrap_u, bool wrap_v,
                    const std::function<Vec3(std::uint32_t, std::uint32_t)>& f) {
  TriMesh m;
  for (std::uint32_t i = 0; i < nu; ++i) {
    for (std::uint32_t j = 0; j < nv; ++j) m.positions.push_back(f(i, j));
  }
  for (std::uint32_t i = 0; i + (wrap_u ? 0 : 1) < nu; ++i) {
    for (std::uint32_t j = 0; j + (wrap_v ? 0 : 1) < nv; ++j) {
      const std::uint32_t i1 = (i + 1) % nu, j1 = (j + 1) % nv;
      const std::uint32_t a = i * nv + j, b = i1 * nv + j, c = i1 * nv + j1, d = i * nv + j1;
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
  }
  return m;
}

/// Torus about z with the radii of its axis circle and its tube.
inline TriMesh torus(double major, double minor, std::uint32_t nu, std::uint32_t nv) {
  return grid(nu, nv, true, true, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * kPi * i / nu, v = 2 * kPi * j / nv, r = major + minor * std::cos(v);
    return Vec3(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
  });
}

/// Ellipsoid with the given half axes: rings of latitude and two poles.
inline TriMesh ellipsoid(Vec3 half, std::uint32_t nu, std::uint32_t nv) {
  TriMesh m = grid(nu, nv - 1, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * kPi * i / nu, v = kPi * (j + 1) / nv - kPi / 2;
    return half * Vec3(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
  });
  const auto south = static_cast<std::uint32_t>(m.positions.size()), north = south + 1;
  m.positions.push_back({0, 0, -half.z});
  m.positions.push_back({0, 0, half.z});
  for (std::uint32_t i = 0; i < nu; ++i) {
    const std::uint32_t a = i * (nv - 1), b = ((i + 1) % nu) * (nv - 1);
    m.triangles.push_back({south, b, a});
    m.triangles.push_back({north, a + nv - 2, b + nv - 2});
  }
  return m;
}

/// Rectangles of 60 x 40 mm along x and z, 0.01 mm apart along y: a crowd as damaged files are.
inline TriMesh stacked_sheets(int count) {
  TriMesh mesh;
  for (int i = 0; i < count; ++i) {
    const auto v = static_cast<std::uint32_t>(mesh.positions.size());
    const double y = 0.01 * i;
    mesh.positions.insert(mesh.positions.end(), {{0, y, 0}, {60, y, 0}, {60, y, 40}, {0, y, 40}});
    mesh.triangles.push_back({v, v + 1, v + 2});
    mesh.triangles.push_back({v, v + 2, v + 3});
  }
  return mesh;
}

/// Axis-aligned box.
inline TriMesh box(Vec3 min, Vec3 max) {
  TriMesh m;
  for (int i = 0; i < 8; ++i) {
    m.positions.push_back({i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z});
  }
  m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return m;
}

/// Cylinder about z from z = 0 to `height`, as CAD programs write it: `n` facets, caps as fans.
inline TriMesh cylinder(double radius, double height, std::uint32_t n) {
  TriMesh m;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double u = 2 * kPi * i / n;
    m.positions.push_back({radius * std::cos(u), radius * std::sin(u), 0});
    m.positions.push_back({radius * std::cos(u), radius * std::sin(u), height});
  }
  m.positions.push_back({0, 0, 0});
  m.positions.push_back({0, 0, height});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % n);
    m.triangles.push_back({a, b, b + 1});
    m.triangles.push_back({a, b + 1, a + 1});
    m.triangles.push_back({2 * n, b, a});
    m.triangles.push_back({2 * n + 1, a + 1, b + 1});
  }
  return m;
}

/// The mesh with every position mapped.
inline TriMesh mapped(TriMesh m, const std::function<Vec3(Vec3)>& f) {
  for (Vec3& p : m.positions) p = f(p);
  return m;
}

/// Both meshes in one.
inline TriMesh joined(TriMesh a, const TriMesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return a;
}

#ifdef BURIN_TEST_DATA
/// A real model that is no part of the project; tests skip, saying so, where it is absent:
/// `if (!std::filesystem::exists(p)) GTEST_SKIP() << "no " << p;`
inline std::filesystem::path data(const std::string& relative) {
  return std::filesystem::path(BURIN_TEST_DATA) / relative;
}
#endif

/// What is seen of `slotted` from the front: 30 mm wide, 20 high, a slot of 10 mm from the top down
/// to 8.
inline const std::vector<Vec2>& slotted_profile() {
  static const std::vector<Vec2> profile = {{0, 0},  {30, 0}, {30, 20}, {20, 20},
                                            {20, 8}, {10, 8}, {10, 20}, {0, 20}};
  return profile;
}

/// A block with a slot along y, from y = 0 to 40 mm.
inline TriMesh slotted() {
  TriMesh part;
  for (const double y : {0.0, 40.0}) {
    for (const Vec2 p : slotted_profile()) part.positions.emplace_back(p.x, y, p.y);
  }
  for (const Triangle& t :
       std::vector<Triangle>{{0, 1, 5}, {1, 4, 5}, {1, 2, 4}, {2, 3, 4}, {0, 5, 7}, {5, 6, 7}}) {
    part.triangles.push_back(t);
    part.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
  }
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t j = (i + 1) % 8;
    part.triangles.push_back({i, i + 8, j + 8});
    part.triangles.push_back({i, j + 8, j});
  }
  return part;
}

}  // namespace burin::test
