/// Places of numbers: no leaders cross, and neighbours keep their distance.

#include <burin/annotate/place.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace burin {
namespace {

constexpr Box2 kFrame{{10, 10}, {287, 200}};
constexpr Box2 kDrawing{{40, 30}, {250, 180}};

std::size_t crossings(const std::vector<Vec2>& from, const std::vector<Vec2>& to) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t k = i + 1; k < from.size(); ++k) {
      n += segments_cross(from[i], to[i], from[k], to[k]) ? 1 : 0;
    }
  }
  return n;
}

TEST(Spread, KeepsThePitchAndMovesAsLittleAsCanBe) {
  const std::vector<double> apart{10, 30, 50};
  EXPECT_EQ(spread(apart, 10, 0, 100), apart);
  const auto pair = spread(std::vector<double>{20, 20}, 10, 0, 100);
  EXPECT_EQ(pair, (std::vector<double>{15, 25}));
  const auto edge = spread(std::vector<double>{98, 99, 100}, 10, 0, 100);
  EXPECT_EQ(edge, (std::vector<double>{80, 90, 100}));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 100);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> wanted(8);
    for (double& w : wanted) w = uniform(random);
    std::ranges::sort(wanted);
    const auto got = spread(wanted, 9, 0, 100);
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_GE(got[i], -1e-9);
      EXPECT_LE(got[i], 100 + 1e-9);
      if (i == 0) continue;
      EXPECT_GE(got[i] - got[i - 1], 9 - 1e-9);
    }
    // No block that could move nearer: a small step of all that touch each other is no better.
    const auto cost = [&](const std::vector<double>& at) {
      double sum = 0;
      for (std::size_t i = 0; i < at.size(); ++i) sum += (at[i] - wanted[i]) * (at[i] - wanted[i]);
      return sum;
    };
    for (std::size_t first = 0; first < got.size(); ++first) {
      for (std::size_t last = first; last < got.size(); ++last) {
        for (const double by : {-1e-3, 1e-3}) {
          auto other = got;
          bool allowed = true;
          for (std::size_t i = first; i <= last; ++i) other[i] += by;
          for (std::size_t i = 0; i < other.size(); ++i) {
            allowed &= other[i] >= 0 && other[i] <= 100;
            if (i > 0) allowed &= other[i] - other[i - 1] >= 9;
          }
          if (!allowed) continue;
          EXPECT_GE(cost(other), cost(got) - 1e-9);
        }
      }
    }
  }
}

TEST(Callouts, DoNotCrossOn200RandomFigures) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(kDrawing.min.x, kDrawing.max.x),
      y(kDrawing.min.y, kDrawing.max.y);
  const CalloutSizes sizes(CalloutOptions{}, 24);
  std::size_t swaps = 0, over = 0, leaders = 0;
  for (int figure = 0; figure < 200; ++figure) {
    const int n = 4 + figure % 21;
    std::vector<Vec2> anchors;
    for (int i = 0; i < n; ++i) anchors.emplace_back(x(random), y(random));
    const auto layout = static_cast<CalloutOptions::Layout>(figure % 3);
    const CalloutPlaces places =
        place_callouts(anchors, kDrawing, kFrame, sizes, layout, RunContext());
    swaps += places.swaps;
    ASSERT_EQ(places.at.size(), anchors.size());
    ASSERT_EQ(places.lacking, 1) << figure;
    EXPECT_EQ(crossings(anchors, places.at), 0U) << figure;
    for (std::size_t i = 0; i < places.at.size(); ++i) {
      const Vec2 p = places.at[i];
      const double r = 0.5 * sizes.diameter;
      EXPECT_TRUE(kFrame.contains(p - r) && kFrame.contains(p + r)) << p.x << " " << p.y;
      // Outside the drawing, so that a number covers none of it.
      EXPECT_FALSE((Box2{kDrawing.min - 0.5 * r, kDrawing.max + 0.5 * r}).contains(p));
      for (std::size_t k = i + 1; k < places.at.size(); ++k) {
        EXPECT_GE(glm::distance(p, places.at[k]), sizes.pitch - 1e-6) << figure;
      }
      ++leaders;
      for (std::size_t k = 0; k < anchors.size(); ++k) {
        const Vec2 way = p - anchors[i];
        const double t = glm::dot(anchors[k] - anchors[i], way) / glm::dot(way, way);
        if (k != i && t > 0 && t < 1 && glm::distance(anchors[k], anchors[i] + t * way) < 0.45) {
          ++over;  // the dot of another
        }
      }
    }
  }
  EXPECT_LT(over, leaders / 100) << "leaders over dots of others";
  EXPECT_LT(swaps / 200, 60U);
}

