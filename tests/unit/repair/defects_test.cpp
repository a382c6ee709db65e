#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/repair/repair.h>

#include <burin_test/mesh_checks.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <vector>

namespace burin {
namespace {

struct Repaired {
  TriMesh mesh;
  Diagnostics diagnostics;
  std::int64_t count(const char* code) const { return test::count_of(diagnostics, code); }
};

Repaired mend(PolygonSoup soup) {
  Repaired r;
  const RunContext context;
  r.mesh = repair(std::move(soup), {}, r.diagnostics, context);
  return r;
}

Repaired mend(const TriMesh& mesh) { return mend(test::soup_of(mesh)); }

const TriMesh kBox = test::box({0, 0, 0}, {2, 3, 4});

TEST(Repair, CleanMeshIsNotTouched) {
  for (const TriMesh& m : {test::torus(5, 2, 60, 30), test::ellipsoid({3, 2, 1}, 40, 20), kBox,
                           test::cylinder(3, 5, 90)}) {
    const Repaired r = mend(m);
    EXPECT_TRUE(r.diagnostics.empty());
    EXPECT_EQ(r.mesh.triangles, m.triangles);
    EXPECT_EQ(r.mesh.positions, m.positions);
  }
}

TEST(Repair, UnsharedCornersBecomeVerticesInOrder) {
  const TriMesh torus = test::torus(5, 2, 30, 20);
  const Repaired r = mend(test::unshared(torus));
  EXPECT_TRUE(r.diagnostics.empty());
  EXPECT_EQ(r.mesh.positions.size(), torus.positions.size());
  ASSERT_EQ(r.mesh.triangles.size(), torus.triangles.size());
  for (std::size_t t = 0; t < torus.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(r.mesh.positions[r.mesh.triangles[t][k]], torus.positions[torus.triangles[t][k]]);
    }
  }
  EXPECT_EQ(test::numbers(r.mesh).euler, 0);
}

TEST(Repair, PointsStayApartWhenAsked) {
  Diagnostics d;
  const RunContext context;
  const TriMesh m = repair(test::unshared(kBox), {.merge_duplicate_points = false}, d, context);
  EXPECT_EQ(test::numbers(m).components, 12);
}

TEST(Repair, UnusedPointsGo) {
  PolygonSoup soup = test::soup_of(kBox);
  soup.positions.insert(soup.positions.begin(), Vec3(100));
  for (std::uint32_t& v : soup.indices) ++v;
  const Repaired r = mend(soup);
  EXPECT_EQ(r.mesh.positions, kBox.positions);
  EXPECT_EQ(r.mesh.triangles, kBox.triangles);
}

TEST(Repair, OpenSurfaceIsReported) {
  TriMesh open = kBox;
  open.triangles.resize(10);
  const Repaired r = mend(open);
  EXPECT_EQ(r.count("mesh.open"), 4);
  EXPECT_EQ(r.mesh.triangles, open.triangles);
}

TEST(Repair, BadCoordinatesAreLeftOut) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e200}) {
    TriMesh m = test::torus(5, 2, 30, 20);
    m.positions[7].y = bad;
    const Repaired r = mend(m);
    EXPECT_EQ(r.count("mesh.bad_coordinates"), 6);
    EXPECT_EQ(r.count("mesh.open"), 6);
    EXPECT_EQ(r.mesh.triangles.size(), m.triangles.size() - 6);
  }
}

TEST(Repair, AVertexAtTheEndOfTheWorldIsLeftOut) {
  TriMesh m = test::torus(5, 2, 30, 20);
  m.positions[7].y = 1e30;
  const Repaired r = mend(m);
  EXPECT_EQ(r.count("mesh.wild_coordinates"), 6);
  EXPECT_LT(r.mesh.bounds().diagonal(), 21.0);
}

TEST(Repair, NothingLeftIsAnError) {
  TriMesh m = kBox;
  for (Vec3& p : m.positions) p.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mend(m), GeometryError);
  for (Vec3& p : m.positions) p = Vec3(1, 2, 3);
  EXPECT_THROW(mend(m), GeometryError);
  for (std::size_t i = 0; i < m.positions.size(); ++i) m.positions[i] = Vec3(1, 2, 3) * double(i);
  EXPECT_THROW(mend(m), GeometryError);
}

