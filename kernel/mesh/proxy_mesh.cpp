#include <burin/mesh/proxy_mesh.h>

namespace burin {

Vec3 ProxyMesh::position(std::uint32_t face, Vec3 bary) const {
  const Triangle& t = mesh.triangles[face];
  return bary.x * mesh.positions[t[0]] + bary.y * mesh.positions[t[1]] +
         bary.z * mesh.positions[t[2]];
}

Vec3 ProxyMesh::normal(std::uint32_t face, Vec3 bary) const {
  const Triangle& w = wedges[face];
  const Vec3 n =
      bary.x * wedge_normal[w[0]] + bary.y * wedge_normal[w[1]] + bary.z * wedge_normal[w[2]];
  return normalize_or(n, wedge_normal[w[0]]);
}

}  // namespace burin
