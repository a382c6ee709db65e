#pragma once
/// The hull of a plate and a disc above it: flat walls, fans from the corners of the plate to the
/// disc, and a triangle between two fans on each side.

#include <burin/mesh/tri_mesh.h>

#include <cmath>
#include <numbers>

namespace burin::test {

struct PlateAndDisc {
  double length = 60, width = 40, height = 6;  // of the plate, from the origin on
  double radius = 12, top = 25;                // of the disc above its middle
  std::uint32_t sides = 64;                    // of the disc, a multiple of four
};

/// Vertices 0 to 3 are the corners of the plate below, 4 to 7 above, anticlockwise from the origin;
/// then the disc, from x on.
inline TriMesh hull(const PlateAndDisc& of) {
  TriMesh m;
  for (const double z : {0.0, of.height}) {
    for (const auto& [x, y] :
         {Vec2(0, 0), Vec2(of.length, 0), Vec2(of.length, of.width), Vec2(0, of.width)}) {
      m.positions.emplace_back(x, y, z);
    }
  }
  for (std::uint32_t i = 0; i < of.sides; ++i) {
    const double a = 2 * std::numbers::pi * i / of.sides;
    m.positions.emplace_back(of.length / 2 + of.radius * std::cos(a),
                             of.width / 2 + of.radius * std::sin(a), of.top);
  }
  const auto disc = [&](std::uint32_t i) { return 8 + i % of.sides; };
  const std::uint32_t quarter = of.sides / 4;
  m.triangles = {{0, 2, 1}, {0, 3, 2}};
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t next = (k + 1) % 4, begin = (k + 2) * quarter;
    m.triangles.push_back({k, next, 4 + next});
    m.triangles.push_back({k, 4 + next, 4 + k});
    for (std::uint32_t i = begin; i < begin + quarter; ++i) {
      m.triangles.push_back({4 + k, disc(i + 1), disc(i)});
    }
    m.triangles.push_back({4 + k, 4 + next, disc(begin + quarter)});
  }
  for (std::uint32_t i = 1; i + 1 < of.sides; ++i) {
    m.triangles.push_back({disc(0), disc(i), disc(i + 1)});
  }
  return m;
}

}  // namespace burin::test
