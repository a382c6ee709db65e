#include <burin/base/parallel.h>

#include "build_steps.h"

#include <algorithm>
#include <cmath>

namespace burin {

void find_sagitta(ProxyMesh& proxy, const Corners& corners, const RunContext& context) {
  std::vector<float> of_face(proxy.mesh.triangles.size());
  parallel_for(
      of_face.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          double largest = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = proxy.wedges[f][k], b = proxy.wedges[f][(k + 1) % 3];
            const Vec3 edge = proxy.wedge_position(a) - proxy.wedge_position(b);
            const Vec3 change = proxy.wedge_normal[a] - proxy.wedge_normal[b];
            largest = std::max(largest, glm::dot(edge, edge) * glm::dot(change, change));
          }
          // h^2 k / 8 with k = |change of normal| / h
          of_face[f] = static_cast<float>(std::sqrt(largest) / 8);
        }
      },
      &context);
  proxy.wedge_sagitta.assign(proxy.wedge_vertex.size(), 0);
  parallel_for(
      proxy.mesh.positions.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          for (const HalfEdge h : corners[v]) {
            float& sagitta = proxy.wedge_sagitta[wedge_of(proxy, h)];
            sagitta = std::max(sagitta, of_face[face_of(h)]);
          }
        }
      },
      &context);
}

}  // namespace burin
