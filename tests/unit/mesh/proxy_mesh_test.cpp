#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/mesh/proxy_mesh.h>

#include <burin_test/irregular.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

namespace burin {
namespace {

ProxyMesh creased_proxy(TriMesh mesh, double crease_angle = 30) {
  const RunContext context;
  return build_proxy(std::move(mesh), {.crease_angle = crease_angle}, context);
}

std::int64_t count_edges(const ProxyMesh& proxy, EdgeKind kind) {
  std::int64_t count = 0;
  for (std::size_t h = 0; h < proxy.edge_kind.size(); ++h) {
    const HalfEdge o = proxy.topology.opposite[h];
    if (proxy.edge_kind[h] == kind && (o == kNoHalfEdge || o > static_cast<HalfEdge>(h))) ++count;
  }
  return count;
}

void expect_opposites_agree(const ProxyMesh& proxy) {
  for (std::size_t h = 0; h < proxy.topology.opposite.size(); ++h) {
    const HalfEdge o = proxy.topology.opposite[h];
    if (o == kNoHalfEdge) continue;
    const auto he = static_cast<HalfEdge>(h);
    ASSERT_EQ(proxy.topology.opposite[static_cast<std::size_t>(o)], he);
    ASSERT_EQ(origin(proxy.mesh, o), origin(proxy.mesh, next_in_face(he)));
    ASSERT_EQ(proxy.edge_kind[h], proxy.edge_kind[static_cast<std::size_t>(o)]);
  }
}

/// A prism over the L of six corners, height 1; its inner corner makes one concave edge.
TriMesh l_prism() {
  const Vec2 outline[6] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  TriMesh m;
  for (int z = 0; z < 2; ++z) {
    for (const Vec2& p : outline) m.positions.push_back({p.x, p.y, z});
  }
  const Triangle cap[4] = {{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}};
  for (const Triangle& t : cap) {
    m.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
    m.triangles.push_back({t[0], t[2], t[1]});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    m.triangles.push_back({i, j, j + 6});
    m.triangles.push_back({i, j + 6, i + 6});
  }
  return m;
}

TEST(ProxyMesh, BoxHasTwelveConvexCreasesSixRegionsAndTwentyFourWedges) {
  const ProxyMesh proxy = creased_proxy(test::box({0, 0, 0}, {1, 2, 3}));
  expect_opposites_agree(proxy);
  EXPECT_EQ(count_edges(proxy, EdgeKind::ConvexCrease), 12);
  EXPECT_EQ(count_edges(proxy, EdgeKind::ConcaveCrease), 0);
  EXPECT_EQ(count_edges(proxy, EdgeKind::Boundary), 0);
  EXPECT_EQ(count_edges(proxy, EdgeKind::Smooth), 6);
  EXPECT_EQ(proxy.region_count, 6);
  ASSERT_EQ(proxy.wedge_vertex.size(), 24u);
  EXPECT_EQ(proxy.topology.component_closed, std::vector<std::uint8_t>{1});
  for (std::uint32_t f = 0; f < 12; ++f) {
    for (const std::uint32_t w : proxy.wedges[f]) {
      EXPECT_EQ(glm::length(proxy.wedge_normal[w] - proxy.mesh.normal(f)), 0);
      EXPECT_EQ(proxy.wedge_sagitta[w], 0);
    }
  }
}

TEST(ProxyMesh, InsideOutBoxHasConcaveCreases) {
  TriMesh m = test::box({0, 0, 0}, {1, 2, 3});
  for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(count_edges(creased_proxy(m), EdgeKind::ConcaveCrease), 12);
}

TEST(ProxyMesh, LPrismHasOneConcaveCrease) {
  const ProxyMesh proxy = creased_proxy(l_prism());
  EXPECT_EQ(count_edges(proxy, EdgeKind::ConvexCrease), 17);
  EXPECT_EQ(count_edges(proxy, EdgeKind::ConcaveCrease), 1);
  EXPECT_EQ(proxy.region_count, 8);
}

TEST(ProxyMesh, CylinderHasTwoCreaseCirclesAndThreeRegions) {
  const ProxyMesh proxy = creased_proxy(test::cylinder(5, 20, 64));
  expect_opposites_agree(proxy);
  EXPECT_EQ(count_edges(proxy, EdgeKind::ConvexCrease), 128);
  EXPECT_EQ(proxy.region_count, 3);
  EXPECT_EQ(proxy.wedge_vertex.size(), 64u * 4 + 2);
  for (std::size_t w = 0; w < proxy.wedge_vertex.size(); ++w) {
    const Vec3 n = proxy.wedge_normal[w];
    EXPECT_NEAR(glm::length(n), 1, 1e-12);
    if (std::abs(n.z) > 0.5) {
      EXPECT_EQ(std::abs(n.z), 1);
      EXPECT_EQ(proxy.wedge_sagitta[w], 0);
    }
  }
}

TEST(ProxyMesh, OpenMeshHasBoundaries) {
  const auto sheet = test::grid(5, 4, false, false,
                                [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
  const ProxyMesh proxy = creased_proxy(test::joined(sheet, test::box({10, 0, 0}, {11, 1, 1})));
  EXPECT_EQ(count_edges(proxy, EdgeKind::Boundary), 2 * (4 + 3));
  EXPECT_EQ(proxy.topology.component_closed, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_FALSE(proxy.closed(0));
  EXPECT_TRUE(proxy.closed(static_cast<std::uint32_t>(sheet.triangles.size())));
  EXPECT_EQ(proxy.region_count, 7);
}

TEST(ProxyMesh, TorusIsOneRegionWhoseWedgesAreItsVertices) {
  const ProxyMesh proxy = creased_proxy(test::torus(10, 3, 60, 40));
  EXPECT_EQ(proxy.region_count, 1);
  EXPECT_EQ(proxy.wedges, proxy.mesh.triangles);
  for (std::size_t w = 0; w < proxy.wedge_vertex.size(); ++w) {
    const Vec3 p = proxy.mesh.positions[w];
    const Vec3 ring = 10.0 * glm::normalize(Vec3(p.x, p.y, 0));
    EXPECT_GT(glm::dot(proxy.wedge_normal[w], glm::normalize(p - ring)), std::cos(0.02));
  }
}

TEST(ProxyMesh, InterpolatesPositionAndNormal) {
  const ProxyMesh proxy = creased_proxy(test::torus(10, 3, 60, 40));
  const Vec3 third(1.0 / 3);
  EXPECT_NEAR(glm::length(proxy.normal(7, third)), 1, 1e-15);
  EXPECT_GT(glm::dot(proxy.normal(7, third), proxy.mesh.normal(7)), 0.999);
  const Triangle& t = proxy.mesh.triangles[7];
  const Vec3 mean =
      (proxy.mesh.positions[t[0]] + proxy.mesh.positions[t[1]] + proxy.mesh.positions[t[2]]) / 3.0;
  EXPECT_LT(glm::length(proxy.position(7, third) - mean), 1e-12);
}

TEST(ProxyMesh, SliverTakesTheNormalOfItsNeighbour) {
  // A unit square of two triangles with a sliver, bent out of the plane, between them.
  TriMesh m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1e-7}};
  m.triangles = {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}};
  const ProxyMesh proxy = creased_proxy(m);
  EXPECT_EQ(proxy.region_count, 1);
  EXPECT_EQ(count_edges(proxy, EdgeKind::ConvexCrease), 0);
}

TEST(ProxyMesh, AFoldBetweenTwoTrianglesIsACrease) {
  TriMesh m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 1}};
  m.triangles = {{0, 1, 2}, {1, 0, 3}};
  EXPECT_EQ(count_edges(creased_proxy(m), EdgeKind::ConcaveCrease), 1);
}

