#include <burin/drawing/clip.h>
#include <burin/drawing/join.h>

#include "burin_test/drawings.h"
#include "burin_test/ring_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

using test::plain_path;

const Box2 kWindow{{0, 0}, {10, 10}};

TEST(Clip, CutsWithEverythingThatBelongsToAPoint) {
  Path p = plain_path({{-10, 5}, {5, 5}, {5, 20}});
  p.width = {0.1, 0.4, 0.7};
  p.faces = {{0, 5}, {1, 6}};
  ASSERT_FALSE(lies_in(p, kWindow));
  const std::vector<Path> pieces = clipped(p, kWindow);
  ASSERT_EQ(pieces.size(), 1u);
  const Path& q = pieces[0];
  ASSERT_EQ(q.points.size(), 3u);
  EXPECT_LT(glm::distance(q.points.front(), Vec2(0, 5)), 1e-12);
  EXPECT_LT(glm::distance(q.points.back(), Vec2(5, 10)), 1e-12);
  EXPECT_LT(glm::distance(q.points3.front(), Vec3(0, 10, 1)), 1e-12);
  EXPECT_NEAR(q.width.front(), 0.3, 1e-12);
  EXPECT_NEAR(q.width.back(), 0.5, 1e-12);
  ASSERT_EQ(q.faces.size(), 2u);
  EXPECT_EQ(q.faces[1].first_point, 1u);
  EXPECT_EQ(q.faces[1].face, 6);
  EXPECT_EQ(q.source, (SourceId{2, 5, 7}));
}

TEST(Clip, AClosedPathGivesWholePieces) {
  // It begins inside: what is left are two corners, not three pieces.
  const std::vector<Path> pieces =
      clipped(plain_path({{5, 5}, {5, 15}, {-5, 15}, {-5, 5}}, true), kWindow);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_FALSE(pieces[0].closed);
  // From where it comes in to where it leaves.
  EXPECT_LT(glm::distance(pieces[0].points.front(), Vec2(0, 5)), 1e-12);
  EXPECT_LT(glm::distance(pieces[0].points.back(), Vec2(5, 10)), 1e-12);
}

TEST(Clip, WhatIsOutsideOrTouchesACornerLeavesNothing) {
  EXPECT_TRUE(clipped(plain_path({{-5, 0}, {0, -5}}), kWindow).empty());
  EXPECT_TRUE(clipped(plain_path({{-5, 5}, {5, -5}}), kWindow).empty());
  EXPECT_TRUE(clipped(plain_path({{20, 20}, {30, 30}}), kWindow).empty());
}

TEST(Clip, InPerspectiveThePointOfTheModelIsTheOneThatIsSeen) {
  DrawingView view;
  view.projection = "perspective";
  view.direction = {0, 0, 1};
  view.eye = {0, 0, 100};
  const auto paper = [](Vec3 p) { return Vec2(p.x, p.y) * (100 / (100 - p.z)); };
  Path p;
  p.points3 = {{-4, 2, 50}, {30, 8, -40}};
  for (const Vec3& q : p.points3) p.points.push_back(paper(q));
  p.width = {0.3};
  const std::vector<Path> pieces = clipped(p, kWindow, &view);
  ASSERT_EQ(pieces.size(), 1u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(glm::distance(paper(pieces[0].points3[i]), pieces[0].points[i]), 1e-12);
  }
}

TEST(Join, RingsBecomeOneClosedPathAndTheRestStays) {
  const Path a = plain_path({{0, 0}, {5, 0}, {5, 5}});
  const Path open = plain_path({{20, 20}, {25, 20}});
  Path b =
      plain_path({{0, 0.001}, {0, 9}, {5, 5.001}});  // the other way round, ends within the grid
  b.source = {2, 9, -1};
  const std::vector<const Path*> all{&a, &open, &b};
  const JoinedPaths joined = join_rings(all);
  ASSERT_EQ(joined.paths.size(), 2u);
  const Path& ring = *joined.paths[0];
  EXPECT_TRUE(ring.closed);
  EXPECT_EQ(ring.points.size(), 4u);
  EXPECT_EQ(ring.source, b.source);  // the longer one
  EXPECT_EQ(joined.pieces[0].size(), 2u);
  EXPECT_EQ(joined.paths[1], &open);
  EXPECT_TRUE(joined.pieces[1].empty());
}

