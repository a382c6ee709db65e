#pragma once
/// Shapes tessellated as CAD programs do it: few long triangles, facets on flat faces, fillets of
/// narrow strips.

#include <burin_test/shapes.h>

#include <cmath>
#include <vector>

namespace burin::test {

/// A mesh with its true normals, one a vertex.
struct CadShape {
  TriMesh mesh;
  std::vector<Vec3> normals;
};

/// Two flat faces of `width` at a right angle, joined by a fillet of `facets` strips, `length`
/// along y; open.
inline CadShape filleted_edge(double radius, double width, double length, std::uint32_t facets,
                              std::uint32_t along) {
  std::vector<Vec3> profile = {{-width, 0, radius}}, normal = {{0, 0, 1}};
  for (std::uint32_t i = 0; i <= facets; ++i) {
    const double t = kPi / 2 * i / facets;
    profile.push_back({radius * std::sin(t), 0, radius * std::cos(t)});
    normal.push_back({std::sin(t), 0, std::cos(t)});
  }
  profile.push_back({radius, 0, -width});
  normal.push_back({1, 0, 0});
  CadShape result;
  const auto rows = static_cast<std::uint32_t>(profile.size());
  result.mesh = grid(rows, along + 1, false, false, [&](std::uint32_t i, std::uint32_t j) {
    result.normals.push_back(normal[i]);
    return profile[i] + Vec3(0, length * j / along, 0);
  });
  return result;
}

/// The side of a cylinder about z, with a fillet of `facets` strips into its flat top; open below.
inline CadShape turned(double radius, double fillet, double height, std::uint32_t n,
                       std::uint32_t facets) {
  CadShape result;
  result.mesh = grid(n, facets + 2, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * kPi * i / n, t = kPi / 2 * std::min(1.0, double(j) / facets);
    const double r = radius - fillet + fillet * std::sin(t);
    const double z = j > facets ? 0 : height - fillet + fillet * std::cos(t);
    result.normals.push_back({std::sin(t) * std::cos(u), std::sin(t) * std::sin(u), std::cos(t)});
    return Vec3(r * std::cos(u), r * std::sin(u), z);
  });
  for (Triangle& t : result.mesh.triangles) std::swap(t[1], t[2]);
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    result.mesh.triangles.push_back({0, i * (facets + 2), (i + 1) * (facets + 2)});
  }
  return result;
}

/// A box of half the sizes `half` grown by `radius`: flat faces, edges of `facets` strips, corners
/// of pieces of a sphere by latitude and longitude; closed.
inline CadShape rounded_box(Vec3 half, double radius, std::uint32_t facets) {
  CadShape result;
  const std::uint32_t around = 4 * (facets + 1), rows = 2 * (facets + 1);
  const auto index = [&](std::uint32_t row, std::uint32_t i) {
    const std::uint32_t quarter = i % around / (facets + 1);
    if (row == 0) return quarter;
    if (row + 1 == rows) return 4 + (rows - 2) * around + quarter;
    return 4 + (row - 1) * around + i % around;
  };
  result.mesh.positions.resize(8 + (rows - 2) * around);
  result.normals.resize(result.mesh.positions.size());
  for (std::uint32_t row = 0; row < rows; ++row) {
    const bool below = row > facets;
    const double latitude = kPi / 2 * (1 - double(row - (below ? 1 : 0)) / facets);
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t quarter = i / (facets + 1);
      const double u = kPi / 2 * double(i - quarter) / facets;
      const bool pole = row == 0 || row + 1 == rows;
      const double flat = pole ? 0 : std::cos(latitude);
      const Vec3 n(flat * std::cos(u), flat * std::sin(u), std::sin(latitude));
      const Vec3 corner(quarter == 0 || quarter == 3 ? half.x : -half.x,
                        quarter < 2 ? half.y : -half.y, below ? -half.z : half.z);
      result.normals[index(row, i)] = n;
      result.mesh.positions[index(row, i)] = corner + radius * n;
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) result.mesh.triangles.push_back({a, b, c});
  };
  for (std::uint32_t row = 0; row + 1 < rows; ++row) {
    for (std::uint32_t i = 0; i < around; ++i) {
      add(index(row, i), index(row + 1, i), index(row + 1, i + 1));
      add(index(row, i), index(row + 1, i + 1), index(row, i + 1));
    }
  }
  const std::uint32_t last = 4 + (rows - 2) * around;
  for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{0, 2, 3}}) {
    add(t[0], t[1], t[2]);
    add(last + t[0], last + t[2], last + t[1]);
  }
  return result;
}

/// The side of a cylinder whose rims have different numbers of vertices; open.
inline CadShape uneven_rims(double radius, double height, std::uint32_t below,
                            std::uint32_t above) {
  CadShape result;
  const auto rim = [&](std::uint32_t n, double z) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const double u = 2 * kPi * i / n;
      result.normals.push_back({std::cos(u), std::sin(u), 0});
      result.mesh.positions.push_back({radius * std::cos(u), radius * std::sin(u), z});
    }
  };
  rim(below, 0);
  rim(above, height);
  for (std::uint32_t i = 0, j = 0; i < below || j < above;) {
    const std::uint32_t a = i % below, b = below + j % above;
    if (i < below && (j >= above || double(i + 1) / below <= double(j + 1) / above)) {
      result.mesh.triangles.push_back({a, ++i % below, b});
    } else {
      result.mesh.triangles.push_back({a, below + ++j % above, b});
    }
  }
  return result;
}

}  // namespace burin::test
