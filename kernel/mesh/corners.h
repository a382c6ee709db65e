#pragma once
/// The corners (half-edges that start there) of each vertex.

#include <burin/base/run_context.h>
#include <burin/mesh/topology.h>
#include <burin/mesh/tri_mesh.h>

#include <span>
#include <vector>

namespace burin {

/// Corners of vertex v in ascending order: `of(v)`.
struct VertexCorners {
  std::vector<std::uint32_t> offsets;
  std::vector<HalfEdge> corners;

  std::span<const HalfEdge> of(std::size_t vertex) const {
    return {corners.data() + offsets[vertex], corners.data() + offsets[vertex + 1]};
  }
};

VertexCorners vertex_corners(const TriMesh& mesh);

}  // namespace burin
