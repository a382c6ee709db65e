#pragma once
/// Planar patches of a mesh: triangles side by side in one plane, as CAD tessellations have them.

#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <vector>

namespace burin {

/// A patch is a set of two or more coplanar triangles connected over smooth edges: a flat face of a
/// part, or a facet of a curved one. Where a wide patch bends to a far narrower one, the surface is
/// taken to run straight up to the edge and to curve beyond it only, as where a fillet runs into a
/// flat face: the true normal at the edge is then that of the wide patch, and no average.
struct PlanarPatches {
  /// For each triangle its patch, or -1; empty where the mesh has no patch at all.
  std::vector<std::int32_t> of_face;
  std::vector<Vec3> normal;
  /// For each half-edge, whether the patch on its side runs straight up to it; empty like
  /// `of_face`.
  std::vector<std::uint8_t> straight;

  std::int32_t patch(std::size_t face) const { return of_face.empty() ? -1 : of_face[face]; }
};

/// Reads mesh, topology and edge_kind of the proxy.
PlanarPatches find_patches(const ProxyMesh& proxy, const std::vector<Vec3>& face_normals,
                           const RunContext& context);

}  // namespace burin
