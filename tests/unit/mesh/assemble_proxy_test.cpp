#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/mesh/proxy_mesh.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace burin {
namespace {

/// A draft whose corner normals are `normal(triangle, position)` and whose edges are sharp where
/// those of both sides differ.
ProxyDraft draft_of(TriMesh mesh, const std::function<Vec3(std::uint32_t, Vec3)>& normal) {
  const RunContext context;
  ProxyDraft draft;
  draft.mesh = std::move(mesh);
  const Topology topology = build_topology(draft.mesh, context);
  const std::size_t n = 3 * draft.mesh.triangles.size();
  for (std::size_t h = 0; h < n; ++h) {
    const auto half_edge = static_cast<HalfEdge>(h);
    draft.corner_normal.push_back(
        normal(face_of(half_edge), draft.mesh.positions[origin(draft.mesh, half_edge)]));
  }
  draft.corner_on_contour.assign(n, 0);
  draft.sharp.assign(n, 0);
  for (std::size_t h = 0; h < n; ++h) {
    const HalfEdge o = topology.opposite[h];
    if (o == kNoHalfEdge) continue;
    const auto other = static_cast<std::size_t>(next_in_face(o));
    draft.sharp[h] = glm::dot(draft.corner_normal[h], draft.corner_normal[other]) < 0.999;
  }
  draft.source_face.assign(draft.mesh.triangles.size(), 7);
  draft.source_edge.assign(n, -1);
  draft.seam.assign(n, 0);
  return draft;
}

ProxyDraft capped_cylinder(std::uint32_t n) {
  const TriMesh mesh = test::cylinder(2, 5, n);
  return draft_of(mesh, [mesh](std::uint32_t f, Vec3 p) {
    const Vec3 flat = mesh.normal(f);
    return std::abs(flat.z) > 0.5 ? Vec3(0, 0, flat.z > 0 ? 1 : -1) : Vec3(p.x / 2, p.y / 2, 0);
  });
}

TEST(AssembleProxy, CylinderHasItsOwnNormalsAndConvexRims) {
  const RunContext context;
  ProxyDraft draft = capped_cylinder(24);
  draft.tolerance = 0.125;
  const ProxyMesh proxy = assemble_proxy(std::move(draft), context);
  EXPECT_EQ(proxy.region_count, 3);
  EXPECT_EQ(proxy.wedge_vertex.size(), 24u * 4 + 2);
  EXPECT_EQ(std::ranges::count(proxy.edge_kind, EdgeKind::ConvexCrease), 2 * 48);
  EXPECT_EQ(std::ranges::count(proxy.edge_kind, EdgeKind::ConcaveCrease), 0);
  EXPECT_EQ(proxy.tolerance, 0.125);
  EXPECT_EQ(proxy.face_source(3), 7);
  for (std::size_t f = 0; f < proxy.wedges.size(); ++f) {
    const bool cap = std::abs(proxy.mesh.normal(static_cast<std::uint32_t>(f)).z) > 0.5;
    for (const std::uint32_t w : proxy.wedges[f]) {
      const Vec3 p = proxy.wedge_position(w);
      const Vec3 exact = cap ? Vec3(0, 0, p.z > 2 ? 1 : -1) : Vec3(p.x / 2, p.y / 2, 0);
      EXPECT_EQ(proxy.wedge_normal[w], exact);  // the mean of equal normals is that normal
      EXPECT_EQ(proxy.on_contour[w], 0);
    }
  }
}

TEST(AssembleProxy, TurnedInsideOutItsRimsAreConcave) {
  const RunContext context;
  TriMesh mesh = test::cylinder(2, 5, 24);
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  const ProxyMesh proxy = assemble_proxy(
      draft_of(mesh, [&](std::uint32_t f, Vec3) { return mesh.normal(f); }), context);
  EXPECT_EQ(std::ranges::count(proxy.edge_kind, EdgeKind::ConcaveCrease), 2 * 72);
}

TEST(AssembleProxy, BladeAndSlotAreToldApartByTheirTriangles) {
  const RunContext context;
  // Two sheets on top of each other that meet in the edge from 0 to 1.
  for (const bool blade : {true, false}) {
    TriMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 1e-9}, {0.5, 1, -1e-9}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
    if (!blade) std::swap(mesh.positions[2], mesh.positions[3]);
    const ProxyMesh proxy = assemble_proxy(
        draft_of(mesh, [](std::uint32_t f, Vec3) { return Vec3(0, 0, f == 0 ? 1 : -1); }), context);
    EXPECT_EQ(proxy.edge_kind[0], blade ? EdgeKind::ConvexCrease : EdgeKind::ConcaveCrease);
    EXPECT_EQ(proxy.edge_kind[3], proxy.edge_kind[0]);
  }
}

