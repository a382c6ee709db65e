#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>

#include <burin_test/shapes.h>
#include <burin_test/turned.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

TEST(MeshForm, BoundsInAnyAxes) {
  const MeshForm form(test::box({-1, 0, 2}, {3, 5, 4}));
  const Box3 plain = form.bounds(Mat3(1));
  EXPECT_EQ(plain.min, Vec3(-1, 0, 2));
  EXPECT_EQ(plain.max, Vec3(3, 5, 4));
  // The rows of the matrix are the axes y, z, x; GLM is filled column by column.
  const Box3 turned =
      form.bounds(glm::transpose(Mat3(Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0))));
  EXPECT_EQ(turned.min, Vec3(0, 2, -1));
  EXPECT_EQ(turned.max, Vec3(5, 4, 3));
}

TEST(MeshForm, WithoutCurvatureEveryPointIsUmbilic) {
  RunContext context;
  const auto s = MeshForm(test::torus(3, 1, 40, 20)).realise({.curvature = false}, context);
  const Frame f = s->frame(s->lift({100, {0.2, 0.3, 0.5}}));
  EXPECT_TRUE(f.umbilic);
  EXPECT_EQ(f.confidence, 0);
  EXPECT_NEAR(glm::length(f.normal), 1, 1e-14);
  EXPECT_NEAR(glm::dot(f.normal, f.d1), 0, 1e-14);
  EXPECT_NEAR(glm::dot(f.normal, glm::cross(f.d1, f.d2)), 1, 1e-14);
}

TEST(MeshForm, NamesItsStages) {
  RunContext context;
  MeshForm(test::torus(3, 1, 40, 20)).realise({}, context);
  ASSERT_FALSE(context.stages().empty());
  EXPECT_EQ(context.stages().front().stage, RunStage::Build);
}

TEST(MeshForm, ACancelledRunThrows) {
  RunContext context;
  context.cancel();
  EXPECT_THROW(MeshForm(test::torus(3, 1, 40, 20)).realise({}, context), Cancelled);
}

// How far the middles of the edges and triangles of a proxy lie from where a function says that
// they should.
template <class Off>
double farthest(const ProxyMesh& proxy, Off off) {
  double most = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    for (const Vec3 bary :
         {Vec3(1.0 / 3), Vec3(0.5, 0.5, 0), Vec3(0, 0.5, 0.5), Vec3(0.5, 0, 0.5)}) {
      most = std::max(most, std::abs(off(proxy.position(f, bary))));
    }
  }
  return most;
}

TEST(MeshForm, CoarseFacetsFollowTheSurfaceThatTheyStandFor) {
  RunContext context;
  const MeshForm ball(test::ellipsoid({20, 20, 20}, 32, 16));
  const auto off = [](Vec3 p) { return glm::length(p) - 20; };
  const auto coarse = ball.realise({.tolerance = 1}, context);
  EXPECT_EQ(coarse->proxy().mesh.triangles.size(), ball.mesh().triangles.size());
  const double facets = farthest(coarse->proxy(), off);
  EXPECT_GT(facets, 0.15);
  std::size_t triangles = ball.mesh().triangles.size();
  for (const double tolerance : {0.1, 0.05, 0.02}) {
    const auto fine = ball.realise({.tolerance = tolerance}, context);
    const ProxyMesh& proxy = fine->proxy();
    EXPECT_GT(proxy.mesh.triangles.size(), triangles);
    triangles = proxy.mesh.triangles.size();
    // The patches themselves lie up to 0.03 mm off.
    EXPECT_LT(farthest(proxy, off), 1.5 * tolerance + 0.03) << tolerance;
    EXPECT_TRUE(proxy.closed(0));
    EXPECT_EQ(proxy.region_count, 1);
    for (std::size_t w = 0; w < proxy.wedge_normal.size(); ++w) {
      const Vec3 radial = glm::normalize(proxy.wedge_position(static_cast<std::uint32_t>(w)));
      EXPECT_GT(glm::dot(proxy.wedge_normal[w], radial), 0.999);
    }
    for (const Frame& f : fine->wedge_frames(context)) EXPECT_NEAR(f.k1, 1.0 / 20, 0.01);
  }
}

// As where the diagonal of another solid's facet was cut with the rim.
TEST(MeshForm, ACornerOnTheChordOfARimDoesNotDentIt) {
  TriMesh mesh = test::cylinder(10, 20, 16);
  const auto corner = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(glm::mix(mesh.positions[1], mesh.positions[3], 0.3));
  std::erase(mesh.triangles, Triangle{0, 3, 1});
  std::erase(mesh.triangles, Triangle{33, 1, 3});
  for (const Triangle& t : {Triangle{0, 3, corner}, Triangle{0, corner, 1}, Triangle{33, 1, corner},
                            Triangle{33, corner, 3}}) {
    mesh.triangles.push_back(t);
  }
  RunContext context;
  const auto surface = MeshForm(mesh).realise({.tolerance = 0.01}, context);
  const ProxyMesh& proxy = surface->proxy();
  for (std::size_t i = 0; i < proxy.edge_kind.size(); ++i) {
    const auto h = static_cast<HalfEdge>(i);
    if (!proxy.is_crease(h)) continue;
    const Vec3 middle = 0.5 * (proxy.mesh.positions[origin(proxy.mesh, h)] +
                               proxy.mesh.positions[origin(proxy.mesh, next_in_face(h))]);
    EXPECT_NEAR(std::hypot(middle.x, middle.y), 10, 0.02);  // the chords are 0.19 inside
  }
}

