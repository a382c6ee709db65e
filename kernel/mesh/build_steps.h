#pragma once
/// The steps of build_proxy, each of which fills some arrays of the ProxyMesh from those before it
/// (those that walk on the OpenMesh: openmesh/ring_steps.h).

#include <burin/mesh/corners.h>
#include <burin/mesh/proxy_mesh.h>

#include <algorithm>
#include <cmath>

namespace burin {

inline double angle_of(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

/// Triangles a range of the parallel loops: 0.1 to 5 ms each.
inline constexpr std::size_t kFaceGrain = 4096;

/// The two halves of build_topology.
std::vector<HalfEdge> find_opposites(const TriMesh& mesh, const RunContext& context);
void find_components(Topology& topology);

inline std::uint32_t wedge_of(const ProxyMesh& proxy, HalfEdge corner) {
  return proxy.wedges[face_of(corner)][static_cast<std::size_t>(corner % 3)];
}

/// Unit normals of all triangles; zero where a triangle has no area.
std::vector<Vec3> face_normals(const TriMesh& mesh, const RunContext& context);

/// Gives triangles too thin for a normal of their own that of the neighbour across their longest
/// edge.
void mend_sliver_normals(const TriMesh& mesh, const Topology& topology, std::vector<Vec3>& normals,
                         const RunContext& context);

/// Convex or concave, of an edge that bends.
EdgeKind crease_kind(const ProxyMesh& proxy, const std::vector<Vec3>& normals, HalfEdge h);

/// Makes creases of bends of half the crease angle and more that lie alone between flat faces of
/// more than a triangle each, or bound a chamfer between wider ones: no smooth surface bends in one
/// line. `crease_angle` in radians. Cost: a pass over the edges, 20 ms a million triangles where
/// there are such bends.
void sharpen_lone_bends(ProxyMesh& proxy, const std::vector<Vec3>& normals, double crease_angle,
                        const RunContext& context);

/// Makes creases smooth that are noise, not form: short chains that end inside a smooth region at
/// all their ends, and small groups of creases where the smooth edges around bend both ways.
/// `crease_angle` in radians.
void prune_noise(ProxyMesh& proxy, const std::vector<Vec3>& normals, double crease_angle,
                 const RunContext& context);

/// Fills face_region and region_count from edge_kind.
void find_regions(ProxyMesh& proxy);

/// Fills wedges and wedge_vertex from edge_kind. The wedges of a vertex have consecutive indices,
/// in the order of the vertices; where no vertex has two they are the vertices.
void find_wedges(ProxyMesh& proxy, const Corners& corners, const RunContext& context);

/// Gives each flat face a wedge of its own where the triangles of a wedge lean as those at the tip
/// of a cone do, which has no normal (tips.h). `crease_angle` in radians. Cost: a pass over the
/// corners.
void find_tips(ProxyMesh& proxy, const std::vector<Vec3>& normals, double crease_angle,
               const RunContext& context);

/// Fills wedge_sagitta from the wedge normals.
void find_sagitta(ProxyMesh& proxy, const Corners& corners, const RunContext& context);

}  // namespace burin
