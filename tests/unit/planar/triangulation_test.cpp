#include <burin/planar/even_odd.h>
#include <burin/planar/growing_triangulation.h>
#include <burin/planar/near_lines.h>
#include <burin/planar/segment_in_box.h>
#include <burin/planar/triangulate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace burin {
namespace {

double area(Vec2 a, Vec2 b, Vec2 c) { return 0.5 * cross2(b - a, c - a); }

double area(const Triangulated& out, std::vector<Vec2> points) {
  points.insert(points.end(), out.added.begin(), out.added.end());
  return std::accumulate(out.triangles.begin(), out.triangles.end(), 0.0,
                         [&](double sum, const auto& t) {
                           return sum + area(points[t[0]], points[t[1]], points[t[2]]);
                         });
}

/// The edges of a ring of consecutive points, counterclockwise or, `back`, clockwise.
void add_ring(std::vector<DirectedEdge>& edges, std::uint32_t first, std::uint32_t count,
              bool back = false) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = first + i, b = first + (i + 1) % count;
    edges.push_back(back ? DirectedEdge{b, a} : DirectedEdge{a, b});
  }
}

const std::vector<Vec2> kTwoSquares{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {3, 3}, {1, 3}};

TEST(Triangulate, LeavesOutAHoleAndCountsIslandsOnce) {
  std::vector<DirectedEdge> hole, island;
  add_ring(hole, 0, 4);
  add_ring(hole, 4, 4, true);
  add_ring(island, 0, 4);
  add_ring(island, 4, 4);
  EXPECT_DOUBLE_EQ(area(triangulate(kTwoSquares, hole), kTwoSquares), 12);
  EXPECT_DOUBLE_EQ(area(triangulate(kTwoSquares, island), kTwoSquares), 16);
}

TEST(Triangulate, HasAPointWhereEdgesCross) {
  // A figure of eight: the left loop is wound once, the right one -1 times.
  const std::vector<Vec2> points{{0, 1}, {0, -1}, {2, 1}, {2, -1}};
  std::vector<DirectedEdge> edges;
  add_ring(edges, 0, 4);
  const Triangulated out = triangulate(points, edges);
  ASSERT_EQ(out.added.size(), 1u);
  EXPECT_NEAR(glm::distance(out.added[0], Vec2(1, 0)), 0, 1e-15);
  EXPECT_NEAR(area(out, points), 1, 1e-15);
}

TEST(GrowingTriangulation, KeepsPointsAndKnowsItsTriangles) {
  GrowingTriangulation growing;
  const std::vector<std::array<std::uint32_t, 2>> square{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  growing.add(std::span(kTwoSquares).first(4), square);
  const PlanarMesh first = growing.mesh();
  ASSERT_EQ(first.triangles.size(), 2u);
  const std::vector<Vec2> ends{{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  growing.add(ends, std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {2, 3}});
  const PlanarMesh second = growing.mesh();
  ASSERT_EQ(second.points.size(), 5u);
  EXPECT_TRUE(std::equal(first.points.begin(), first.points.end(), second.points.begin()));
  EXPECT_EQ(second.points[4], Vec2(2, 2));
  ASSERT_EQ(second.triangles.size(), 4u);
  for (std::size_t t = 0; t < 4; ++t) {
    EXPECT_EQ(second.before[t], -1);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(second.constrained[t][i]);
      const std::int32_t next = second.beyond[t][i];
      if (next < 0) continue;
      const auto& back = second.beyond[static_cast<std::size_t>(next)];
      EXPECT_NE(std::find(back.begin(), back.end(), static_cast<std::int32_t>(t)), back.end());
    }
  }
  const PlanarMesh same = growing.mesh();
  for (std::size_t t = 0; t < 4; ++t) EXPECT_EQ(same.before[t], static_cast<std::int32_t>(t));
}

TEST(EvenOdd, CountsEachCornerOnce) {
  const std::vector<Vec2> ring{{0, 0}, {2, -1}, {4, 0}, {2, 1}};
  const auto inside = [&](Vec2 p) {
    bool in = false;
    for (std::size_t i = 0; i < 4; ++i) in ^= crosses_ray(ring[i], ring[(i + 1) % 4], p);
    return in;
  };
  EXPECT_TRUE(inside({1, 0}));  // the ray runs through a corner
  EXPECT_FALSE(inside({-1, 0}));
  EXPECT_FALSE(inside({5, 0}));
  EXPECT_FALSE(inside({1, 0.9}));
}

TEST(SegmentInBox, CutsAtTheBorders) {
  const Box2 box{Vec2(0), Vec2(2)};
  const auto across = segment_in_box({-1, 1}, {3, 1}, box);
  ASSERT_TRUE(across);
  EXPECT_DOUBLE_EQ(across->first, 0.25);
  EXPECT_DOUBLE_EQ(across->second, 0.75);
  EXPECT_FALSE(segment_in_box({-1, 3}, {3, 3}, box));
  EXPECT_FALSE(segment_in_box({-2, 1}, {1, 4}, box));
}

TEST(NearLines, FindsTheNearestWithinReachAndFreeEnds) {
  const std::vector<Polyline> lines{{{0, 0}, {10, 0}}, {{10, 0.2}, {10, 5}}};
  const NearLines grid(lines, 0.5);
  EXPECT_DOUBLE_EQ(grid.distance({3, 0.3}), 0.3);
  EXPECT_TRUE(std::isinf(grid.distance({3, 0.6})));
  EXPECT_FALSE(grid.near({3, 0.3}, [](std::size_t line, std::size_t) { return line == 1; }));
  const std::vector<std::size_t> all{0, 1};
  const std::vector<LineEnd> ends = free_ends(lines, grid, all, 1);
  ASSERT_EQ(ends.size(), 2u);  // where the lines meet neither is free
  EXPECT_EQ(ends[0].line, 0u);
  EXPECT_FALSE(ends[0].last);
  EXPECT_EQ(ends[1].line, 1u);
  EXPECT_TRUE(ends[1].last);
}

}  // namespace
}  // namespace burin
