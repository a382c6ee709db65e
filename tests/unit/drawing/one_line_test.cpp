/// Lines that lie on each other: which of them is drawn, where it is cut, what it stands for.

#include <burin/drawing/ink.h>
#include <burin/drawing/join_lines.h>
#include <burin/drawing/length.h>
#include <burin/drawing/one_line.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace burin {
namespace {

Path line_of_edge(std::vector<Vec2> points, std::int32_t edge, double width = 0.25,
                  bool visible = true) {
  Path p;
  p.kind = LineClass::Crease;
  p.source = {0, -1, edge};
  p.visible = visible;
  p.points = std::move(points);
  for (const Vec2& q : p.points) p.points3.emplace_back(q, 0);
  p.width = {width};
  return p;
}

Path circle(double radius, int n, double turn, std::int32_t edge) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double a = turn + 2 * std::numbers::pi * i / n;
    points.emplace_back(radius * std::cos(a), radius * std::sin(a));
  }
  Path p = line_of_edge(std::move(points), edge);
  p.closed = true;
  return p;
}

/// The paths that stay of a layer a path.
std::vector<Path> kept(const std::vector<Path>& paths) {
  std::vector<Layer> layers;
  for (const Path& p : paths) layers.push_back({p.visible ? "crease" : "hidden", {p}});
  RunContext context;
  keep_one_line(layers, context);
  std::vector<Path> out;
  for (const Layer& layer : layers) out.insert(out.end(), layer.paths.begin(), layer.paths.end());
  return out;
}

TEST(OneLine, AHiddenOneUnderAVisibleOneIsNotDrawn) {
  const auto paths =
      kept({line_of_edge({{0, 0}, {20, 0}}, 1, 0.25, false), line_of_edge({{0, 0}, {20, 0}}, 2)});
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_TRUE(paths[0].visible);
  EXPECT_EQ(paths[0].also, (std::vector<PathSource>{{{0, -1, 1}, LineClass::Crease}}));
}

TEST(OneLine, TheWideOneStaysAndWhatIsLeftOfTheOtherGoesOn) {
  const auto paths = kept({line_of_edge({{5, 0}, {15, 0}}, 1, 0.5),
                           line_of_edge({{0, 0.01}, {10, -0.01}, {30, 0}}, 2)});
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_EQ(paths[0].points.size(), 2U);
  for (const Path& piece : {paths[1], paths[2]}) {
    EXPECT_EQ(piece.source.edge, 2);
    EXPECT_EQ(piece.points3.size(), piece.points.size());
  }
  EXPECT_NEAR(length_of(paths[1]), 5, 2 * kSameLine);
  EXPECT_NEAR(length_of(paths[2]), 15, 2 * kSameLine);
}

TEST(OneLine, LinesThatCrossStayWhole) {
  for (const double degrees : {90.0, 30.0, 15.0}) {
    const double a = degrees * std::numbers::pi / 180;
    const Vec2 way(10 * std::cos(a), 10 * std::sin(a));
    EXPECT_EQ(kept({line_of_edge({{-10, 0}, {10, 0}}, 1), line_of_edge({-way, way}, 2)}).size(), 2U)
        << degrees;
    // One ends on the other: what lies in its ink may go.
    const auto met = kept({line_of_edge({{-10, 0}, {10, 0}}, 1), line_of_edge({Vec2(0), way}, 2)});
    ASSERT_EQ(met.size(), 2U) << degrees;
    EXPECT_NEAR(length_of(met[1]), 10, kSameLine / std::sin(a) + 1e-9) << degrees;
  }
  EXPECT_EQ(
      kept({line_of_edge({{0, 0}, {10, 0}}, 1), line_of_edge({{0, 0.1}, {10, 0.1}}, 2)}).size(), 2U)
      << "beside each other";
}

TEST(OneLine, OneCircleOfTwoPolygonsIsDrawnOnce) {
  for (const double radius : {0.5, 3.0, 40.0}) {
    const int n = static_cast<int>(std::ceil(std::numbers::pi / std::sqrt(2 * 0.005 / radius)));
    const auto paths = kept({circle(radius, n, 0, 1), circle(radius, n + 3, 0.1, 2)});
    ASSERT_EQ(paths.size(), 1U) << radius;
    EXPECT_TRUE(paths[0].closed);
    EXPECT_EQ(paths[0].also.size(), 1U);
  }
}

TEST(OneLine, WhatIsLeftOfAClosedLineIsOnePiece) {
  // A square that begins in the middle of a side; another line lies on the far side.
  Path square = line_of_edge({{5, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}}, 2);
  square.closed = true;
  const auto paths = kept({line_of_edge({{0, 10}, {10, 10}}, 1, 0.5), square});
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_FALSE(paths[1].closed);
  EXPECT_NEAR(length_of(paths[1]), 30, 4 * kSameLine);
  EXPECT_EQ(paths[1].points.size(), 5U);
}

