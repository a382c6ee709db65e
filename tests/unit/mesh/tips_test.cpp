// Vertices without one normal: tips of cones and of the fans that hulls are made of.
#include <burin/mesh/tips.h>

#include <burin_test/hulls.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

ProxyMesh tip_proxy(TriMesh mesh) {
  const RunContext context;
  return build_proxy(std::move(mesh), {}, context);
}

std::size_t count(const std::vector<std::uint8_t>& flags) {
  return static_cast<std::size_t>(std::ranges::count(flags, 1));
}

TEST(Tips, EachFaceOfAFanHasItsOwnNormalAtTheCornerOfAHull) {
  for (const std::uint32_t sides : {16u, 32u, 64u}) {
    const ProxyMesh proxy = tip_proxy(test::hull({.sides = sides}));
    for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (proxy.wedge_vertex[proxy.wedges[f][k]] >= 8) continue;
        const Vec3& normal = proxy.wedge_normal[proxy.wedges[f][k]];
        EXPECT_GT(glm::dot(normal, proxy.mesh.normal(f)), 1 - 1e-9) << sides << ' ' << f;
      }
    }
    // Four corners with a quarter of the disc and two flat triangles each.
    EXPECT_EQ(count(wedges_at_tips(proxy)), sides + 8) << sides;
  }
}

// By 22.8 degrees on two sides, where the slope is a single triangle.
TEST(Tips, TheEdgeBetweenAWallAndTheFansAboveItIsACrease) {
  for (const std::uint32_t sides : {12u, 16u, 32u, 64u}) {
    const ProxyMesh proxy = tip_proxy(test::hull({.sides = sides}));
    std::size_t creases = 0;
    for (std::size_t i = 0; i < proxy.edge_kind.size(); ++i) {
      const auto h = static_cast<HalfEdge>(i);
      const std::uint32_t a = origin(proxy.mesh, h), b = origin(proxy.mesh, next_in_face(h));
      if (std::min(a, b) < 4 || std::max(a, b) > 7) continue;
      EXPECT_TRUE(proxy.is_crease(h)) << sides << ": " << a << ' ' << b;
      ++creases;
    }
    EXPECT_EQ(creases, 8u) << sides;
  }
}

// By 24 to 45 degrees, less than the crease angle on both narrow sides.
TEST(Tips, TheRimOfADiscThatAHullSlopesFromIsACrease) {
  for (const std::uint32_t sides : {12u, 16u, 24u, 32u, 64u}) {
    const ProxyMesh proxy = tip_proxy(test::hull({.height = 4, .top = 12, .sides = sides}));
    std::size_t creases = 0;
    for (std::size_t i = 0; i < proxy.edge_kind.size(); ++i) {
      const auto h = static_cast<HalfEdge>(i);
      const HalfEdge o = proxy.topology.opposite[i];
      const bool disc = proxy.mesh.normal(face_of(h)).z > 1 - 1e-9;
      if (!disc || proxy.mesh.normal(face_of(o)).z > 1 - 1e-9) continue;
      creases += proxy.is_crease(h);
    }
    EXPECT_EQ(creases, sides);
  }
}

TEST(Tips, TheCornerOfACoarseHullIsOne) {
  const ProxyMesh proxy = tip_proxy(test::hull({.height = 4, .top = 12, .sides = 12}));
  EXPECT_EQ(count(wedges_at_tips(proxy)), 12u + 8);
}

TEST(Tips, WherePartOfAFlatFaceTouchesTheDiscIsTheNormalOfThatFace) {
  const ProxyMesh proxy = tip_proxy(test::hull({}));
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const auto k = corner_beside_tips(wedges_at_tips(proxy), proxy.wedges[f]);
    if (!k) continue;
    EXPECT_GT(glm::dot(proxy.wedge_normal[proxy.wedges[f][*k]], proxy.mesh.normal(f)), 1 - 1e-9);
  }
}

TEST(Tips, AConeHasOneAndABallHasNone) {
  for (const std::uint32_t sides : {12u, 24u, 96u}) {
    for (const double height : {5.0, 10.0}) {
      TriMesh cone;
      cone.positions = {{0, 0, height}, {0, 0, 0}};
      for (std::uint32_t i = 0; i < sides; ++i) {
        const double a = 2 * test::kPi * i / sides;
        cone.positions.emplace_back(10 * std::cos(a), 10 * std::sin(a), 0);
        cone.triangles.push_back({0, 2 + i, 2 + (i + 1) % sides});
        cone.triangles.push_back({1, 2 + (i + 1) % sides, 2 + i});
      }
      EXPECT_EQ(count(wedges_at_tips(tip_proxy(cone))), sides) << sides << ' ' << height;
    }
    EXPECT_TRUE(wedges_at_tips(tip_proxy(test::ellipsoid({10, 10, 10}, sides, sides / 2))).empty());
    EXPECT_TRUE(wedges_at_tips(tip_proxy(test::torus(10, 4, sides, sides))).empty());
    EXPECT_TRUE(wedges_at_tips(tip_proxy(test::cylinder(5, 20, sides))).empty());
  }
}

}  // namespace
}  // namespace burin
