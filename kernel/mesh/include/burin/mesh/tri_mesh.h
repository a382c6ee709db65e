#pragma once
/// Triangles as indexed arrays.

#include <burin/base/box.h>
#include <burin/base/vec.h>

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace burin {

using Triangle = std::array<std::uint32_t, 3>;

/// Positions in model mm and counter-clockwise triangles (seen from outside) that index them.
struct TriMesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;

  Box3 bounds() const;
  /// The unit normal of a triangle; the zero vector where it has no area.
  Vec3 normal(std::uint32_t triangle) const;
  double area(std::uint32_t triangle) const;
};

/// What a mesh file holds before any repair: polygons of three or more corners over shared or
/// unshared points. Polygon i has the corners `indices[offsets[i]] .. indices[offsets[i+1]-1]`;
/// `offsets` has one entry more than there are polygons (and holds a single 0 where there are
/// none).
struct PolygonSoup {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> indices;
  std::vector<std::size_t> offsets{0};
  /// u and v of each of `indices`, not a number where a corner has none; empty where the file has
  /// none at all.
  std::vector<glm::vec2> texture = {};

  std::size_t polygon_count() const { return offsets.size() - 1; }
};

}  // namespace burin
