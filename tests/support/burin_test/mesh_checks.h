#pragma once
/// Numbers that tell whether a mesh is what it should be.

#include <burin/base/diagnostics.h>
#include <burin/mesh/topology.h>
#include <burin/mesh/tri_mesh.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace burin::test {

struct MeshNumbers {
  std::int64_t components = 0;
  std::int64_t boundary_edges = 0;
  /// Vertices - edges + triangles.
  std::int64_t euler = 0;
  double volume = 0;
  double area = 0;
};

/// Throws GeometryError where the mesh is not manifold or not oriented alike.
inline MeshNumbers numbers(const TriMesh& mesh) {
  const RunContext context;
  const Topology topology = build_topology(mesh, context);
  MeshNumbers n;
  n.components = static_cast<std::int64_t>(topology.component_closed.size());
  n.boundary_edges = std::ranges::count(topology.opposite, kNoHalfEdge);
  const auto half_edges = static_cast<std::int64_t>(topology.opposite.size());
  n.euler = static_cast<std::int64_t>(mesh.positions.size() + mesh.triangles.size()) -
            (half_edges + n.boundary_edges) / 2;
  const Vec3 o = mesh.bounds().center();
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]] - o, b = mesh.positions[t[1]] - o,
               c = mesh.positions[t[2]] - o;
    n.volume += glm::dot(a, glm::cross(b, c)) / 6;
    n.area += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  return n;
}

/// The count of the entry with this code, or 0.
inline std::int64_t count_of(const Diagnostics& diagnostics, const std::string& code) {
  for (const Diagnostic& d : diagnostics.entries()) {
    if (d.code == code) return d.count;
  }
  return 0;
}

/// A soup whose polygons are these triangles over these positions.
inline PolygonSoup soup_of(const TriMesh& mesh) {
  PolygonSoup soup;
  soup.positions = mesh.positions;
  for (const Triangle& t : mesh.triangles) {
    soup.indices.insert(soup.indices.end(), t.begin(), t.end());
    soup.offsets.push_back(soup.indices.size());
  }
  return soup;
}

/// The same with corners of its own for each triangle, as in an STL.
inline PolygonSoup unshared(const TriMesh& mesh) {
  PolygonSoup soup;
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
      soup.positions.push_back(mesh.positions[v]);
    }
    soup.offsets.push_back(soup.indices.size());
  }
  return soup;
}

/// The mesh inside out.
inline TriMesh inverted(TriMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace burin::test
