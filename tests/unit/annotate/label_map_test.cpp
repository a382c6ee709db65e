/// Which part is seen where: poles and areas of known figures.

#include <burin/annotate/label_map.h>

#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

constexpr Box2 kSheet{{0, 0}, {100, 60}};

double area_of(const Area& area) {
  double twice = 0;
  for (const auto& ring : area.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      twice += a.x * b.y - a.y * b.x;
    }
  }
  return twice / 2;
}

LabelMap map_of(const std::function<std::int32_t(Vec2)>& part_at) {
  return make_label_map(kSheet, part_at, RunContext());
}

TEST(LabelMap, HasTwoPixelsAMmAndFewerOnLargeSheets) {
  const LabelMap map = map_of([](Vec2 p) { return p.x < 30 ? 4 : -1; });
  EXPECT_EQ(map.width, 200U);
  EXPECT_EQ(map.height, 120U);
  EXPECT_EQ(map.at({29.9, 5}), 4);
  EXPECT_EQ(map.at({30.1, 5}), -1);
  EXPECT_EQ(map.at({-1, 5}), -1);
  EXPECT_TRUE(map.shows(4, {30.2, 5}));
  EXPECT_FALSE(map.shows(4, {31, 5}));
  const LabelMap large = make_label_map(
      {{0, 0}, {10000, 8000}}, [](Vec2) { return 0; }, RunContext());
  EXPECT_LT(large.parts.size(), 2'100'000U);
}

TEST(Poles, AreTheMiddlesOfTheLargestDiscs) {
  // A disc with a hole beside its middle, a thin bar, and a part that is not seen.
  const auto disc = [](Vec2 p) {
    return glm::distance(p, Vec2(30, 30)) < 20 && glm::distance(p, Vec2(30, 40)) > 5;
  };
  const LabelMap map = map_of([&](Vec2 p) {
    return disc(p) ? 0 : p.x > 60 && p.y > 10 && p.y < 11 ? 1 : -1;
  });
  const auto poles = find_poles(map, 3);
  ASSERT_EQ(poles.size(), 3U);
  // The largest disc touches the hole and the rim on the line through both middles, from y = 10 to
  // y = 35; beside that line others are hardly smaller.
  EXPECT_NEAR(poles[0].radius, 12.5, 0.8);
  EXPECT_NEAR(glm::distance(poles[0].at, Vec2(30, 22.5)), 0, 3);
  EXPECT_NEAR(poles[1].radius, 0.5, 0.3);
  EXPECT_EQ(map.at(poles[1].at), 1);
  EXPECT_EQ(poles[2].radius, 0);
}

TEST(Areas, AreThoseOfTheFigures) {
  const auto ring = [](Vec2 p) {
    const double r = glm::distance(p, Vec2(30, 30));
    return r < 20 && r > 8;
  };
  const LabelMap map = map_of([&](Vec2 p) {
    return ring(p) ? 0 : p.x > 60 && p.y > p.x - 50 ? 1 : -1;
  });
  const auto areas = find_areas(map);
  ASSERT_EQ(areas.size(), 2U);
  ASSERT_EQ(areas[0].rings.size(), 2U) << "the rim and the hole";
  EXPECT_NEAR(area_of(areas[0]), std::acos(-1.0) * (400 - 64), 15);
  ASSERT_EQ(areas[1].rings.size(), 1U);
  EXPECT_NEAR(area_of(areas[1]), 40 * 50 - 0.5 * 40 * 40, 25);
  EXPECT_LT(areas[1].rings[0].size(), 40U) << "a slanted side is a line, no stair";
}

TEST(Areas, HaveNoStairsAlongSlantedLines) {
  for (const double slope : {0.2, 0.577, 0.8, 1.7}) {
    const auto below = [&](Vec2 p) { return p.x > 20 && p.y < 5 + slope * (p.x - 20) && p.x < 45; };
    const auto areas = find_areas(map_of([&](Vec2 p) { return below(p) ? 0 : -1; }));
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_LT(areas[0].rings[0].size(), 20U) << slope;
  }
}

TEST(Areas, ThatTouchAtACornerAreRingsThatClose) {
  const LabelMap map = map_of([](Vec2 p) {
    const bool left = p.x < 50, low = p.y < 30;
    return left == low ? 7 : -1;
  });
  const auto areas = find_areas(map);
  ASSERT_EQ(areas.size(), 1U);
  EXPECT_EQ(areas[0].rings.size(), 2U);
  EXPECT_NEAR(area_of(areas[0]), 3000, 30);
}

}  // namespace
}  // namespace burin
