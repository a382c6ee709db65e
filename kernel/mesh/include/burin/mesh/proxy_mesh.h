#pragma once
/// A mesh that knows its creases: what features, fields, tone and visibility see of any surface
/// form.

#include <burin/base/run_context.h>
#include <burin/mesh/topology.h>
#include <burin/mesh/tri_mesh.h>

#include <cstdint>
#include <vector>

namespace burin {

/// What an edge of the mesh is to the surface: inside a smooth region, a crease, or the end of the
/// surface.
enum class EdgeKind : std::uint8_t { Smooth, ConvexCrease, ConcaveCrease, Boundary };

/// Triangles, connectivity, creases, and one normal per WEDGE: the corners of a vertex that no
/// crease separates share a wedge, so that normals, curvature and fields on wedges never mix two
/// sides of a crease. Over wedges the mesh is a set of smooth patches with boundaries. Immutable
/// once built.
struct ProxyMesh {
  TriMesh mesh;
  Topology topology;
  /// For each half-edge; both half-edges of an edge agree.
  std::vector<EdgeKind> edge_kind;
  /// For each triangle the wedges of its three corners.
  std::vector<Triangle> wedges;
  /// For each wedge its vertex.
  std::vector<std::uint32_t> wedge_vertex;
  /// For each wedge the unit normal of the surface there, outward for a closed mesh.
  std::vector<Vec3> wedge_normal;
  /// For each triangle its smooth region (connected over smooth edges), numbered from 0 in order of
  /// the triangles.
  std::vector<std::int32_t> face_region;
  std::int32_t region_count = 0;
  /// For each wedge an estimate of how far, in model mm, the triangles around it lie from the true
  /// surface: the sagitta h^2 k / 8 of its longest edge h under the normals' change. Visibility
  /// offsets by it.
  std::vector<float> wedge_sagitta;
  /// Largest distance in model mm between the proxy and the form; 0 where the mesh is the form.
  double tolerance = 0;

  /// The rest is empty where the mesh is its own source. For each triangle the face of the input
  /// that it stands for; for each half-edge the edge of the input that it lies on, -1 inside faces
  /// (Smooth half-edges with an edge are smooth edges of the model); nonzero on half-edges of
  /// seams, where a face meets itself.
  std::vector<std::int32_t> source_face;
  std::vector<std::int32_t> source_edge;
  std::vector<std::uint8_t> seam;
  /// For each wedge nonzero where g (FacingFunction) is exactly zero in the view that the proxy was
  /// cut for, or where the surface has no normal (the tip of a cone): contours pass through it.
  std::vector<std::uint8_t> on_contour;
  /// For each smooth region the plane of the section that it closes, -1 of the surface itself;
  /// empty where nothing was cut.
  std::vector<std::int32_t> cut_plane;

  bool is_cut_region(std::int32_t region) const {
    return !cut_plane.empty() && cut_plane[static_cast<std::size_t>(region)] >= 0;
  }
  bool is_cut(std::uint32_t face) const { return is_cut_region(face_region[face]); }
  /// The face of the input of a triangle. Where the mesh is its own source: the smooth region; of
  /// what closes a cut, whose regions come in no order, one number a plane behind all regions.
  std::int32_t face_source(std::uint32_t face) const {
    if (!source_face.empty()) return source_face[face];
    const std::int32_t region = face_region[face];
    return is_cut_region(region) ? region_count + cut_plane[static_cast<std::size_t>(region)]
                                 : region;
  }

  bool closed(std::uint32_t face) const {
    return topology.component_closed[static_cast<std::size_t>(topology.face_component[face])] != 0;
  }
  const Vec3& wedge_position(std::uint32_t wedge) const {
    return mesh.positions[wedge_vertex[wedge]];
  }
  bool is_crease(HalfEdge h) const {
    const EdgeKind k = edge_kind[static_cast<std::size_t>(h)];
    return k == EdgeKind::ConvexCrease || k == EdgeKind::ConcaveCrease;
  }
  /// Barycentric interpolation in triangle `face`.
  Vec3 position(std::uint32_t face, Vec3 bary) const;
  Vec3 normal(std::uint32_t face, Vec3 bary) const;  // unit
};

struct ProxyOptions {
  /// An edge is a crease where the normals of its two triangles differ by more than this angle in
  /// degrees, unless it belongs to a small group of creases that is noise; between flat faces that
  /// bend nowhere else from half of it on (kernel/mesh/README.md).
  double crease_angle = 30;
};

/// Builds all of the above for a manifold, oriented mesh. Normals come from a quadric fitted to the
/// wedge's neighbours; those of flat faces are exact, also where a fillet runs into them, and where
/// neighbours do not determine a fit they are averages. Averages alone do not converge on irregular
/// meshes. Throws GeometryError as build_topology does. Cost: 0.35 s per million triangles on 2
/// cores. @cite Rusinkiewicz2004, Max1999
ProxyMesh build_proxy(TriMesh mesh, const ProxyOptions& options, const RunContext& context);

/// What a form knows about the triangles of its proxy that a mesh has to guess.
struct ProxyDraft {
  TriMesh mesh;
  /// For each half-edge: the unit normal of the surface at its origin, on the side of its triangle;
  /// nonzero where g is zero or no normal exists there.
  std::vector<Vec3> corner_normal;
  std::vector<std::uint8_t> corner_on_contour;
  /// For each half-edge nonzero where the surface has a sharp edge; both sides agree.
  std::vector<std::uint8_t> sharp;
  /// As in ProxyMesh.
  std::vector<std::int32_t> source_face;
  std::vector<std::int32_t> source_edge;
  std::vector<std::uint8_t> seam;
  double tolerance = 0;
};

/// Builds the proxy of an exact form: edges are creases where the draft says so (convex or concave
/// by the corner normals), the normal of a wedge is the mean of its corners', a wedge is on the
/// contour where one of its corners is. `wedge_sagitta` is estimated from the normals. Throws
/// GeometryError as build_topology does. Cost: 0.2 s per million triangles.
ProxyMesh assemble_proxy(ProxyDraft draft, const RunContext& context);

}  // namespace burin
