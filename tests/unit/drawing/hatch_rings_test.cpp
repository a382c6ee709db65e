/// Parallel lines over areas.

#include <burin/drawing/hatch_rings.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace burin {
namespace {

using Rings = std::vector<std::vector<Vec2>>;

/// A square of 40 mm with a hole of 10 in its middle: 1500 mm2.
const Rings kFrame{{{10, 10}, {50, 10}, {50, 50}, {10, 50}},
                   {{25, 25}, {25, 35}, {35, 35}, {35, 25}}};

double length_of(const std::vector<std::pair<Vec2, Vec2>>& lines) {
  double sum = 0;
  for (const auto& [a, b] : lines) sum += glm::distance(a, b);
  return sum;
}

TEST(HatchRings, AreAsLongAsTheAreaHasIt) {
  // Lines so far from each other are as long as the area over that distance.
  for (const double degrees : {0.0, 30.0, 45.0, 90.0, -60.0}) {
    const auto lines = hatch_rings(kFrame, degrees, 0.1);
    EXPECT_NEAR(length_of(lines) * 0.1, 1500, 3) << degrees;
  }
}

TEST(HatchRings, LieWithinTheRingsOnOneLattice) {
  const auto lines = hatch_rings(kFrame, 30, 2);
  ASSERT_GT(lines.size(), 20u);
  const double angle = std::numbers::pi / 6;
  const Vec2 across(-std::sin(angle), std::cos(angle));
  for (const auto& [a, b] : lines) {
    EXPECT_NEAR(std::remainder(glm::dot(across, a), 2.0), 0, 1e-9);
    EXPECT_NEAR(glm::dot(across, a), glm::dot(across, b), 1e-9);
    const Vec2 middle = 0.5 * (a + b), off = glm::abs(middle - Vec2(30));
    EXPECT_LE(std::max(off.x, off.y), 20);
    EXPECT_GE(std::max(off.x, off.y), 5) << "the hole";
  }
}

TEST(HatchRings, RunToAndFro) {
  const Rings square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
  const auto lines = hatch_rings(square, 0, 1);
  ASSERT_GE(lines.size(), 9u);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_LT(
        (lines[i].second.x - lines[i].first.x) * (lines[i - 1].second.x - lines[i - 1].first.x), 0);
  }
}

TEST(HatchRings, OfNothingAreNone) {
  EXPECT_TRUE(hatch_rings({}, 45, 1).empty());
  EXPECT_TRUE(hatch_rings(kFrame, 45, 0).empty());
  EXPECT_TRUE(hatch_rings(Rings{{{0.2, 0.2}, {0.4, 0.2}, {0.3, 0.3}}}, 0, 1).empty());
}

}  // namespace
}  // namespace burin
