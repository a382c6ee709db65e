// The OpenMesh of a whole mesh, and the rings of its wedges beside the same by counting.
#include "ring_mesh.h"

#include <burin/mesh/corners.h>

#include <burin_test/hulls.h>
#include <burin_test/irregular.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace burin {
namespace {

ProxyMesh ringed(TriMesh mesh) { return build_proxy(std::move(mesh), {}, RunContext()); }

/// Two triangles that touch at a vertex alone.
TriMesh bow_tie() {
  TriMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  return mesh;
}

/// A torus without every seventh triangle: boundaries, some of which touch at a vertex.
TriMesh torus_with_holes() {
  TriMesh mesh = test::torus(10, 4, 60, 30);
  std::vector<Triangle> kept;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (f % 7 != 0) kept.push_back(mesh.triangles[f]);
  }
  mesh.triangles = std::move(kept);
  return mesh;
}

void expect_whole(const ProxyMesh& proxy) {
  const RingMesh rings(proxy.mesh, proxy.topology.opposite, RunContext());
  ASSERT_EQ(rings.n_faces(), proxy.mesh.triangles.size());
  std::size_t inside = 0;
  for (const auto h : rings.halfedges()) {
    const RingHandle next = rings.next_halfedge_handle(h), o = rings.opposite_halfedge_handle(h);
    ASSERT_EQ(rings.prev_halfedge_handle(next), h);
    ASSERT_EQ(rings.to_vertex_handle(h), rings.from_vertex_handle(next));
    ASSERT_EQ(rings.to_vertex_handle(h), rings.from_vertex_handle(o));
    ASSERT_EQ(rings.face_handle(next), rings.face_handle(h));
    const HalfEdge corner = rings.corner(h);
    ASSERT_EQ(corner == kNoHalfEdge, rings.is_boundary(h));
    if (corner == kNoHalfEdge) continue;
    ++inside;
    ASSERT_EQ(rings.from(h), proxy.mesh.positions[origin(proxy.mesh, corner)]);
    ASSERT_EQ(rings.corner(next), next_in_face(corner));
    ASSERT_EQ(rings.corner(o), proxy.topology.opposite[static_cast<std::size_t>(corner)]);
  }
  EXPECT_EQ(inside, 3 * rings.n_faces());
  for (const auto v : rings.vertices()) {
    bool at_boundary = false;
    for (const auto h : rings.voh_range(v)) at_boundary |= rings.is_boundary(h);
    EXPECT_EQ(rings.is_boundary(v), at_boundary);
  }
}

void expect_rings_as_counted(const ProxyMesh& proxy) {
  const RingMesh rings(proxy.mesh, proxy.topology.opposite, RunContext());
  const Groups<RingHandle> walked = wedge_rings(rings, proxy, RunContext());
  const Corners counted = corners_at(proxy.wedges, proxy.wedge_vertex.size());
  ASSERT_EQ(walked.size(), counted.size());
  for (std::size_t w = 0; w < counted.size(); ++w) {
    EXPECT_TRUE(std::ranges::equal(walked[w], counted[w], {},
                                   [&](RingHandle h) { return rings.corner(h); }));
  }
}

TEST(RingMesh, IsAnOpenMeshOfAllTriangles) {
  for (const TriMesh& mesh : {bow_tie(), torus_with_holes(), test::hull({.sides = 16})}) {
    expect_whole(ringed(mesh));
  }
}

TEST(RingMesh, RingsHaveAllCornersOfTheirWedgesInOrder) {
  // Fans that touch; boundaries; creases, and tips with several wedges in one fan.
  for (const TriMesh& mesh : {bow_tie(), torus_with_holes(), test::hull({.sides = 16})}) {
    expect_rings_as_counted(ringed(mesh));
  }
}

}  // namespace
}  // namespace burin
