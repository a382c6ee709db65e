/// Which part is seen where: poles of known figures.

#include <burin/annotate/label_map.h>

#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

constexpr Box2 kSheet{{0, 0}, {100, 60}};

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

}  // namespace
}  // namespace burin
