#pragma once
// Which half-edges of a chart mesh meet.

#include <burin/forms/parametric/atlas.h>
#include <burin/mesh/topology.h>

#include <cstdint>
#include <vector>

namespace burin {

/// For each half-edge the opposite one, or kNoHalfEdge. Inside faces triangles of one face meet, on
/// model edges two uses of that edge; where that leaves a choice nothing meets.
std::vector<HalfEdge> chart_mesh_opposites(const ChartMesh& mesh);

/// Whether the normals of both sides of `h` have nothing to do with each other.
inline bool sharp_edge(const ChartMesh& mesh, HalfEdge opposite, std::size_t h) {
  if (opposite == kNoHalfEdge) return true;
  return mesh.border[h] >= 0 && mesh.border_class(h) == ModelEdgeClass::Sharp;
}

}  // namespace burin
