// The grammar of SVG paths, against points that its text names.
#include <burin/base/error.h>
#include <burin/drawing/path_data.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace burin {
namespace {

std::vector<Vec2> points_of(std::string_view text, std::size_t subpath = 0) {
  return flattened(parse_path_data(text).at(subpath), 1e-3);
}

void expect_points(std::string_view text, const std::vector<Vec2>& wanted) {
  SCOPED_TRACE(text);
  const std::vector<Vec2> points = points_of(text);
  ASSERT_EQ(points.size(), wanted.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points[i].x, wanted[i].x, 1e-9);
    EXPECT_NEAR(points[i].y, wanted[i].y, 1e-9);
  }
}

std::string refusal(std::string_view text) {
  try {
    parse_path_data(text);
  } catch (const UsageError& e) {
    return e.what();
  }
  return "it was read";
}

TEST(PathData, LinesAreAbsoluteOrRelative) {
  expect_points("M1 2L3 4 5 6", {{1, 2}, {3, 4}, {5, 6}});
  expect_points("M1 2 3 4 5 6", {{1, 2}, {3, 4}, {5, 6}});
  expect_points("m1 2 3 4l5 6", {{1, 2}, {4, 6}, {9, 12}});
  expect_points("M1,2H5V7h-1v-2", {{1, 2}, {5, 2}, {5, 7}, {4, 7}, {4, 5}});
  expect_points("M1-2.5.5 1e1", {{1, -2.5}, {.5, 10}});
  expect_points("M1 2L3e-999 4", {{1, 2}, {0, 4}});
  expect_points(" M +1 2\n\tL 3,4 ", {{1, 2}, {3, 4}});
}

TEST(PathData, ZEndsAtTheStartAndTheNextCommandGoesOnFromThere) {
  const auto path = parse_path_data("M1 1h4v4zl-1-1M9 9l1 0");
  ASSERT_EQ(path.size(), 3);
  EXPECT_TRUE(path[0].closed);
  EXPECT_EQ(flattened(path[0], 1e-3).size(), 3);
  EXPECT_FALSE(path[1].closed);
  EXPECT_EQ(path[1].curves.front()[0], Vec2(1, 1));
  EXPECT_EQ(path[1].curves.front()[3], Vec2(0, 0));
}

TEST(PathData, CurvesHaveTheirControlPointsAndSmoothOnesMirrorThem) {
  const auto path = parse_path_data("M0 0C1 2 3 4 5 6s7 8 9 10");
  EXPECT_EQ(path[0].curves[1][1], Vec2(7, 8));  // 2 (5,6) - (3,4)
  EXPECT_EQ(path[0].curves[1][3], Vec2(14, 16));
  // S after anything but a cubic starts along its own control point.
  EXPECT_EQ(parse_path_data("M1 1S3 4 5 6")[0].curves[0][1], Vec2(1, 1));
  const auto quadratic = parse_path_data("M0 0Q3 6 6 0T12 0")[0];
  EXPECT_EQ(evaluate(quadratic.curves[0], 0.5), Vec2(3, 3));
  EXPECT_EQ(evaluate(quadratic.curves[1], 0.5), Vec2(9, -3));
}

TEST(PathData, ArcsLieOnTheirEllipses) {
  // The four arcs of one radius between two points, by their flags; flags need no space.
  for (const auto& [flags, cx, cy] :
       {std::tuple{"00", 0.0, -3.0}, {"11", 0.0, -3.0}, {"01", 0.0, 3.0}, {"10", 0.0, 3.0}}) {
    SCOPED_TRACE(flags);
    // The chord is from (-4,0) to (4,0), the radius 5. The flags tell which centre.
    const auto path = parse_path_data(std::string("M-4 0A5 5 0 ") + flags + "4 0")[0];
    double length = 0;
    Vec2 before(-4, 0);
    for (const Vec2& p : flattened(path, 1e-4)) {
      EXPECT_NEAR(std::hypot(p.x - cx, p.y - cy), 5, 2e-3);
      length += glm::distance(p, before);
      before = p;
    }
    const double small = 5 * 2 * std::asin(0.8), large = 5 * 2 * (std::acos(-1.0) - std::asin(0.8));
    EXPECT_NEAR(length, flags[0] == '1' ? large : small, 0.01);
  }
  // A radius that is too small grows until it reaches; one of 0 is a line.
  for (const Vec2& p : points_of("M0 0a1 1 0 0 1 10 0"))
    EXPECT_NEAR(std::hypot(p.x - 5, p.y), 5, 2e-3);
  expect_points("M0 0A0 1 0 0 1 3 4", {{0, 0}, {3, 4}});
  // A turned ellipse.
  for (const Vec2& p : points_of("M3 0A 2 3 90 1 0 -3 0")) {
    EXPECT_NEAR(p.x * p.x / 9 + p.y * p.y / 4, 1, 1e-3);
  }
}

TEST(PathData, TextOfAPathIsReadBack) {
  const auto path = parse_path_data("M0 0C1 2 3 4 5 6L7 8zM1 1q2 3 4 5");
  const auto again = parse_path_data(to_path_data(path));
  ASSERT_EQ(again.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_EQ(again[i].closed, path[i].closed);
    ASSERT_EQ(again[i].curves.size(), path[i].curves.size());
    for (std::size_t c = 0; c < path[i].curves.size(); ++c) {
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_LT(glm::distance(again[i].curves[c][k], path[i].curves[c][k]), 1e-6);
      }
    }
  }
}

TEST(PathData, WhatIsNoPathSaysWhereAndWhy) {
  EXPECT_EQ(refusal(""), "the path is empty");
  EXPECT_EQ(refusal("  \n"), "the path is empty");
  EXPECT_EQ(refusal("L1 2"), "column 1: a path begins with M");
  EXPECT_EQ(refusal("star"), "column 1: a path begins with M");
  EXPECT_EQ(refusal("M1 2"), "the path draws nothing");
  EXPECT_EQ(refusal("M1 2L1 2z"), "the path draws nothing");
  EXPECT_EQ(refusal("M0 0L5"), "column 7: the path ends where a number follows L");
  EXPECT_EQ(refusal("M0 0C1 2 3 4"), "column 13: the path ends where a number follows C");
  EXPECT_EQ(refusal("M0 0Lx 1"), "column 6: a number follows L, not 'x'");
  EXPECT_EQ(refusal("M0 0Lnan 1"), "column 6: a number follows L, not 'n'");
  EXPECT_EQ(refusal("M0 0L- 1"), "column 6: a number follows L, not '-'");
  EXPECT_EQ(refusal("M0 0L1e400 1"), "column 6: a number beyond 1e+09");
  EXPECT_EQ(refusal("M0 0R1 1"), "column 5: 'R' is no command of paths (M L H V C S Q T A Z)");
  EXPECT_EQ(refusal("M0 0A1 1 0 2 0 5 5"), "column 12: 0 or 1 follows A, not '2'");
  EXPECT_EQ(refusal("M0 0l1 1Z 3 4"),
            "column 11: '3' is no command of paths (M L H V C S Q T A Z)");
  EXPECT_EQ(refusal("M0 0" + std::string(300'000, ' ')),
            "the path has more than 200000 characters");
  std::string endless = "M0 0l";
  for (int i = 0; i < 30'000; ++i) endless += i % 2 ? "1 1 " : "1-1 ";
  EXPECT_EQ(refusal(endless), "the path has more than 20000 curves");
}

}  // namespace
}  // namespace burin
