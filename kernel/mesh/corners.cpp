#include "corners.h"

namespace burin {

VertexCorners vertex_corners(const TriMesh& mesh) {
  VertexCorners result;
  result.offsets.assign(mesh.positions.size() + 2, 0);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) ++result.offsets[v + 2];
  }
  for (std::size_t v = 2; v < result.offsets.size(); ++v) {
    result.offsets[v] += result.offsets[v - 1];
  }
  // offsets[v + 1] is where vertex v writes next; at the end it is where v + 1 begins.
  result.corners.resize(3 * mesh.triangles.size());
  HalfEdge h = 0;
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) result.corners[result.offsets[v + 1]++] = h++;
  }
  result.offsets.pop_back();
  return result;
}

}  // namespace burin