TEST(AssembleProxy, ApexWithoutNormalIsOnEveryContour) {
  const RunContext context;
  // A cone open at its base: apex 0, unit ring at z = -1.
  TriMesh mesh;
  mesh.positions.push_back({0, 0, 0});
  const std::uint32_t n = 16;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double u = 2 * test::kPi * i / n;
    mesh.positions.push_back({std::cos(u), std::sin(u), -1});
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  ProxyDraft draft = draft_of(mesh, [](std::uint32_t, Vec3 p) {
    return p == Vec3(0) ? Vec3(0) : glm::normalize(Vec3(p.x, p.y, 1));
  });
  draft.corner_on_contour[1] = 1;  // one corner of vertex 1: its wedge
  std::ranges::fill(draft.sharp, std::uint8_t{0});
  const ProxyMesh proxy = assemble_proxy(std::move(draft), context);
  const std::uint32_t apex = proxy.wedges[0][0];
  EXPECT_EQ(proxy.wedge_vertex.size(), n + 1u);
  EXPECT_NEAR(proxy.wedge_normal[apex].z, 1, 1e-12);
  EXPECT_EQ(proxy.on_contour[apex], 1);
  EXPECT_EQ(proxy.on_contour[proxy.wedges[0][1]], 1);
  EXPECT_EQ(std::ranges::count(proxy.on_contour, 1), 2);
  EXPECT_EQ(std::ranges::count(proxy.edge_kind, EdgeKind::Boundary), n);
}

TEST(AssembleProxy, NormalsAreTheMeanOfTheCorners) {
  const RunContext context;
  // Two patches that meet at a smooth edge where their normals differ by 2 x 0.01 rad.
  TriMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  ProxyDraft draft = draft_of(mesh, [](std::uint32_t f, Vec3) {
    return Vec3(f == 0 ? -std::sin(0.01) : std::sin(0.01), 0, std::cos(0.01));
  });
  const ProxyMesh proxy = assemble_proxy(std::move(draft), context);
  EXPECT_NEAR(glm::distance(proxy.wedge_normal[proxy.wedges[0][0]], Vec3(0, 0, 1)), 0, 1e-15);
  EXPECT_NEAR(proxy.wedge_normal[proxy.wedges[0][2]].x, -std::sin(0.01), 1e-15);
}

TEST(AssembleProxy, SameForAnyNumberOfThreads) {
  const RunContext context;
  const TriMesh mesh = test::torus(3, 1, 120, 80);
  const auto build = [&] {
    return assemble_proxy(draft_of(mesh, [&](std::uint32_t f, Vec3) { return mesh.normal(f); }),
                          context);
  };
  ProxyMesh one;
  {
    const ThreadLimit limit(1);
    one = build();
  }
  const ProxyMesh many = build();
  EXPECT_EQ(one.wedge_normal, many.wedge_normal);
  EXPECT_EQ(one.wedges, many.wedges);
  EXPECT_EQ(one.edge_kind, many.edge_kind);
  EXPECT_EQ(one.wedge_sagitta, many.wedge_sagitta);
}

TEST(AssembleProxy, RefusesThreeTrianglesAtAnEdge) {
  const RunContext context;
  ProxyDraft draft;
  draft.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  draft.mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  draft.corner_normal.assign(9, Vec3(0, 0, 1));
  draft.corner_on_contour.assign(9, 0);
  draft.sharp.assign(9, 0);
  EXPECT_THROW(assemble_proxy(std::move(draft), context), GeometryError);
}

}  // namespace
}  // namespace burin
