#include <burin/mesh/rounded_mesh.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

TEST(RoundedMesh, LiesNearerToTheSphereThanItsFacets) {
  const RunContext context;
  const ProxyMesh proxy = build_proxy(test::ellipsoid({20, 20, 20}, 32, 16), {}, context);
  const RoundedMesh rounded(proxy);
  double flat = 0, round = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    for (const Vec3 bary : {Vec3(1.0 / 3), Vec3(0.5, 0.5, 0), Vec3(0.7, 0.1, 0.2)}) {
      flat = std::max(flat, std::abs(glm::length(proxy.position(f, bary)) - 20));
      round = std::max(round, std::abs(glm::length(rounded.facet(f).at(bary)) - 20));
    }
  }
  EXPECT_GT(flat, 0.1);
  EXPECT_LT(round, 0.2 * flat);
}

TEST(RoundedMesh, HasNoGapsBetweenTrianglesAndPassesThroughTheVertices) {
  const RunContext context;
  const ProxyMesh proxy = build_proxy(test::torus(20, 8, 24, 12), {}, context);
  const RoundedMesh rounded(proxy);
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const RoundedFacet facet = rounded.facet(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<int>(k), j = (i + 1) % 3;
      const HalfEdge o = proxy.topology.opposite[3 * f + k];
      const std::uint32_t a = proxy.mesh.triangles[f][k], b = proxy.mesh.triangles[f][(k + 1) % 3];
      Vec3 corner(0), edge(0);
      corner[i] = 1;
      edge[i] = a < b ? 0.3 : 0.7;
      edge[j] = a < b ? 0.7 : 0.3;
      EXPECT_LT(glm::distance(facet.at(corner), proxy.mesh.positions[a]), 1e-12);
      EXPECT_LT(glm::distance(facet.at(edge), facet.on_edge(k, 0.7)), 1e-12);
      EXPECT_EQ(facet.on_edge(k, 0.7),
                rounded.facet(face_of(o)).on_edge(static_cast<std::size_t>(o % 3), 0.7));
    }
  }
}

TEST(RoundedMesh, ItsNormalsStandOnIt) {
  const RunContext context;
  const ProxyMesh proxy = build_proxy(test::torus(20, 8, 24, 12), {}, context);
  const RoundedMesh rounded(proxy);
  const Vec3 bary(0.2, 0.5, 0.3);
  const double step = 1e-5;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const RoundedFacet facet = rounded.facet(f);
    const Vec3 normal = glm::normalize(facet.normal_at(bary));
    EXPECT_GT(glm::dot(normal, proxy.mesh.normal(f)), 0.9);
    for (const Vec3 way : {Vec3(1, -1, 0), Vec3(0, 1, -1)}) {
      const Vec3 along = facet.at(bary + step * way) - facet.at(bary - step * way);
      EXPECT_NEAR(glm::dot(glm::normalize(along), normal), 0, 1e-7);
    }
  }
}

TEST(RoundedMesh, LeavesFlatFacesAndTheirCreasesAlone) {
  const RunContext context;
  const ProxyMesh proxy = build_proxy(test::box({0, 0, 0}, {1, 2, 3}), {}, context);
  const RoundedMesh rounded(proxy);
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const Vec3 bary(0.2, 0.5, 0.3);
    EXPECT_LT(glm::distance(rounded.facet(f).at(bary), proxy.position(f, bary)), 1e-12);
  }
}

// The side and both rims of a cylinder are round; its caps stay flat.
TEST(RoundedMesh, RoundsTheRimOfACylinder) {
  const RunContext context;
  const ProxyMesh proxy = build_proxy(test::cylinder(10, 30, 24), {}, context);
  const RoundedMesh rounded(proxy);
  const double sagitta = 10 * (1 - std::cos(test::kPi / 24));
  int rims = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const RoundedFacet facet = rounded.facet(f);
    const bool cap = std::abs(proxy.mesh.normal(f).z) > 0.5;
    const Vec3 middle = facet.at(Vec3(1.0 / 3));
    if (cap) {
      EXPECT_NEAR(middle.z, proxy.position(f, Vec3(1.0 / 3)).z, 1e-12);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = facet.on_edge(k, 0.5);
      if (cap && proxy.edge_kind[3 * f + k] == EdgeKind::Smooth) continue;
      EXPECT_NEAR(glm::length(Vec2(p.x, p.y)), 10, 0.05 * sagitta);
      rims += proxy.is_crease(static_cast<HalfEdge>(3 * f + k));
    }
  }
  EXPECT_EQ(rims, 2 * 2 * 24);
}

}  // namespace
}  // namespace burin