/// Thinned to its ends, an edge that is seen from its side turns back at a corner.
TEST(OneLine, ALineThatTurnsBackIsDrawnOnce) {
  for (const bool closed : {false, true}) {
    Path back = line_of_edge({{0, 0}, {20, 0}, {8, 0}, {0, 0}}, 1, 0.25, false);
    if (closed) back.points.pop_back(), back.points3.pop_back();
    back.closed = closed;
    double length = 0;
    for (const Path& p : kept({back})) {
      EXPECT_FALSE(p.closed);
      length += length_of(p);
    }
    EXPECT_NEAR(length, 20, 0.1) << closed;
  }
}

TEST(OneLine, ACircleSeenFromItsSideIsDrawnOnce) {
  for (const double high : {0.0, 0.003}) {
    for (const std::size_t start : {0U, 5U}) {
      Path flat = circle(5, 40, 0, 1);
      for (Vec2& p : flat.points) p.y *= high;
      std::rotate(flat.points.begin(), flat.points.begin() + static_cast<std::ptrdiff_t>(start),
                  flat.points.end());
      double length = 0;
      for (const Path& p : kept({flat})) length += length_of(p);
      EXPECT_NEAR(length, 10, 0.5) << high << ' ' << start;
    }
  }
  EXPECT_EQ(kept({circle(5, 40, 0, 1)}).size(), 1U);
}

TEST(OneLine, OfHiddenLinesOnEachOtherOneStays) {
  const auto paths = kept({line_of_edge({{0, 0}, {20, 0}}, 1, 0.18, false),
                           line_of_edge({{2, 0}, {12, 0}}, 2, 0.18, false)});
  double length = 0;
  for (const Path& p : paths) length += length_of(p);
  EXPECT_NEAR(length, 20, 4 * kSameLine);
}

TEST(OneLine, StrokesAreLeftAlone) {
  std::vector<Path> strokes{line_of_edge({{0, 0}, {9, 0}}, -1), line_of_edge({{0, 0}, {9, 0}}, -1)};
  for (Path& p : strokes) p.kind = LineClass::Stroke;
  EXPECT_EQ(kept(strokes).size(), 2U);
}

TEST(Dashes, BeginAndEndEachLine) {
  const std::vector<double> dashes{2, 1};
  for (const double length : {1.0, 3.0, 7.7, 20.0, 101.3}) {
    const auto fitted = fitted_dashes(dashes, line_of_edge({{0, 0}, {length, 0}}, 1));
    ASSERT_EQ(fitted.size(), 2U);
    const double period = fitted[0] + fitted[1], rest = std::fmod(length, period);
    EXPECT_NEAR(rest == 0 ? period : rest, fitted[0], 1e-9) << length;
    if (length > 7) {
      EXPECT_NEAR(period, 3, 0.5) << length;
    }
  }
  const Path ring = circle(5, 100, 0, 1);
  const auto round = fitted_dashes(dashes, ring);
  const double whole = length_of(ring) + glm::distance(ring.points.front(), ring.points.back());
  EXPECT_NEAR(std::remainder(whole, round[0] + round[1]), 0, 1e-9);
  EXPECT_TRUE(fitted_dashes({}, ring).empty());
}

TEST(JoinedLines, OfOnePartGoOnStraightAndDashedOnesRoundBends) {
  const auto joined = [](std::vector<Path> paths) {
    std::vector<Layer> layers{{"crease", std::move(paths)}};
    RunContext context;
    join_lines(layers, context);
    return layers.front().paths;
  };
  auto paths = joined({line_of_edge({{0, 0}, {10, 0}}, 1), line_of_edge({{25, 0}, {10, 0}}, 2)});
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].points.size(), 2U);
  EXPECT_EQ(paths[0].source.edge, 2) << "the longest";
  EXPECT_EQ(paths[0].also, (std::vector<PathSource>{{{0, -1, 1}, LineClass::Crease}}));
  // Round a corner, in a bend, of another part, where three meet, at another depth: as they were.
  EXPECT_EQ(
      joined({line_of_edge({{0, 0}, {10, 0}}, 1), line_of_edge({{10, 0}, {10, 9}}, 2)}).size(), 2U);
  EXPECT_EQ(joined({line_of_edge({{0, 0}, {5, 0}, {10, 0.1}}, 1),
                    line_of_edge({{10, 0.1}, {20, 0.4}}, 2)})
                .size(),
            2U);
  Path other = line_of_edge({{10, 0}, {20, 0}}, 2);
  other.source.part = 1;
  EXPECT_EQ(joined({line_of_edge({{0, 0}, {10, 0}}, 1), other}).size(), 2U);
  Path deep = line_of_edge({{10, 0}, {20, 0}}, 2);
  for (Vec3& p : deep.points3) p.z = 5;
  EXPECT_EQ(joined({line_of_edge({{0, 0}, {10, 0}}, 1), deep}).size(), 2U);
  paths = joined({line_of_edge({{0, 0}, {5, 0}, {10, 0.1}}, 1, 0.18, false),
                  line_of_edge({{10, 0.1}, {20, 0.4}}, 2, 0.18, false)});
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].points3.size(), paths[0].points.size());
}

}  // namespace
}  // namespace burin
