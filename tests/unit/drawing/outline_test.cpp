#include <burin/drawing/outline.h>

#include "polyline_support.h"

#include <gtest/gtest.h>

namespace burin {
namespace {

using test::kTau;

struct StrokeLine {
  std::vector<Vec2> points;
  std::vector<double> widths;
};

double ink(const StrokeLine& s) {
  double sum = 0;
  for (std::size_t i = 1; i < s.points.size(); ++i) {
    sum += 0.5 * (s.widths[i] + s.widths[i - 1]) * glm::distance(s.points[i], s.points[i - 1]);
  }
  return sum;
}

/// A line y(x) whose width swells in waves and tapers to points over 2.5 mm at both ends.
StrokeLine tapered(double amplitude, double length) {
  StrokeLine s;
  const int n = 200;
  double at = 0;
  for (int i = 0; i <= n; ++i) {
    const double x = length * i / n;
    s.points.push_back({x, amplitude * std::sin(kTau * x / 20)});
    if (i > 0) at += glm::distance(s.points[i], s.points[i - 1]);
    s.widths.push_back(at);
  }
  for (double& w : s.widths) {
    const double taper = std::min({1.0, w / 2.5, (at - w) / 2.5});
    w = taper * (0.3 + 0.15 * std::sin(w / 3));
  }
  return s;
}

double area(const std::vector<std::vector<CubicBezier>>& chains) {
  double sum = 0;
  for (const auto& chain : chains) sum += test::signed_area(test::sampled(chain, 24));
  return sum;
}

TEST(StrokeOutline, AreaIsTheIntegralOfTheWidth) {
  for (const double amplitude : {0.0, 1.0, 4.0}) {
    const StrokeLine s = tapered(amplitude, 40);
    const auto chains = stroke_outline(s.points, s.widths, 0.02);
    ASSERT_EQ(chains.size(), 1u);
    // Right side out of the way of the travel: clockwise, the same for every stroke.
    EXPECT_NEAR(-area(chains), ink(s), 0.02 * ink(s)) << amplitude;
    EXPECT_LE(chains[0].size(), 60u);
    EXPECT_EQ(chains[0].front()[0], chains[0].back()[3]);
  }
}

TEST(StrokeOutline, SidesKeepHalfTheWidthAway) {
  const StrokeLine s = tapered(4, 40);
  const auto chains = stroke_outline(s.points, s.widths, 0.02);
  for (const Vec2& p : test::sampled(chains[0])) {
    double gap = 1e9;
    for (std::size_t i = 1; i < s.points.size(); ++i) {
      for (double t = 0; t < 1; t += 0.05) {
        const double half = 0.5 * glm::mix(s.widths[i - 1], s.widths[i], t);
        const Vec2 c = glm::mix(s.points[i - 1], s.points[i], t);
        gap = std::min(gap, std::abs(glm::distance(p, c) - half));
      }
    }
    EXPECT_LE(gap, 0.02);
  }
}

TEST(StrokeOutline, ArcOfConstantWidthIsARing) {
  StrokeLine s;
  for (int i = 0; i <= 300; ++i) {
    const double a = 0.9 * kTau * i / 300;
    s.points.push_back(10.0 * Vec2(std::cos(a), std::sin(a)));
    s.widths.push_back(0.5);
  }
  const auto chains = stroke_outline(s.points, s.widths, 0.02);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_NEAR(-area(chains), ink(s), 0.01 * ink(s));
  EXPECT_LE(chains[0].size(), 30u);
  for (const Vec2& p : test::sampled(chains[0])) {
    const double a = std::atan2(p.y, p.x);
    // Nothing passes the ends; the noses take 0.02 radians.
    EXPECT_TRUE(a > -0.003 || a < -0.1 * kTau + 0.003) << a;
    if (a < 0.03 && a > -0.1 * kTau - 0.03) continue;
    EXPECT_NEAR(std::abs(glm::length(p) - 10), 0.25, 0.021);
  }
}

TEST(StrokeOutline, TightCurlsHaveNoHolesAndNoSpikes) {
  // Curls of radius 0.1 to 0.6 drawn 0.5 wide: the inner side folds back.
  for (const double radius : {0.1, 0.2, 0.3, 0.6}) {
    for (const double turns : {0.25, 0.5, 0.75, 1.5}) {
      StrokeLine s;
      for (int i = 0; i <= 20; ++i) s.points.push_back({-4 + 0.2 * i, -radius});
      for (int i = 1; i <= 80; ++i) {
        const double a = turns * kTau * i / 80 - kTau / 4;
        s.points.push_back(radius * Vec2(std::cos(a), std::sin(a)));
      }
      const double a = turns * kTau - kTau / 4;
      for (int i = 1; i <= 20; ++i) {
        s.points.push_back(s.points[100] + 0.2 * i * Vec2(-std::sin(a), std::cos(a)));
      }
      for (std::size_t i = 0; i < s.points.size(); ++i) {
        s.widths.push_back(0.5 + 0.02 * std::sin(double(i)));
      }
      const auto chains = stroke_outline(s.points, s.widths, 0.02);
      std::vector<std::vector<Vec2>> loops;
      for (const auto& chain : chains) loops.push_back(test::sampled(chain, 24));
      const auto filled = [&](Vec2 p) {
        int count = 0;
        for (const auto& loop : loops) count += test::winding(p, loop);
        return count != 0;
      };
      int holes = 0, spikes = 0;
      for (double x = -5; x <= 5; x += 0.0737) {
        for (double y = -5; y <= 5; y += 0.0737) {
          const double to_end = std::min(glm::distance({x, y}, s.points.front()),
                                         glm::distance({x, y}, s.points.back()));
          const double d = test::distance_to_polyline({x, y}, s.points, false);
          if (d < 0.25 - 0.045 && to_end > 0.32 && !filled({x, y})) ++holes;
          if (d > 0.25 + 0.045 && filled({x, y})) ++spikes;
        }
      }
      EXPECT_EQ(holes, 0) << radius << " " << turns;
      EXPECT_EQ(spikes, 0) << radius << " " << turns;
    }
  }
}

TEST(StrokeOutline, CornersAreRoundJoins) {
  const StrokeLine s{{{0, 0}, {10, 0}, {10, 10}}, {0.4, 0.4, 0.4}};
  const auto chains = stroke_outline(s.points, s.widths, 0.02);
  ASSERT_EQ(chains.size(), 2u);
  for (const auto& chain : chains) EXPECT_LT(test::signed_area(test::sampled(chain)), 0);
  double reach = 0;
  for (const auto& chain : chains) {
    for (const Vec2& p : test::sampled(chain)) reach = std::max(reach, p.x);
  }
  EXPECT_NEAR(reach, 10.2, 0.01);
}

TEST(StrokeOutline, DegenerateStrokes) {
  const std::vector<Vec2> same(4, Vec2(1, 1));
  const std::vector<double> widths(4, 0.3);
  EXPECT_TRUE(stroke_outline(same, widths, 0.02).empty());
  EXPECT_TRUE(stroke_outline({}, {}, 0.02).empty());
  const std::vector<Vec2> two{{0, 0}, {5, 0}};
  const std::vector<double> wedge{0.0, 0.5};
  const auto chains = stroke_outline(two, wedge, 0.02);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_NEAR(-area(chains), 1.25, 0.03);
  const std::vector<double> negative{-1.0, -1.0};
  EXPECT_NEAR(area(stroke_outline(two, negative, 0.02)), 0, 1e-12);
}

}  // namespace
}  // namespace burin
