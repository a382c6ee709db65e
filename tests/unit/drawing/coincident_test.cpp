/// Which stretches of lines lie on others.

#include <burin/drawing/coincident.h>
#include <burin/drawing/length.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace burin {
namespace {

Path line_through(std::vector<Vec2> points, bool closed = false) {
  Path p;
  p.kind = LineClass::Crease;
  p.points = std::move(points);
  p.closed = closed;
  p.width = {0.25};
  return p;
}

double sum(const std::vector<Path>& paths) {
  double length = 0;
  for (const Path& p : paths) length += length_of(p);
  return length;
}

LinesOnPaper on(const Path& path, double tolerance = 0.1) {
  LinesOnPaper lines(tolerance);
  lines.add(path);
  return lines;
}

TEST(Coincident, ALineIsPartedWhereTheOtherEnds) {
  const PartedPath p =
      parted(line_through({{0, 0}, {10, 0}}), on(line_through({{4, 0.05}, {20, 0.05}})), 0.3);
  ASSERT_EQ(p.off.size(), 1U);
  ASSERT_EQ(p.on.size(), 1U);
  EXPECT_NEAR(sum(p.off), 4, 0.1);
  EXPECT_NEAR(sum(p.on), 6, 0.1);
  EXPECT_EQ(p.off[0].points.front(), Vec2(0, 0));
  EXPECT_EQ(p.on[0].points.back(), Vec2(10, 0));
  EXPECT_EQ(p.on[0].points.front(), p.off[0].points.back());
  EXPECT_EQ(p.on[0].width, std::vector{0.25});
}

TEST(Coincident, WhatIsFartherThanTheToleranceIsOff) {
  const Path path = line_through({{0, 0}, {10, 0}});
  EXPECT_TRUE(parted(path, on(line_through({{0, 0.11}, {10, 0.11}})), 0.3).on.empty());
  EXPECT_TRUE(parted(path, on(line_through({{0, 0.09}, {10, 0.09}})), 0.3).off.empty());
  EXPECT_TRUE(parted(path, LinesOnPaper(0.1), 0.3).on.empty());
}

TEST(Coincident, ShortStretchesAreTakenForWhatIsBesideThem) {
  // Another line crosses: it holds 0.2 mm of this one.
  EXPECT_TRUE(
      parted(line_through({{0, 0}, {10, 0}}), on(line_through({{5, -5}, {5, 5}})), 0.5).on.empty());
}

TEST(Coincident, ACircleThatIsWholeStaysClosed) {
  std::vector<Vec2> points;
  for (int i = 0; i < 64; ++i) {
    const double a = 2 * std::numbers::pi * i / 64;
    points.emplace_back(5 * std::cos(a), 5 * std::sin(a));
  }
  const Path circle = line_through(points, true);
  const PartedPath same = parted(circle, on(circle), 0.3);
  ASSERT_EQ(same.on.size(), 1U);
  EXPECT_TRUE(same.on[0].closed);
  EXPECT_TRUE(same.off.empty());
  // Without the stretch from its last point to its first.
  Path open = circle;
  open.closed = false;
  const PartedPath most = parted(circle, on(open, 0.05), 0.1);
  EXPECT_NEAR(sum(most.off), 10 * std::sin(std::numbers::pi / 64), 0.12);
}

TEST(Coincident, LongLinesFarFromTheOriginAreFound) {
  const Path diagonal = line_through({{-5000, -3000}, {5000, 4000}});
  const LinesOnPaper lines = on(diagonal, 0.2);
  for (int i = 0; i <= 1000; ++i) {
    EXPECT_TRUE(lines.holds(glm::mix(diagonal.points[0], diagonal.points[1], i / 1000.0))) << i;
  }
  EXPECT_NEAR(lines.distance({0, 0}, 500), 500 * 10 / std::hypot(10, 7), 3);
}

TEST(Coincident, WidthsAndModelPointsGoWithThePieces) {
  Path path = line_through({{0, 0}, {5, 0}, {10, 0}});
  path.width = {0.1, 0.2, 0.3};
  path.points3 = {{0, 0, 1}, {5, 0, 2}, {10, 0, 3}};
  const PartedPath p = parted(path, on(line_through({{7.5, 0}, {20, 0}})), 0.3);
  ASSERT_EQ(p.off.size(), 1U);
  ASSERT_EQ(p.off[0].points.size(), 3U);
  ASSERT_EQ(p.off[0].width.size(), 3U);
  ASSERT_EQ(p.off[0].points3.size(), 3U);
  EXPECT_NEAR(p.off[0].width[2], 0.25, 0.01);
  EXPECT_NEAR(p.off[0].points3[2].z, 2.5, 0.05);
}

}  // namespace
}  // namespace burin
