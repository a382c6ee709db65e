#include <burin/base/parallel.h>

#include "../build_steps.h"
#include "ring_steps.h"

#include <numbers>

namespace burin {

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
  const RingMesh rings(proxy.mesh, proxy.topology.opposite, context);
  mend_sliver_normals(proxy.mesh, proxy.topology, normals, context);
  classify_edges(rings, proxy, normals, options.crease_angle, context);
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
        find_wedge_normals(rings, proxy, normals, context);
        find_tips(proxy, normals, crease_angle, context);
        find_sagitta(proxy, corners, context);
      });
  return proxy;
}

}  // namespace burin
