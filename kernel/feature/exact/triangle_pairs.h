#pragma once
// Where the triangles of two meshes pass through each other, decided exactly.

#include <burin/base/run_context.h>
#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace burin {

/// A point where an edge of one mesh pierces a triangle of the other. The same for all triangles
/// that share the edge, so that segments join without any search for near points.
struct Piercing {
  /// Whether the edge is one of mesh b.
  bool edge_of_b = false;
  /// The smaller of the edge's half-edges.
  HalfEdge edge = kNoHalfEdge;
  std::uint32_t face = 0;
  Vec3 position{0};

  auto key() const { return std::tuple(edge_of_b, edge, face); }
};

/// A segment in which two triangles pass through each other.
struct PairSegment {
  std::uint32_t face_a = 0, face_b = 0;
  Piercing from, to;
};

/// All segments between the triangles `faces_a` of `a` and `faces_b` of `b`, in order of their
/// faces. Every case of contact (a vertex on a plane, coplanar triangles, edges that meet) is
/// decided as if `a` were moved by (e, e^2, e^3) for an e smaller than any length: so every edge
/// pierces a triangle or does not, and the segments of closed meshes form closed curves. Cost: n
/// log n and one exact test for each pair of triangles with overlapping boxes. @cite
/// Edelsbrunner1990, CGAL
std::vector<PairSegment> intersect_triangles(const ProxyMesh& a,
                                             std::span<const std::uint32_t> faces_a,
                                             const ProxyMesh& b,
                                             std::span<const std::uint32_t> faces_b,
                                             const RunContext& context);

}  // namespace burin
