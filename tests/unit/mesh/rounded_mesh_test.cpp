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
      round = std::max(round, std::abs(glm::length(rounded.on_face(f, bary)) - 20));
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
    for (int k = 0; k < 3; ++k) {
      Vec3 corner(0), edge(0);
      corner[k] = 1;
      edge[k] = 0.3;
      edge[(k + 1) % 3] = 0.7;
      const Triangle& w = proxy.wedges[f];
      const auto a = w[static_cast<std::size_t>(k)], b = w[static_cast<std::size_t>((k + 1) % 3)];
      EXPECT_LT(glm::distance(rounded.on_face(f, corner), proxy.wedge_position(a)), 1e-12);
      EXPECT_LT(glm::distance(rounded.on_face(f, edge), rounded.on_edge(a, b, 0.7)), 1e-12);
      EXPECT_LT(glm::distance(rounded.on_edge(a, b, 0.7), rounded.on_edge(b, a, 0.3)), 1e-12);
    }
  }
}

TEST(RoundedMesh, LeavesFlatFacesAndCreasesAlone) {
  const RunContext context;
  const ProxyMesh proxy = build_proxy(test::cylinder(10, 30, 24), {}, context);
  const RoundedMesh rounded(proxy);
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const Vec3 bary(0.2, 0.5, 0.3);
    EXPECT_LT(glm::distance(rounded.on_face(f, bary), proxy.position(f, bary)), 1e-12);
  }
}

}  // namespace
}  // namespace burin
