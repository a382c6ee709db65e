#pragma once
/// Half-edge connectivity as one flat array. OpenMesh builds it; only the array is kept. @cite
/// Botsch2002

#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Half-edge h = 3*f + k runs from corner k of triangle f to its corner (k+1)%3.
using HalfEdge = std::int32_t;
inline constexpr HalfEdge kNoHalfEdge = -1;

inline HalfEdge next_in_face(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline HalfEdge prev_in_face(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }
inline std::uint32_t face_of(HalfEdge h) { return static_cast<std::uint32_t>(h) / 3; }

struct Topology {
  /// For each half-edge the opposite one in the neighbouring triangle, or kNoHalfEdge at a
  /// boundary.
  std::vector<HalfEdge> opposite;
  /// Connected component of each triangle, numbered from 0 in order of the first triangle.
  std::vector<std::int32_t> face_component;
  /// Whether a component has no boundary.
  std::vector<std::uint8_t> component_closed;
};

/// The vertex that half-edge `h` starts at.
inline std::uint32_t origin(const TriMesh& mesh, HalfEdge h) {
  return mesh.triangles[face_of(h)][static_cast<std::size_t>(h % 3)];
}

/// Connectivity of an oriented mesh whose edges have at most two triangles (as `repair` returns
/// it). Fans that meet at a vertex alone are allowed. Throws GeometryError, naming a triangle,
/// where an edge has more triangles or two neighbours are not oriented alike. Cost: 0.15 s per
/// million triangles.
Topology build_topology(const TriMesh& mesh, const RunContext& context);

}  // namespace burin