TEST(Callouts, ThatDoNotFitTellTheSheetThatHoldsThem) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(kDrawing.min.x, kDrawing.max.x),
      y(kDrawing.min.y, kDrawing.max.y);
  std::vector<Vec2> anchors;
  for (int i = 0; i < 100; ++i) anchors.emplace_back(x(random), y(random));
  const CalloutSizes sizes(CalloutOptions{}, 100);
  const auto layout = CalloutOptions::Layout::Columns;
  const auto small = place_callouts(anchors, kDrawing, kFrame, sizes, layout, RunContext());
  EXPECT_EQ(small.at.size(), 100U) << "none is left out";
  ASSERT_GT(small.lacking, 1);
  const auto scaled = [&](const Box2& b) {
    return Box2{b.min * small.lacking, b.max * small.lacking};
  };
  for (Vec2& a : anchors) a *= small.lacking;
  const auto large =
      place_callouts(anchors, scaled(kDrawing), scaled(kFrame), sizes, layout, RunContext());
  EXPECT_EQ(large.lacking, 1);
  EXPECT_EQ(crossings(anchors, large.at), 0U);
}

TEST(Callouts, ThatWouldStandOverTheDrawingTellHowLargeASheetKeepsItClear) {
  const CalloutSizes sizes(CalloutOptions{}, 9);
  const Box2 full{{12, 12}, {285, 198}};
  const std::vector<Vec2> anchors{{100, 100}, {200, 100}};
  const auto layout = CalloutOptions::Layout::Columns;
  const auto places = place_callouts(anchors, full, kFrame, sizes, layout, RunContext());
  EXPECT_EQ(places.at.size(), 2U);
  EXPECT_GT(places.lacking, 1);
}

/// A line of a dimension before the left side: numbers stand at the right, unless that is far.
TEST(Callouts, StandWhereLeadersPassOverNothing) {
  const CalloutSizes sizes(CalloutOptions{}, 9);
  const std::vector<Vec2> anchors{{130, 60}, {130, 100}, {160, 70}, {160, 110}};
  const auto on_the_left = [&](double bad) {
    const LeaderCosts costs{.over = [bad](Vec2 from, Vec2 to) {
      return segments_cross(from, to, {35, 0}, {35, 210}) ? bad : 0.0;
    }};
    const auto places = place_callouts(anchors, kDrawing, kFrame, sizes,
                                       CalloutOptions::Layout::Columns, RunContext(), costs);
    EXPECT_EQ(crossings(anchors, places.at), 0U);
    return std::ranges::count_if(places.at, [](Vec2 p) { return p.x < kDrawing.min.x; });
  };
  EXPECT_EQ(on_the_left(0), 2);
  EXPECT_EQ(on_the_left(0.1), 2);
  EXPECT_EQ(on_the_left(3), 0);
}

TEST(Callouts, OfOneAnchorOrOfEqualOnesHavePlaces) {
  const CalloutSizes sizes(CalloutOptions{}, 9);
  const auto layout = CalloutOptions::Layout::Around;
  const std::vector<Vec2> one{{100, 100}}, equal(6, Vec2(100, 100));
  EXPECT_EQ(place_callouts(one, kDrawing, kFrame, sizes, layout, RunContext()).at.size(), 1U);
  const auto at = place_callouts(equal, kDrawing, kFrame, sizes, layout, RunContext()).at;
  for (const Vec2& p : at) EXPECT_TRUE(kFrame.contains(p));
  EXPECT_TRUE(place_callouts({}, kDrawing, kFrame, sizes, layout, RunContext()).at.empty());
}

}  // namespace
}  // namespace burin
