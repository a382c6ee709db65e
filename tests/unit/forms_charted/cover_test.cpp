// Algorithm 1 over faces that are trimmed, welded and placed.
#include <burin/base/parallel.h>
#include <burin/forms/charted/coverage.h>
#include <burin/forms/patches/parametric_form.h>

#include <burin_test/charts.h>
#include <burin_test/nurbs_shapes.h>
#include <burin_test/uniformity.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace burin {
namespace {

using ChartPtr = std::shared_ptr<const Chart>;

std::shared_ptr<const Surface> surface_of(std::vector<ChartPtr> patches, double tolerance = 0.01) {
  RunContext context;
  return ParametricForm(std::move(patches)).realise({.tolerance = tolerance}, context);
}

std::vector<SurfacePoint> cover(const Surface& surface, std::size_t count, std::uint64_t seed) {
  return surface.cover({.count = count, .seed = seed}, RunContext());
}

TEST(CoverOfCharts, IsUniformByAreaOverATorusOfSplines) {
  const auto surface = surface_of({make_nurbs_chart(test::torus_nurbs(3, 2))});
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto points = cover(*surface, 100'000, seed);
    ASSERT_EQ(points.size(), 100'000U);
    std::vector<Vec2> shares;
    for (const SurfacePoint& p : points) shares.push_back(test::torus_shares(p.position, 3, 2));
    EXPECT_LT(std::abs(test::chi_square(shares, 20)), 3.5);
  }
}

// Triangles at a pole stand for strips of (u,v): they are drawn as such.
TEST(CoverOfCharts, IsUniformUpToThePoles) {
  const auto surface = surface_of({make_nurbs_chart(test::sphere_nurbs(5))}, 0.1);
  const auto points = cover(*surface, 100'000, 1);
  std::vector<Vec2> shares;
  for (const SurfacePoint& p : points) {
    EXPECT_NEAR(glm::length(p.position), 5, 1e-9);  // on the surface, not on its triangles
    shares.push_back(test::sphere_shares(p.position, 5));
  }
  EXPECT_LT(std::abs(test::chi_square(shares, 20)), 3.5);
}

// They are on the surface itself, however coarse the triangles that trim it.
TEST(CoverOfCharts, DoesNotDependOnHowCoarseTheTrianglesAre) {
  const auto surface = surface_of({make_nurbs_chart(test::torus_nurbs(3, 2))}, 0.3);
  std::vector<Vec2> shares;
  for (const SurfacePoint& p : cover(*surface, 200'000, 4)) {
    EXPECT_NEAR(std::hypot(std::hypot(p.position.x, p.position.y) - 3, p.position.z), 2, 1e-9);
    shares.push_back(test::torus_shares(p.position, 3, 2));
  }
  EXPECT_LT(std::abs(test::chi_square(shares, 12)), 3.5);
}

// A speed of the parameters that is far from even would fail where points were uniform in (u,v).
TEST(CoverOfCharts, IsUniformWhateverTheParameters) {
  NurbsData data;  // the unit square as (u^3, v): R is 3 u^2
  data.degree_u = 3;
  data.degree_v = 1;
  data.count_u = 4;
  data.count_v = 2;
  data.knots_u = {0, 0, 0, 0, 1, 1, 1, 1};
  data.knots_v = {0, 0, 1, 1};
  for (const double x : {0.0, 0.0, 0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) data.points.push_back({x, y, 0});
  }
  const auto surface = surface_of({make_nurbs_chart(data)});
  std::vector<Vec2> places, parameters;
  for (const SurfacePoint& p : cover(*surface, 100'000, 2)) {
    places.push_back(Vec2(p.position));
    parameters.push_back(Vec2(p.coords));
  }
  EXPECT_LT(std::abs(test::chi_square(places, 14)), 3.5);
  EXPECT_GT(test::chi_square(parameters, 14), 100);
  // What other forms do is not enough here: the patch is flat, and its triangles are few.
  places.clear();
  for (const SurfacePoint& p :
       surface->Surface::cover({.count = 100'000, .seed = 2}, RunContext())) {
    places.push_back(Vec2(p.position));
  }
  EXPECT_GT(test::chi_square(places, 14), 20);
}

TEST(CoverOfCharts, GivesTheSamePointsFirstWhereMoreAreAskedFor) {
  const auto surface = surface_of({make_nurbs_chart(test::torus_nurbs(3, 2))});
  const auto few = cover(*surface, 100, 7), many = cover(*surface, 5000, 7);
  ASSERT_EQ(few.size(), 100U);
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].position, many[i].position);
}

// Loops of one cover may run tasks that ask for another.
TEST(CoverOfCharts, MayBeAskedForByManyThreadsAtOnce) {
  const auto surface = surface_of({make_nurbs_chart(test::torus_nurbs(3, 2))});
  constexpr std::size_t kTasks = 16;
  std::vector<std::vector<SurfacePoint>> found(kTasks);
  parallel_for(kTasks, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = cover(*surface, 5000, 7);
  });
  for (const auto& points : found) {
    ASSERT_EQ(points.size(), 5000U);
    EXPECT_EQ(points.back().position, found.front().back().position);
  }
}

// Functions have no bound that is proved: their triangles are drawn by area.
TEST(CoverOfCharts, CoversWhatHasNoBound) {
  ASSERT_FALSE(proved_area_bound(*test::ellipsoid_chart(Vec3(2)), RunContext()));
  const auto surface = surface_of({test::ellipsoid_chart(Vec3(2))}, 0.002);
  std::vector<Vec2> shares;
  for (const SurfacePoint& p : cover(*surface, 50'000, 1)) {
    shares.push_back(test::sphere_shares(p.position, 2));
  }
  EXPECT_LT(std::abs(test::chi_square(shares, 14)), 3.5);
}

}  // namespace
}  // namespace burin