TEST(Repair, DegenerateAndDuplicateFacesGo) {
  TriMesh m = kBox;
  m.triangles.push_back({3, 3, 5});
  m.triangles.push_back(m.triangles[4]);
  m.triangles.push_back({m.triangles[5][1], m.triangles[5][2], m.triangles[5][0]});
  const Repaired r = mend(m);
  EXPECT_EQ(r.count("mesh.degenerate_faces"), 1);
  EXPECT_EQ(r.count("mesh.duplicate_faces"), 2);
  EXPECT_EQ(r.mesh.triangles, kBox.triangles);
}

// A box whose upper front edge has a corner on it for the top alone, closed by a triangle without
// area.
TEST(Repair, WhatTakesThePlaceOfATriangleWithoutAreaHasItsNeighboursNumber) {
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {0, 0, 4},
                    {2, 0, 4}, {2, 3, 4}, {0, 3, 4}, {1, 0, 4}};
  std::vector<std::int32_t> of;
  const auto add = [&](std::initializer_list<std::uint32_t> corners, std::int32_t number) {
    soup.indices.insert(soup.indices.end(), corners);
    soup.offsets.push_back(soup.indices.size());
    of.push_back(number);
  };
  add({0, 3, 2, 1}, 0);     // below
  add({4, 8, 5, 6, 7}, 1);  // above
  add({0, 1, 5, 4}, 2);     // in front
  add({4, 5, 8}, 6);        // the triangle without area
  add({1, 2, 6, 5}, 3);
  add({2, 3, 7, 6}, 4);
  add({3, 0, 4, 7}, 5);
  add({4, 4, 7}, 6);  // goes
  Diagnostics diagnostics;
  const TriMesh mesh = repair(std::move(soup), {}, diagnostics, RunContext(), &of);
  EXPECT_EQ(test::count_of(diagnostics, "mesh.zero_area_faces"), 1);
  ASSERT_EQ(of.size(), mesh.triangles.size());
  const std::array<Vec3, 6> out{Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(0, -1, 0),
                                Vec3(1, 0, 0),  Vec3(0, 1, 0), Vec3(-1, 0, 0)};
  for (std::uint32_t t = 0; t < of.size(); ++t) {
    EXPECT_NEAR(glm::dot(mesh.normal(t), out.at(static_cast<std::size_t>(of[t]))), 1, 1e-12);
  }
  EXPECT_EQ(std::ranges::count(of, 2), 3);
}

TEST(Repair, WholeBodyWrittenTwiceIsOne) {
  const Repaired r = mend(test::joined(kBox, kBox));
  EXPECT_EQ(r.count("mesh.duplicate_faces"), 12);
  EXPECT_EQ(r.mesh.triangles.size(), 12u);
  EXPECT_NEAR(test::numbers(r.mesh).volume, 24, 1e-12);
}

TEST(Repair, SheetDrawnFromBothSidesIsOne) {
  const TriMesh sheet = test::grid(
      5, 4, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0.1 * i * j); });
  const Repaired r = mend(test::joined(sheet, test::inverted(sheet)));
  EXPECT_EQ(r.count("mesh.duplicate_faces"), 24);
  EXPECT_EQ(r.mesh.triangles, sheet.triangles);
}

TEST(Repair, TurnedFacesAreTurnedBack) {
  TriMesh m = test::torus(5, 2, 40, 20);
  std::int64_t turned = 0;
  for (std::size_t t = 0; t < m.triangles.size(); t += 3, ++turned)
    std::swap(m.triangles[t][1], m.triangles[t][2]);
  const Repaired r = mend(m);
  EXPECT_EQ(r.count("mesh.flipped_faces"), turned);
  const test::MeshNumbers n = test::numbers(r.mesh);
  EXPECT_EQ(n.boundary_edges, 0);
  EXPECT_EQ(n.euler, 0);
  EXPECT_NEAR(n.volume, test::numbers(test::torus(5, 2, 40, 20)).volume, 1e-9);
}