TEST(Join, LinesThatBranchDifferOrStayOpenAreLeft) {
  const Path a = plain_path({{0, 0}, {5, 0}}), b = plain_path({{5, 0}, {0, 5}}),
             c = plain_path({{0, 5}, {0, 0}});
  const Path branch = plain_path({{0, 0}, {-5, -5}});
  Path thick = c;
  thick.width = {0.6};
  const auto count = [](std::vector<const Path*> all) { return join_rings(all).paths.size(); };
  EXPECT_EQ(count({&a, &b, &c}), 1u);
  EXPECT_EQ(count({&a, &b}), 2u);
  EXPECT_EQ(count({&a, &b, &thick}), 3u);
  EXPECT_EQ(count({&a, &b, &c, &branch}), 4u);
}

TEST(Clip, ADiscCutsAtItsCircle) {
  const Disc disc{{5, 5}, 4};
  EXPECT_TRUE(lies_in(plain_path({{3, 5}, {7, 6}}), disc));
  const std::vector<Path> through = clipped(plain_path({{-10, 5}, {20, 5}}), disc);
  ASSERT_EQ(through.size(), 1u);
  EXPECT_LT(glm::distance(through[0].points.front(), Vec2(1, 5)), 1e-12);
  EXPECT_LT(glm::distance(through[0].points.back(), Vec2(9, 5)), 1e-12);
  EXPECT_LT(glm::distance(through[0].points3.back(), Vec3(18, 10, 1)), 1e-12);
  EXPECT_TRUE(clipped(plain_path({{0, 0}, {0, 10}, {10, 10}}), disc).empty());
  EXPECT_TRUE(clipped(plain_path({{5, 9.001}, {5, 20}}), disc).empty());
  // A square about it whose corners alone are outside.
  const std::vector<Path> corners =
      clipped(plain_path({{2, 2}, {8, 2}, {8, 8}, {2, 8}}, true), {{5, 5}, 3.5});
  EXPECT_EQ(corners.size(), 4u);
  for (const Path& piece : corners) {
    for (const Vec2& p : piece.points) EXPECT_LE(glm::distance(p, Vec2(5, 5)), 3.5 + 1e-9);
  }
}

TEST(Clip, AreasEndAtTheWindow) {
  // A U whose legs leave the window and come back, with a hole; and one that lies beside.
  Drawing drawing;
  drawing.areas = {
      {.part = 0,
       .rings = {{{0, 0}, {30, 0}, {30, 40}, {20, 40}, {20, 10}, {10, 10}, {10, 40}, {0, 40}},
                 {{2, 2}, {2, 4}, {4, 4}, {4, 2}}}},
      {.part = 1, .rings = {{{100, 100}, {110, 100}, {110, 110}}}}};
  Drawing box = drawing;
  clip_to(Box2{{1, -5}, {29, 20}}, box);
  ASSERT_EQ(box.areas.size(), 1u);
  EXPECT_NEAR(test::signed_area(box.areas[0]), 28 * 10 + 2 * 9 * 10 - 4, 1e-9);
  Drawing disc = drawing;
  disc.areas[0].rings = {{{0, 0}, {30, 0}, {30, 40}, {0, 40}}};
  clip_to(Disc{{15, 20}, 10}, disc);
  EXPECT_NEAR(test::signed_area(disc.areas[0]) / (std::acos(-1.0) * 100), 1, 2e-3);
}

}  // namespace
}  // namespace burin
