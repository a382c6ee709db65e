#include <burin/base/parallel.h>
#include <burin/mesh/proxy_mesh.h>

#include "build_steps.h"

#include <numbers>

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

ProxyMesh build_proxy(TriMesh mesh, const ProxyOptions& options, const RunContext& context) {
  ProxyMesh proxy;
  proxy.mesh = std::move(mesh);
  Corners corners;
  std::vector<Vec3> normals;
  parallel_invoke([&] { proxy.topology.opposite = find_opposites(proxy.mesh, context); },
                  [&] {
                    normals = face_normals(proxy.mesh, context);
                    corners = corners_at(proxy.mesh.triangles, proxy.mesh.positions.size());
                  });
  mend_sliver_normals(proxy.mesh, proxy.topology, normals, context);
  classify_edges(proxy, normals, options.crease_angle, context);
  const double crease_angle = options.crease_angle * std::numbers::pi / 180;
  sharpen_lone_bends(proxy, normals, crease_angle, context);
  prune_noise(proxy, normals, crease_angle, context);
  // Floods are serial: they run beside the rest, which does not need them.
  parallel_invoke(
      [&] {
        find_regions(proxy);
        find_components(proxy.topology);
      },
      [&] {
        find_wedges(proxy, corners, context);
        find_wedge_normals(proxy, corners, normals, context);
        find_tips(proxy, normals, crease_angle, context);
        find_sagitta(proxy, corners, context);
      });
  return proxy;
}

}  // namespace burin
