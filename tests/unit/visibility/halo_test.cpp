#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/visibility/halo.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

// A line of one depth, or sloping evenly from one depth to another.
HaloLine line(std::vector<Vec2> points, double depth_begin, double depth_end, bool casts,
              double half_width = 0) {
  HaloLine l;
  const auto n = static_cast<double>(points.size() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    l.depths.push_back(glm::mix(depth_begin, depth_end, static_cast<double>(i) / n));
  }
  if (casts) l.casters = {{0, n, half_width}};
  l.points = std::move(points);
  return l;
}

std::vector<std::vector<HaloGap>> gaps(const std::vector<HaloLine>& lines, double gap = 0.5,
                                       double behind = 0.1) {
  return halo_gaps(lines, {.gap = gap, .behind = behind}, RunContext{});
}

std::vector<Vec2> subdivided(Vec2 a, Vec2 b, int n) {
  std::vector<Vec2> out;
  for (int i = 0; i <= n; ++i) out.push_back(glm::mix(a, b, i / static_cast<double>(n)));
  return out;
}

TEST(Halo, TwoCrossingLinesLeaveAGapThatIsExactAcrossTheNearerOne) {
  for (const double degrees : {90.0, 45.0, 10.0, 3.0, 135.0}) {
    const double w = degrees * std::numbers::pi / 180;
    const Vec2 along(std::cos(w), std::sin(w));
    const double half = 30;
    const auto found = gaps({line({{-50, 0}, {50, 0}}, 5, 5, true, 0.2),
                             line({-half * along, half * along}, 0, 0, true, 0.1)});
    EXPECT_TRUE(found[0].empty()) << "the nearer line is whole";
    ASSERT_EQ(found[1].size(), 1u);
    const double expected = 0.7 / std::sin(w) / (2 * half);  // gap and the nearer half width
    EXPECT_NEAR(found[1][0].begin, 0.5 - expected, 1e-12);
    EXPECT_NEAR(found[1][0].end, 0.5 + expected, 1e-12);
  }
}

TEST(Halo, TheGapDoesNotDependOnHowLinesAreCut) {
  const Vec2 a(-20, -6), b(20, 6);
  for (const int near : {1, 7, 400}) {
    for (const int far : {1, 9, 333}) {
      const auto found = gaps({line(subdivided({-30, 0.25}, {30, 0.25}, near), 5, 5, true),
                               line(subdivided(a, b, far), -2, 0, false)});
      ASSERT_EQ(found[1].size(), 1u) << near << " " << far;
      const double sine = 12 / glm::distance(a, b), middle = 0.5 + 0.25 / 12;
      const double half = 0.5 / sine / glm::distance(a, b);
      EXPECT_NEAR(found[1][0].begin / far, middle - half, 1e-9);
      EXPECT_NEAR(found[1][0].end / far, middle + half, 1e-9);
    }
  }
}

TEST(Halo, ALineThatEndsAtANearerOneEndsBeforeIt) {
  // It goes on behind: what is drawn of it ends at the nearer line.
  const auto found =
      gaps({line({{0, -9}, {0, 9}}, 5, 5, true), line({{-10, 0}, {0, 0}, {2, 0}}, 0, 0, true)});
  ASSERT_EQ(found[1].size(), 1u);
  EXPECT_NEAR(found[1][0].begin, 0.95, 1e-12);
  EXPECT_NEAR(found[1][0].end, 1.25, 1e-12);
  // At an end of the nearer line the gap is round.
  const auto round =
      gaps({line({{0, -9}, {0, 0.3}}, 5, 5, true), line({{-10, 0}, {10, 0}}, 0, 0, true)});
  ASSERT_EQ(round[1].size(), 1u);
  EXPECT_NEAR(round[1][0].end, 0.525, 1e-12);
}

TEST(Halo, LinesOfOneDepthAndOfACommonVertexAreWhole) {
  EXPECT_TRUE(
      gaps({line({{-5, 0}, {5, 0}}, 1, 1, true), line({{0, -5}, {0, 5}}, 0.95, 0.95, true)})[1]
          .empty());
  // Two edges of a corner, one of which falls back steeply.
  for (const double depth : {-1.0, -10.0, -1000.0}) {
    const auto found =
        gaps({line({{0, 0}, {9, 0}}, 0, 0, true), line({{0, 0}, {9, 2}}, 0, depth, true)});
    EXPECT_TRUE(found[0].empty());
    EXPECT_TRUE(found[1].empty());
  }
  // A steep line is only behind by what it is beyond its own steepness: 0.05 mm of paper.
  EXPECT_TRUE(
      gaps({line({{-5, 0}, {5, 0}}, 1, 1, true), line({{0, -5}, {0, 5}}, -100, 101, true)})[1]
          .empty());
}

TEST(Halo, StrokesEndBesideANearerLineUnlessTheirOwnSheetDoes) {
  HaloLine stroke = line(subdivided({-5, 0.3}, {5, 0.3}, 20), 0, 0, false);
  const HaloLine contour = line({{-9, 0}, {9, 0}}, 4, 4, true);
  EXPECT_TRUE(gaps({contour, stroke})[1].empty()) << "features only where they cross";
  stroke.slopes.assign(stroke.points.size(), 1.0);
  const auto behind = gaps({contour, stroke});
  ASSERT_EQ(behind[1].size(), 1u);
  EXPECT_NEAR(behind[1][0].begin, 0, 1e-12);
  EXPECT_NEAR(behind[1][0].end, 20, 1e-12);
  // The same depth is reached by a sheet of slope 4 / 0.3 within the distance.
  stroke.slopes.assign(stroke.points.size(), 4 / 0.3);
  EXPECT_TRUE(gaps({contour, stroke})[1].empty());
  stroke.depths.assign(stroke.points.size(), 5.0);
  EXPECT_TRUE(gaps({contour, stroke})[1].empty()) << "nearer than the contour";
}