TEST(MeshForm, RoundedFacetsKeepCreasesRegionsAndFlatFaces) {
  RunContext context;
  const MeshForm can(test::cylinder(10, 30, 24));
  const auto coarse = can.realise({.tolerance = 1}, context);
  const auto fine = can.realise({.tolerance = 0.01}, context);
  const ProxyMesh &a = coarse->proxy(), &b = fine->proxy();
  EXPECT_GT(b.mesh.triangles.size(), a.mesh.triangles.size());
  EXPECT_EQ(b.region_count, 3);
  EXPECT_EQ(b.region_count, a.region_count);
  EXPECT_LT(farthest(b,
                     [](Vec3 p) {
                       const double r = glm::length(Vec2(p.x, p.y));
                       return r > 9.5 ? r - 10 : 0;
                     }),
            0.02);
  double rims = 0;
  for (HalfEdge h = 0; h < static_cast<HalfEdge>(b.edge_kind.size()); ++h) {
    if (!b.is_crease(h)) continue;
    EXPECT_EQ(b.edge_kind[static_cast<std::size_t>(h)], EdgeKind::ConvexCrease);
    rims += glm::distance(b.mesh.positions[origin(b.mesh, h)],
                          b.mesh.positions[origin(b.mesh, next_in_face(h))]);
  }
  EXPECT_NEAR(rims, 2 * 2 * 2 * test::kPi * 10, 0.1);  // two rims, seen from both sides
  const MeshForm block(test::box({0, 0, 0}, {1, 2, 3}));
  EXPECT_EQ(block.realise({.tolerance = 1e-6}, context)->proxy().mesh.triangles.size(), 12U);
}

// As OpenSCAD makes the sum of a box and a ball: sides that bend by 30 degrees into their fillets.
TEST(MeshForm, FlatFacesBesideCoarseFilletsKeepTheirNormals) {
  TriMesh mesh = test::turned(test::sphere_profile(3, 12), 12);
  const double turn = test::kPi / 12;
  for (Vec3& p : mesh.positions) {
    p = Vec3(std::cos(turn) * p.x - std::sin(turn) * p.y,
             std::sin(turn) * p.x + std::cos(turn) * p.y, p.z);
    p += Vec3(std::copysign(15, p.x), std::copysign(10, p.y), std::copysign(5, p.z));
  }
  RunContext context;
  const auto s = MeshForm(mesh).realise({.tolerance = 0.01, .curvature = false}, context);
  const ProxyMesh& proxy = s->proxy();
  ASSERT_GT(proxy.mesh.triangles.size(), 4 * mesh.triangles.size()) << "fillets are divided";
  double area = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const Vec3 n = proxy.mesh.normal(f);
    if (std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) < 1 - 1e-9) continue;
    area += proxy.mesh.area(f);
    for (const std::uint32_t w : proxy.wedges[f]) {
      EXPECT_LT(glm::distance(proxy.wedge_normal[w], n), 1e-3) << proxy.wedge_position(w).z;
    }
  }
  EXPECT_GT(area, 2 * (30 * 20 + 30 * 10 + 20 * 10));
}

TEST(MeshForm, StripsOfACylinderAreStraightUpToACoarseFillet) {
  std::vector<Vec2> profile = {{10, 0}};
  for (const double a : {0.0, 30.0, 60.0, 90.0}) {
    const double angle = a * test::kPi / 180;
    profile.push_back({8 + 2 * std::cos(angle), 30 + 2 * std::sin(angle)});
  }
  RunContext context;
  const auto s =
      MeshForm(test::turned(profile, 24)).realise({.tolerance = 0.01, .curvature = false}, context);
  const ProxyMesh& proxy = s->proxy();
  int rim = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    if (std::abs(proxy.mesh.normal(f).z) > 1e-6) continue;
    for (const std::uint32_t w : proxy.wedges[f]) {
      rim += proxy.wedge_position(w).z > 29.9 ? 1 : 0;
      EXPECT_LT(std::abs(proxy.wedge_normal[w].z), 2e-3) << proxy.wedge_position(w).z;
    }
  }
  EXPECT_GT(rim, 48) << "edges of strips are divided";
}

TEST(MeshForm, SaysWhereRoundingIsCutShort) {
  RunContext context;
  Diagnostics diagnostics;
  const MeshForm ball(test::ellipsoid({20, 20, 20}, 8, 6));
  ball.realise({.tolerance = 1e-3, .crease_angle = 90, .diagnostics = &diagnostics}, context);
  EXPECT_TRUE(diagnostics.entries().empty());
  ball.realise({.tolerance = 1e-9, .crease_angle = 90, .diagnostics = &diagnostics}, context);
  ASSERT_EQ(diagnostics.entries().size(), 1U);
  EXPECT_EQ(diagnostics.entries()[0].code, "mesh.rounded_coarsely");
}

}  // namespace
}  // namespace burin
