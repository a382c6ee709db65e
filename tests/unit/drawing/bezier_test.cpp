#include <burin/base/rng.h>
#include <burin/drawing/bezier.h>

#include "polyline_support.h"

#include <gtest/gtest.h>

namespace burin {
namespace {

using test::kTau;

constexpr double kTolerance = 0.02;

/// Both ways: the points near the chain, the chain near the polyline; and it is one chain.
void expect_within(const std::vector<Vec2>& points, bool closed, double tolerance,
                   const std::vector<CubicBezier>& curves) {
  ASSERT_FALSE(curves.empty());
  for (std::size_t i = 1; i < curves.size(); ++i) EXPECT_EQ(curves[i - 1][3], curves[i][0]);
  if (closed) {
    EXPECT_EQ(curves.back()[3], curves.front()[0]);
  } else {
    EXPECT_EQ(curves.front()[0], points.front());
    EXPECT_EQ(curves.back()[3], points.back());
  }
  const std::vector<Vec2> dense = test::sampled(curves);
  EXPECT_LE(test::farthest(dense, points, closed), tolerance);
  EXPECT_LE(test::farthest(points, dense, false), tolerance);
}

double turn_between(const CubicBezier& a, const CubicBezier& b) {
  const Vec2 in = a[3] - a[2], out = b[1] - b[0];
  return std::abs(std::atan2(cross2(in, out), glm::dot(in, out)));
}

TEST(FitCubics, CircleIsFewSmoothCurves) {
  for (const double radius : {0.5, 5.0, 50.0}) {
    const std::vector<Vec2> points = test::circle(radius, 400);
    const auto curves = fit_cubics(points, true, kTolerance);
    expect_within(points, true, kTolerance, curves);
    EXPECT_LE(curves.size(), radius < 10 ? 6u : 10u) << radius;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      EXPECT_LT(turn_between(curves[i], curves[(i + 1) % curves.size()]), 1e-9);
      EXPECT_FALSE(is_straight(curves[i], 0.001));
    }
    for (const Vec2& p : test::sampled(curves)) EXPECT_NEAR(glm::length(p), radius, kTolerance);
  }
}

TEST(FitCubics, SquareStaysFourLines) {
  std::vector<Vec2> points;
  const Vec2 corners[] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  for (int side = 0; side < 4; ++side) {
    for (int k = 0; k < 7; ++k) {
      points.push_back(glm::mix(corners[side], corners[(side + 1) % 4], k / 7.0));
    }
  }
  // Started in the middle of a side: the seam goes to a corner all the same.
  std::rotate(points.begin(), points.begin() + 3, points.end());
  const auto curves = fit_cubics(points, true, kTolerance);
  ASSERT_EQ(curves.size(), 4u);
  for (const CubicBezier& c : curves) EXPECT_TRUE(is_straight(c, 1e-9));
  expect_within(points, true, kTolerance, curves);
}

TEST(FitCubics, RoundedRectangleKeepsItsStraightSides) {
  std::vector<Vec2> points;
  const Vec2 centers[] = {{20, 10}, {0, 10}, {0, 0}, {20, 0}};
  for (int q = 0; q < 4; ++q) {
    for (int k = 0; k <= 16; ++k) {
      const double a = (q + k / 16.0) * kTau / 4;
      points.push_back(centers[q] + 3.0 * Vec2(std::cos(a), std::sin(a)));
    }
  }
  const auto curves = fit_cubics(points, true, kTolerance);
  expect_within(points, true, kTolerance, curves);
  const auto lines =
      std::count_if(curves.begin(), curves.end(), [](auto& c) { return is_straight(c, 1e-6); });
  EXPECT_EQ(lines, 4);
  EXPECT_LE(curves.size(), 12u);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    EXPECT_LT(turn_between(curves[i], curves[(i + 1) % curves.size()]), 0.06);
  }
}

TEST(FitCubics, CornersAreKept) {
  // Two half circles that meet in a cusp at the origin.
  std::vector<Vec2> points;
  for (int k = 0; k <= 60; ++k) {
    const double a = kTau / 2 * (1 - k / 60.0);
    points.push_back(Vec2(-5, 0) + 5.0 * Vec2(std::cos(a), std::sin(a)));
  }
  for (int k = 1; k <= 60; ++k) {
    const double a = kTau / 2 * (1 - k / 60.0);
    points.push_back(Vec2(5, 0) + 5.0 * Vec2(std::cos(a), std::sin(a)));
  }
  const auto curves = fit_cubics(points, false, kTolerance);
  expect_within(points, false, kTolerance, curves);
  const bool kept =
      std::any_of(curves.begin(), curves.end(), [](auto& c) { return glm::length(c[0]) < 1e-9; });
  EXPECT_TRUE(kept);
}

TEST(FitCubics, CoarsePolygonIsNotRounded) {
  // 24 facets, radius 40: a smooth curve would bow by 0.34 mm off the chords.
  const std::vector<Vec2> points = test::circle(40, 24);
  const auto curves = fit_cubics(points, true, kTolerance);
  EXPECT_EQ(curves.size(), 24u);
  for (const CubicBezier& c : curves) EXPECT_TRUE(is_straight(c, 1e-9));
}