TEST(Repair, TheMajorityOfAnOpenSurfaceDecides) {
  TriMesh m = test::grid(8, 8, false, false,
                         [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
  for (std::size_t t = 0; t < 60; ++t) std::swap(m.triangles[t][1], m.triangles[t][2]);
  const Repaired r = mend(m);  // 60 of 98 look down
  for (std::uint32_t t = 0; t < r.mesh.triangles.size(); ++t) EXPECT_LT(r.mesh.normal(t).z, 0);
  EXPECT_EQ(r.count("mesh.flipped_faces"), 38);
}

TEST(Repair, InsideOutBodyIsTurned) {
  const Repaired r = mend(test::inverted(kBox));
  EXPECT_EQ(r.count("mesh.inverted"), 1);
  EXPECT_NEAR(test::numbers(r.mesh).volume, 24, 1e-12);
}

TEST(Repair, CavityKeepsPointingInwards) {
  const TriMesh hollow = test::joined(test::box({0, 0, 0}, {10, 10, 10}),
                                      test::inverted(test::box({2, 2, 2}, {8, 8, 8})));
  const Repaired r = mend(hollow);
  EXPECT_TRUE(r.diagnostics.empty());
  EXPECT_NEAR(test::numbers(r.mesh).volume, 1000 - 216, 1e-9);
}

TEST(Repair, HollowBodyInsideOutIsTurnedWhole) {
  const TriMesh hollow = test::joined(test::box({0, 0, 0}, {10, 10, 10}),
                                      test::inverted(test::box({2, 2, 2}, {8, 8, 8})));
  const TriMesh with_core = test::joined(hollow, test::box({4, 4, 4}, {5, 5, 5}));
  const Repaired r = mend(test::inverted(with_core));
  EXPECT_EQ(r.count("mesh.inverted"), 3);
  EXPECT_NEAR(test::numbers(r.mesh).volume, 1000 - 216 + 1, 1e-9);
}

TEST(Repair, InvertedBodyBesideAnotherIsTurned) {
  const Repaired r = mend(test::joined(kBox, test::inverted(test::box({10, 0, 0}, {11, 1, 1}))));
  EXPECT_EQ(r.count("mesh.inverted"), 1);
  EXPECT_NEAR(test::numbers(r.mesh).volume, 25, 1e-12);
}

TEST(Repair, MoebiusBandIsCutOpen) {
  // The last row is joined to the first upside down.
  constexpr std::uint32_t kAround = 40, kAcross = 5;
  TriMesh m = test::grid(kAround, kAcross, false, false, [](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * test::kPi * i / kAround, w = (j - 2.0) / 2;
    const double r = 5 + w * std::cos(u / 2);
    return Vec3(r * std::cos(u), r * std::sin(u), w * std::sin(u / 2));
  });
  for (std::uint32_t j = 0; j + 1 < kAcross; ++j) {
    const std::uint32_t a = (kAround - 1) * kAcross + j, d = a + 1;
    const std::uint32_t b = kAcross - 1 - j, c = b - 1;
    m.triangles.push_back({a, b, c});
    m.triangles.push_back({a, c, d});
  }
  const Repaired r = mend(m);
  EXPECT_GE(r.count("mesh.nonorientable"), 4);
  const test::MeshNumbers n = test::numbers(r.mesh);
  EXPECT_EQ(n.components, 1);
  EXPECT_EQ(n.euler, 1);  // a strip
  double area = 0;
  for (std::uint32_t t = 0; t < m.triangles.size(); ++t) area += m.area(t);
  EXPECT_NEAR(n.area, area, 1e-9);
  EXPECT_EQ(r.mesh.triangles.size(), m.triangles.size());
}

TEST(Repair, ResultIsTheSameForAnyNumberOfThreads) {
  TriMesh m = test::torus(5, 2, 300, 200);
  for (std::size_t t = 0; t < m.triangles.size(); t += 7)
    std::swap(m.triangles[t][0], m.triangles[t][1]);
  m.triangles.push_back({1, 5000, 20000});
  TriMesh first;
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    const Repaired r = mend(test::unshared(m));
    if (threads == 1) first = r.mesh;
    EXPECT_EQ(r.mesh.triangles, first.triangles);
    EXPECT_EQ(r.mesh.positions, first.positions);
  }
}

TEST(Repair, CancelledRunStops) {
  RunContext context;
  context.cancel();
  Diagnostics d;
  EXPECT_THROW(repair(test::soup_of(test::torus(5, 2, 60, 30)), {}, d, context), Cancelled);
}

}  // namespace
}  // namespace burin
