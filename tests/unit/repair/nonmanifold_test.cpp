#include <burin/repair/repair.h>

#include <burin_test/mesh_checks.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

struct Separated {
  TriMesh mesh;
  Diagnostics diagnostics;
  test::MeshNumbers numbers;
  std::int64_t count(const char* code) const { return test::count_of(diagnostics, code); }
};

Separated separate(const TriMesh& m) {
  Separated r;
  const RunContext context;
  r.mesh = repair(test::unshared(m), {}, r.diagnostics, context);
  r.numbers = test::numbers(r.mesh);  // throws unless it is manifold
  return r;
}

TEST(NonManifold, SolidsThatTouchAtAVertexComeApart) {
  const Separated r =
      separate(test::joined(test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 1}, {2, 2, 2})));
  EXPECT_EQ(r.count("mesh.nonmanifold_vertices"), 1);
  EXPECT_EQ(r.numbers.components, 2);
  EXPECT_EQ(r.numbers.boundary_edges, 0);
  EXPECT_EQ(r.numbers.euler, 4);
}

TEST(NonManifold, SolidsThatTouchAtAnEdgeComeApartClosed) {
  for (const double scale : {1e-3, 1.0, 1e4}) {
    for (const double away : {0.0, 1e5}) {
      TriMesh m = test::joined(test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1}));
      m = test::mapped(m, [&](Vec3 p) { return scale * p + Vec3(away); });
      const Separated r = separate(m);
      EXPECT_EQ(r.count("mesh.nonmanifold_edges"), 1);
      EXPECT_EQ(r.numbers.components, 2);
      EXPECT_EQ(r.numbers.boundary_edges, 0);
      EXPECT_NEAR(r.numbers.volume / std::pow(scale, 3), 2, 1e-2);
    }
  }
}

TEST(NonManifold, SolidsThatShareAWallStayClosed) {
  const TriMesh a = test::box({0, 0, 0}, {1, 1, 1}), b = test::box({1, 0, 0}, {2, 1, 1});
  const Separated r = separate(test::joined(a, b));
  EXPECT_EQ(r.numbers.boundary_edges, 0);
  EXPECT_EQ(r.numbers.components, 2);
  EXPECT_NEAR(r.numbers.volume, 2, 1e-12);
  EXPECT_EQ(r.count("mesh.duplicate_faces"), 0);
}

TEST(NonManifold, FinOnAPlateEndsThereAndThePlateGoesOn) {
  TriMesh m = test::grid(5, 3, false, false,
                         [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
  const auto n = static_cast<std::uint32_t>(m.positions.size());
  m.positions.push_back({2, 0, 1});
  m.positions.push_back({2, 1, 1});
  m.triangles.push_back({6, 7, n});
  m.triangles.push_back({7, n + 1, n});
  const Separated r = separate(m);
  EXPECT_EQ(r.count("mesh.nonmanifold_edges"), 1);
  EXPECT_EQ(r.numbers.components, 2);
  EXPECT_EQ(r.numbers.boundary_edges, 12 + 4);
}

TEST(NonManifold, ThreeBoxesAroundAnEdge) {
  // Three quarters of the space around the edge are solid, in three pieces that share walls.
  TriMesh m = test::box({0, 0, 0}, {1, 1, 1});
  m = test::joined(m, test::box({-1, 0, 0}, {0, 1, 1}));
  m = test::joined(m, test::box({-1, -1, 0}, {0, 0, 1}));
  const Separated r = separate(m);
  EXPECT_EQ(r.numbers.boundary_edges, 0);
  EXPECT_NEAR(r.numbers.volume, 3, 1e-12);
}

TEST(NonManifold, EdgeThatASurfaceComesByTwiceIsToldApart) {
  // A tube bent to a ring whose ends meet in one edge: the fan of each end of the edge passes it
  // twice.
  TriMesh m = test::box({0, 0, 0}, {3, 1, 1});
  m = test::joined(m, test::box({3, 1, 0}, {4, 2, 1}));
  m = test::joined(m, test::box({4, 0, 0}, {5, 1, 1}));
  m = test::joined(m, test::box({2.5, -2, 0}, {5.5, 0, 1}));
  const Separated r = separate(m);
  EXPECT_EQ(r.numbers.boundary_edges, 0);
  EXPECT_NEAR(r.numbers.volume, 3 + 1 + 1 + 6, 1e-12);
}

TEST(NonManifold, TriangleWithoutAreaLeavesNoHole) {
  // The top of a box whose rim is cut at a T: the cap 4-m-5 has no area but closes the surface.
  TriMesh m = test::box({0, 0, 0}, {2, 2, 2});
  const std::uint32_t middle = 8;
  m.positions.push_back({1, 0, 2});  // on the edge 4-5
  std::erase(m.triangles, Triangle{4, 5, 7});
  m.triangles.push_back({4, middle, 7});
  m.triangles.push_back({middle, 5, 7});
  m.triangles.push_back({4, 5, middle});
  const Separated r = separate(m);
  EXPECT_EQ(r.count("mesh.zero_area_faces"), 1);
  EXPECT_EQ(r.count("mesh.holes"), 0);
  EXPECT_EQ(r.numbers.boundary_edges, 0);
  EXPECT_EQ(r.numbers.euler, 2);
  EXPECT_NEAR(r.numbers.volume, 8, 1e-12);
  for (std::uint32_t t = 0; t < r.mesh.triangles.size(); ++t) EXPECT_GT(r.mesh.area(t), 0.1);
}

TEST(NonManifold, ChainOfTrianglesWithoutArea) {
  // A fan of caps over the corners of a finely cut edge.
  TriMesh m = test::box({0, 0, 0}, {2, 2, 2});
  std::erase(m.triangles, Triangle{4, 5, 7});
  constexpr std::uint32_t kCuts = 9;
  std::uint32_t last = 4;
  for (std::uint32_t i = 1; i <= kCuts; ++i) {
    const auto next = static_cast<std::uint32_t>(m.positions.size());
    m.positions.push_back({2.0 * i / (kCuts + 1), 0, 2});
    m.triangles.push_back({last, next, 7});
    if (last != 4) m.triangles.push_back({4, next, last});
    last = next;
  }
  m.triangles.push_back({last, 5, 7});
  m.triangles.push_back({4, 5, last});
  const Separated r = separate(m);
  EXPECT_EQ(r.count("mesh.zero_area_faces"), kCuts);
  EXPECT_EQ(r.numbers.boundary_edges, 0);
  EXPECT_NEAR(r.numbers.volume, 8, 1e-12);
}

TEST(NonManifold, VerticesCloserThanRoundingAreOne) {
  TriMesh m = test::box({0, 0, 0}, {2, 2, 2});
  const auto n = static_cast<std::uint32_t>(m.positions.size());
  m.positions.push_back({2, std::nextafter(2.0, 3.0), 2});  // beside vertex 7
  std::erase(m.triangles, Triangle{4, 5, 7});
  std::erase(m.triangles, Triangle{4, 7, 6});
  m.triangles.push_back({4, 5, 7});
  m.triangles.push_back({4, 7, n});
  m.triangles.push_back({4, n, 6});
  std::erase(m.triangles, Triangle{2, 6, 7});
  m.triangles.push_back({2, 6, n});
  m.triangles.push_back({2, n, 7});
  const Separated r = separate(m);
  EXPECT_EQ(r.mesh.triangles.size(), 12u);
  EXPECT_EQ(r.numbers.boundary_edges, 0);
  EXPECT_EQ(r.numbers.euler, 2);
}

}  // namespace
}  // namespace burin