TEST(FitCubics, WavesSpiralsAndNoise) {
  const Rng rng(7);
  std::vector<Vec2> wave, spiral, rough, walk{{0, 0}};
  for (int i = 0; i <= 500; ++i) {
    const double t = i / 500.0;
    wave.push_back({100 * t, 8 * std::sin(5 * kTau * t) * t});
    spiral.push_back((0.3 + 20 * t) * Vec2(std::cos(6 * kTau * t), std::sin(6 * kTau * t)));
    rough.push_back({50 * t, 0.03 * (rng.uniform(2u * i) - 0.5) + 3 * t * t});
    walk.push_back(walk.back() + Vec2(rng.uniform(9000u + 2 * i), rng.uniform(9001u + 2 * i)) -
                   0.5);
  }
  for (const auto& points : {wave, spiral, rough, walk}) {
    for (const double tolerance : {0.005, 0.02, 0.1}) {
      expect_within(points, false, tolerance, fit_cubics(points, false, tolerance));
    }
  }
  EXPECT_LE(fit_cubics(wave, false, kTolerance).size(), 40u);
  EXPECT_LE(fit_cubics(spiral, false, kTolerance).size(), 40u);
}

TEST(FitCubics, SmallAndBrokenPolylines) {
  EXPECT_TRUE(fit_cubics({}, false, kTolerance).empty());
  const std::vector<Vec2> one{{1, 2}}, same(5, Vec2(3, 3));
  EXPECT_TRUE(fit_cubics(one, true, kTolerance).empty());
  EXPECT_TRUE(fit_cubics(same, false, kTolerance).empty());
  EXPECT_TRUE(fit_cubics(same, true, kTolerance).empty());
  const std::vector<Vec2> two{{1, 2}, {4, 6}};
  const auto line = fit_cubics(two, false, kTolerance);
  ASSERT_EQ(line.size(), 1u);
  EXPECT_TRUE(is_straight(line[0], 1e-12));
  const std::vector<Vec2> repeats{{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 0}, {2, 0}, {2, 0}};
  EXPECT_EQ(fit_cubics(repeats, false, kTolerance).size(), 1u);
  const std::vector<Vec2> there_and_back{{0, 0}, {5, 0}, {0, 0}};
  expect_within(there_and_back, false, kTolerance, fit_cubics(there_and_back, false, kTolerance));
  const std::vector<Vec2> tiny{{0, 0}, {1e-3, 0}, {1e-3, 1e-3}, {0, 1e-3}, {0, 0}};
  EXPECT_LE(fit_cubics(tiny, false, kTolerance).size(), 1u);
  const std::vector<Vec2> triangle{{0, 0}, {3, 0}, {0, 3}};
  EXPECT_EQ(fit_cubics(triangle, true, kTolerance).size(), 3u);
}

TEST(FitCubics, RandomShapesKeepTheTolerance) {
  const Rng rng(3);
  for (std::uint64_t shape = 0; shape < 300; ++shape) {
    const Rng r(11, shape);
    const int n = 2 + static_cast<int>(r.uniform(0) * 60);
    const bool closed = r.uniform(1) < 0.4 && n > 3;
    const double bend = r.uniform(2) * 0.8, step = std::pow(10, 1.5 * r.uniform(3) - 1);
    std::vector<Vec2> points{{0, 0}};
    double heading = 0;
    for (int i = 1; i < n; ++i) {
      heading += bend * (r.uniform(100u + 2 * i) - 0.4);
      points.push_back(points.back() + step * (0.2 + r.uniform(101u + 2 * i)) *
                                           Vec2(std::cos(heading), std::sin(heading)));
    }
    SCOPED_TRACE(shape);
    expect_within(points, closed, kTolerance, fit_cubics(points, closed, kTolerance));
  }
}

TEST(Simplify, KeepsWhatMatters) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 100; ++i) points.push_back({i * 0.1, i == 50 ? 0.5 : 0.001 * (i % 2)});
  const auto kept = simplify(points, 0.01);
  EXPECT_EQ(kept, (std::vector<std::size_t>{0, 49, 50, 51, 100}));
  EXPECT_TRUE(simplify(std::span<const Vec2>{}, 0.01).empty());
  EXPECT_EQ(simplify(std::span(points).first(1), 0.01).size(), 1u);
}

// A stroke of one width with tapered ends is a plateau to it: noise chose a point in its middle.
TEST(Simplify, OfPointsThatAreEquallyFarKeepsTheFirst) {
  for (const double noise : {0.0, 1e-15, -1e-15}) {
    std::vector<Vec2> points{{0, 0}};
    for (int i = 1; i < 40; ++i) points.emplace_back(i, 0.22 + (i == 25 ? noise : 0));
    points.emplace_back(40, 0);
    EXPECT_EQ(simplify(points, 0.01), (std::vector<std::size_t>{0, 1, 39, 40})) << noise;
  }
}

}  // namespace
}  // namespace burin
