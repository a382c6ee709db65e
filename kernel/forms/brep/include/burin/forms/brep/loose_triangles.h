#pragma once
/// Triangles of faces that have no chart, or none that works.

#include <burin/base/vec.h>
#include <burin/mesh/tri_mesh.h>

#include <cstdint>
#include <vector>

namespace burin {

/// A soup: nothing is said about how triangles meet. `face` has the face of each triangle.
struct LooseTriangles {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<std::int32_t> face;

  bool empty() const { return triangles.empty(); }
  void append(const LooseTriangles& other) {
    const auto by = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), other.positions.begin(), other.positions.end());
    for (const Triangle& t : other.triangles)
      triangles.push_back({t[0] + by, t[1] + by, t[2] + by});
    face.insert(face.end(), other.face.begin(), other.face.end());
  }
};

}  // namespace burin
