#pragma once
/// A triangle mesh as one OpenMesh, for what walks around vertices and across edges.

#include <burin/base/groups.h>
#include <burin/mesh/proxy_mesh.h>

#include "openmesh_glm.h"

namespace burin {

using RingHandle = OpenMesh::HalfedgeHandle;

/// The OpenMesh of a whole mesh: vertices and faces are numbered as there, and a face begins with
/// the half-edge of its corner 0. A property of the half-edges leads from each to its number in the
/// flat arrays of ProxyMesh. Cost: 78 bytes a triangle, and 12 more while it is made.
class RingMesh final : public OpenMeshTriMesh {
 public:
  /// `opposite` as find_opposites returns it.
  RingMesh(const TriMesh& mesh, const std::vector<HalfEdge>& opposite, const RunContext& context);

  /// The corner that a half-edge starts at, kNoHalfEdge outside the boundary.
  HalfEdge corner(RingHandle h) const { return property(corner_, h); }
  std::uint32_t triangle(RingHandle h) const { return face_of(corner(h)); }
  const Vec3& from(RingHandle h) const { return point(from_vertex_handle(h)); }
  const Vec3& to(RingHandle h) const { return point(to_vertex_handle(h)); }

 private:
  void add_points(const TriMesh& mesh);
  void connect(const TriMesh& mesh, const std::vector<HalfEdge>& opposite,
               const std::vector<RingHandle>& handles, const RunContext& context);
  void enter_vertices(const TriMesh& mesh, const std::vector<HalfEdge>& opposite,
                      const std::vector<RingHandle>& handles);

  OpenMesh::HPropHandleT<HalfEdge> corner_;
};

/// For each wedge the half-edges that leave its corners: its one-ring. Ascending by face, so that
/// sums over a ring do not depend on where the walk around the vertex starts.
Groups<RingHandle> wedge_rings(const RingMesh& rings, const ProxyMesh& proxy,
                               const RunContext& context);

}  // namespace burin
