#pragma once
/// Proxies of meshes that know faces and edges of an input, as those of exact forms do.

#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <functional>

namespace burin::test {

/// Names the face of every triangle, and the edge and whether it is a seam of every half-edge from
/// its two ends (-1 = none), which must not depend on their order.
struct Source {
  std::function<std::int32_t(std::uint32_t triangle)> face;
  std::function<std::int32_t(Vec3 a, Vec3 b)> edge;
  std::function<bool(Vec3 a, Vec3 b)> seam = [](Vec3, Vec3) { return false; };
};

inline ProxyMesh sourced(ProxyMesh proxy, const Source& source) {
  const TriMesh& m = proxy.mesh;
  for (std::uint32_t f = 0; f < m.triangles.size(); ++f) {
    proxy.source_face.push_back(source.face(f));
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = m.positions[m.triangles[f][k]], b = m.positions[m.triangles[f][(k + 1) % 3]];
      proxy.source_edge.push_back(source.edge(a, b));
      proxy.seam.push_back(source.seam(a, b) ? 1 : 0);
    }
  }
  return proxy;
}

}  // namespace burin::test