TEST(Halo, OnlyWhatIsDrawnCastsAndRoundCapsKeepClear) {
  HaloLine near = line(subdivided({-10, 0}, {10, 0}, 4), 5, 5, true);
  near.casters = {{0, 1.5, 0.25}, {3, 4, 0.25}};
  near.scale = {2, 2, 2, 2, 2};
  std::vector<HaloLine> lines{near};
  for (const double x : {-6.0, 0.0, 6.0}) {
    lines.push_back(line({{x, -10}, {x, 10}}, 0, 0, false));
    lines.back().overhang = 0.1;
  }
  const auto found = gaps(lines);
  ASSERT_EQ(found[1].size(), 1u);
  EXPECT_NEAR(found[1][0].end - found[1][0].begin, 2 * (0.5 + 0.5 + 0.1) / 20, 1e-12);
  EXPECT_TRUE(found[2].empty());
  EXPECT_EQ(found[3].size(), 1u);
  lines[1].interrupted = false;
  EXPECT_TRUE(gaps(lines)[1].empty());
}

TEST(Halo, ALoopPassesBehindItself) {
  // A figure of eight whose second lobe lies behind the first at the crossing (0,0).
  HaloLine eight;
  eight.closed = true;
  const int n = 400;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * (i + 0.5) / n;
    eight.points.push_back(20.0 * Vec2(std::sin(t), std::sin(t) * std::cos(t)));
    eight.depths.push_back(3 * std::cos(t));
  }
  eight.casters = {{0, double(n), 0}};
  const auto found = gaps({eight});
  // At t = 0 it is near, at t = pi far: one gap, round about the middle.
  ASSERT_EQ(found[0].size(), 1u);
  EXPECT_NEAR(0.5 * (found[0][0].begin + found[0][0].end), 0.5 * n - 0.5, 1e-3);
  // Its branches cross at a right angle there, at a speed of 20 sqrt(2) a radian.
  const double speed = 20 * std::numbers::sqrt2 * 2 * std::numbers::pi / n;
  EXPECT_NEAR(found[0][0].end - found[0][0].begin, 1 / speed, 0.01);
}

TEST(Halo, PerspectiveGapsAreMeasuredOnPaper) {
  HaloLine far = line({{-10, 0}, {10, 0}}, 0, -20, false);
  far.ranges = {50, 70};
  HaloLine near = line({{0, -10}, {0, 10}}, 5, 5, true);
  near.ranges = {45, 45};
  const auto found = gaps({near, far});
  ASSERT_EQ(found[1].size(), 1u);
  // The place of a share of paper u lies at the share u * 50 / ((1 - u) * 70 + u * 50) in space.
  const auto space = [](double u) { return u * 50 / ((1 - u) * 70 + u * 50); };
  EXPECT_NEAR(found[1][0].begin, space(0.475), 1e-12);
  EXPECT_NEAR(found[1][0].end, space(0.525), 1e-12);
}

TEST(Halo, ManyLinesAgreeWithAllPairsForAnyNumberOfThreads) {
  const Rng rng(5);
  std::vector<HaloLine> lines;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Vec2 p(100 * rng.uniform(5 * i), 100 * rng.uniform(5 * i + 1));
    const Vec2 d(30 * rng.uniform(5 * i + 2) - 15, 30 * rng.uniform(5 * i + 3) - 15);
    const double depth = 1000 * rng.uniform(5 * i + 4);
    lines.push_back(line({p, p + d}, depth, depth, true, 0.1));
  }
  const auto found = gaps(lines);
  std::size_t count = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // A straight line's gaps at each single caster, joined by hand.
    double covered = 0, expected = 0;
    for (const HaloGap& g : found[i]) covered += g.end - g.begin;
    std::vector<HaloGap> single;
    for (std::size_t j = 0; j < lines.size(); ++j) {
      if (j == i) continue;
      const auto pair = gaps({lines[j], lines[i]});
      single.insert(single.end(), pair[1].begin(), pair[1].end());
    }
    std::sort(single.begin(), single.end(),
              [](const HaloGap& a, const HaloGap& b) { return a.begin < b.begin; });
    double reached = 0;
    for (const HaloGap& g : single) {
      expected += std::max(0.0, g.end - std::max(reached, g.begin));
      reached = std::max(reached, g.end);
    }
    EXPECT_NEAR(covered, expected, 1e-9);
    count += found[i].size();
  }
  EXPECT_GT(count, 100u);
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    const auto again = gaps(lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      ASSERT_EQ(again[i].size(), found[i].size());
      for (std::size_t k = 0; k < found[i].size(); ++k) {
        EXPECT_EQ(again[i][k].begin, found[i][k].begin);
        EXPECT_EQ(again[i][k].end, found[i][k].end);
      }
    }
  }
}

TEST(Halo, StopsWhenCancelledAndTakesNothing) {
  EXPECT_TRUE(gaps({}).empty());
  EXPECT_TRUE(gaps({HaloLine{}, line({{1, 1}, {1, 1}}, 0, 0, true)})[1].empty());
  RunContext context;
  context.cancel();
  const std::vector<HaloLine> lines(100, line({{0, 0}, {1, 1}}, 0, 0, true));
  EXPECT_THROW(halo_gaps(lines, {}, context), Cancelled);
}

}  // namespace
}  // namespace burin
