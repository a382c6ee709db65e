/// Circles on which equal holes stand.

#include "pitch_circles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace burin::detail {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

std::vector<Round> holes_on(Vec2 center, double radius, int count) {
  std::vector<Round> out;
  for (int i = 0; i < count; ++i) {
    const double a = 0.3 + kTurn * i / count;
    out.push_back({center + radius * Vec2(std::cos(a), std::sin(a)), 2, true, 0});
  }
  return out;
}

TEST(PitchCircles, GoThroughHolesAtEqualAngles) {
  for (const int count : {3, 5, 6, 12}) {
    const auto circles = pitch_circles(holes_on({10, 20}, 30, count));
    ASSERT_EQ(circles.size(), 1U) << count;
    EXPECT_NEAR(circles[0].radius, 30, 1e-9);
    EXPECT_LT(glm::distance(circles[0].center, Vec2(10, 20)), 1e-9);
    EXPECT_EQ(circles[0].holes.size(), static_cast<std::size_t>(count));
  }
}

TEST(PitchCircles, FourHolesAreASquareUnlessSomethingStandsInTheirMiddle) {
  std::vector<Round> holes = holes_on({0, 0}, 30, 4);
  EXPECT_TRUE(pitch_circles(holes).empty());
  holes.push_back({{0, 0}, 12, true, 0});
  EXPECT_EQ(pitch_circles(holes).size(), 1U);
}

TEST(PitchCircles, RowsOfHolesHaveNone) {
  std::vector<Round> rows, grid;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (y < 2) rows.push_back({{25.0 * x, 30.0 * y}, 3, true, 0});
      grid.push_back({{20.0 * x, 20.0 * y}, 3, true, 0});
    }
  }
  EXPECT_TRUE(pitch_circles(rows).empty());
  EXPECT_TRUE(pitch_circles(grid).empty());
}

TEST(PitchCircles, OfTwoKindsOfHolesAboutOneCentreAreTwo) {
  std::vector<Round> rounds = holes_on({0, 0}, 30, 6);
  for (Round hole : holes_on({0, 0}, 50, 8)) {
    hole.radius = 4;
    rounds.push_back(hole);
  }
  EXPECT_EQ(pitch_circles(rounds).size(), 2U);
}

TEST(PitchCircles, HolesOfOtherPartsAndPinsDoNotCount) {
  std::vector<Round> rounds = holes_on({0, 0}, 30, 3);
  rounds[0].part = 1;
  EXPECT_TRUE(pitch_circles(rounds).empty());
  rounds[0].part = 0;
  for (Round& r : rounds) r.hollow = false;
  EXPECT_TRUE(pitch_circles(rounds).empty());
}

}  // namespace
}  // namespace burin::detail