TEST(ProxyMesh, SharpEdgesOfNoiseAreNoCreases) {
  for (const double noise : {0.05, 0.08}) {
    const TriMesh m = test::noisy(test::irregular_torus(10, 4, 20000), noise);
    const ProxyMesh proxy = creased_proxy(m);
    std::int64_t sharp = 0;
    for (std::size_t h = 0; h < proxy.topology.opposite.size(); ++h) {
      const auto a = static_cast<std::uint32_t>(h / 3), b = face_of(proxy.topology.opposite[h]);
      sharp += a < b && test::line_angle(m.normal(a), m.normal(b)) > 30;
    }
    EXPECT_GT(sharp, 80);
    EXPECT_LE(
        count_edges(proxy, EdgeKind::ConvexCrease) + count_edges(proxy, EdgeKind::ConcaveCrease),
        sharp / 50);
    EXPECT_LE(proxy.region_count, 3);
  }
}

TEST(ProxyMesh, SmallPitsOfAPlateAreCreases) {
  // A plate of unit squares with a pyramid of four triangles pressed into one of them.
  TriMesh m = test::grid(8, 8, false, false,
                         [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
  const std::uint32_t a = 3 * 8 + 3, b = a + 8, c = b + 1, d = a + 1;
  std::erase_if(m.triangles, [&](const Triangle& t) {
    return t == Triangle{a, b, c} || t == Triangle{a, c, d};
  });
  const auto apex = static_cast<std::uint32_t>(m.positions.size());
  m.positions.push_back({3.5, 3.5, -0.5});
  for (const auto& [p, q] : {std::pair(a, b), {b, c}, {c, d}, {d, a}}) {
    m.triangles.push_back({p, q, apex});
  }
  const ProxyMesh proxy = creased_proxy(m);
  EXPECT_EQ(count_edges(proxy, EdgeKind::ConvexCrease), 4);
  EXPECT_EQ(count_edges(proxy, EdgeKind::ConcaveCrease), 4);
}

/// A prism of height 10 over the outline, whose caps are fans around their middle.
TriMesh prism(const std::vector<Vec2>& outline) {
  TriMesh m;
  const auto n = static_cast<std::uint32_t>(outline.size());
  Vec2 middle(0);
  for (const Vec2& p : outline) middle += p / static_cast<double>(n);
  for (const double z : {0.0, 10.0}) {
    for (const Vec2& p : outline) m.positions.emplace_back(p, z);
    m.positions.emplace_back(middle, z);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    m.triangles.push_back({i, j, j + n + 1});
    m.triangles.push_back({i, j + n + 1, i + n + 1});
    m.triangles.push_back({n, j, i});
    m.triangles.push_back({2 * n + 1, i + n + 1, j + n + 1});
  }
  return m;
}

/// The upright creases among `count` upright edges, counted from the outline's first point.
std::vector<bool> upright_creases(const std::vector<Vec2>& outline) {
  const ProxyMesh proxy = creased_proxy(prism(outline));
  std::vector<bool> sharp(outline.size(), false);
  for (std::size_t h = 0; h < proxy.edge_kind.size(); ++h) {
    const std::uint32_t a = origin(proxy.mesh, static_cast<HalfEdge>(h));
    const std::uint32_t b = origin(proxy.mesh, next_in_face(static_cast<HalfEdge>(h)));
    if (a + outline.size() + 1 == b && proxy.is_crease(static_cast<HalfEdge>(h))) sharp[a] = true;
  }
  return sharp;
}

/// From `start`, steps of a length at a heading in degrees.
std::vector<Vec2> walked(const std::vector<Vec2>& steps) {
  std::vector<Vec2> out{{0, 0}};
  for (const Vec2& s : steps) {
    const double a = s.y * std::numbers::pi / 180;
    out.push_back(out.back() + s.x * Vec2(std::cos(a), std::sin(a)));
  }
  return out;
}

TEST(ProxyMesh, ALoneBendBetweenFlatFacesIsACrease) {
  // A wall that bends by 20 degrees, and back at right angles.
  EXPECT_EQ(upright_creases({{0, 0}, {10, 0}, {19, 3.3}, {19, 12}, {0, 12}}),
            std::vector<bool>({true, true, true, true, true}));
  // By 12 degrees: what may be round.
  EXPECT_FALSE(upright_creases({{0, 0}, {10, 0}, {20, 2.1}, {20, 12}, {0, 12}})[1]);
}

TEST(ProxyMesh, TheEdgesOfAChamferAreCreases) {
  // 10 mm, 1 mm turned by 25 degrees, 10 mm turned by 50.
  std::vector<Vec2> outline = walked({{10, 0}, {1, 25}, {10, 50}});
  outline.emplace_back(0, outline.back().y);
  EXPECT_EQ(upright_creases(outline), std::vector<bool>({true, true, true, true, true}));
  // As wide as the faces beside it: a part of something round.
  outline = walked({{10, 0}, {10, 25}, {10, 50}});
  outline.emplace_back(-10, outline.back().y);
  EXPECT_FALSE(upright_creases(outline)[1]);
  EXPECT_FALSE(upright_creases(outline)[2]);
}

TEST(ProxyMesh, WhatIsRoundHasNoCreases) {
  // A fillet of 60 degrees in three chords between two walls.
  std::vector<Vec2> outline = walked({{10, 0}, {1, 10}, {1, 30}, {1, 50}, {10, 60}});
  outline.emplace_back(0, outline.back().y);
  const std::vector<bool> fillet = upright_creases(outline);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_FALSE(fillet[i]) << i;
  // Corners of 18 sided circles, without points where the walls touch them.
  outline = walked({{10, 0}, {1, 20}, {1, 40}, {1, 60}, {10, 80}});
  outline.emplace_back(0, outline.back().y);
  const std::vector<bool> hull = upright_creases(outline);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_FALSE(hull[i]) << i;
  // A circle of twelve, in single precision: all bends are of 30.00 degrees.
  for (const double radius : {0.1, 1.0 / 3, 7.0, 123.4}) {
    outline.clear();
    for (int i = 0; i < 12; ++i) {
      const double a = i * std::numbers::pi / 6;
      outline.emplace_back(static_cast<float>(5 + radius * std::cos(a)),
                           static_cast<float>(radius * std::sin(a)));
    }
    EXPECT_EQ(upright_creases(outline), std::vector<bool>(12, false)) << radius;
  }
}

TEST(Topology, RefusesWhatIsNotManifold) {
  const RunContext context;
  TriMesh m = test::box({0, 0, 0}, {1, 1, 1});
  m.triangles.push_back({0, 0, 1});
  EXPECT_THROW(build_topology(m, context), GeometryError);
  m.triangles.back() = {0, 1, 99};
  EXPECT_THROW(build_topology(m, context), GeometryError);
  m.triangles.back() = {0, 3, 5};
  EXPECT_THROW(build_topology(m, context), GeometryError);
  m.triangles.pop_back();
  std::swap(m.triangles[0][0], m.triangles[0][1]);
  EXPECT_THROW(build_topology(m, context), GeometryError);
}

TEST(Topology, AcceptsFansThatMeetAtAVertex) {
  TriMesh m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  m.triangles = {{0, 1, 2}, {0, 3, 4}};
  const ProxyMesh proxy = creased_proxy(m);
  EXPECT_EQ(proxy.wedge_vertex.size(), 6u);
  EXPECT_EQ(proxy.region_count, 2);
}

TEST(ProxyMesh, StopsWhenCancelled) {
  RunContext context;
  context.cancel();
  EXPECT_THROW(build_proxy(test::torus(10, 3, 60, 40), {}, context), Cancelled);
}

}  // namespace
}  // namespace burin
