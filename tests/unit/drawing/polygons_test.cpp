#include <burin/drawing/polygons.h>

#include <gtest/gtest.h>

#include <vector>

namespace burin {
namespace {

using Rings = std::vector<std::vector<Vec2>>;

std::vector<Vec2> square(Vec2 from, double side) {
  return {from, from + Vec2(side, 0), from + Vec2(side), from + Vec2(0, side)};
}

TEST(Polygons, HaveTheHolesThatLieInThem) {
  // An island in the hole of the first, and a square beside it, in any order.
  const Rings rings = {square({4, 4}, 2), square({0, 0}, 10), square({20, 0}, 10),
                       square({2, 2}, 6), square({22, 3}, 1), square({25, 3}, 1)};
  const auto polygons = polygons_of(rings);
  ASSERT_EQ(polygons.size(), 3u);
  EXPECT_EQ(polygons[0].shell, 0u);
  EXPECT_TRUE(polygons[0].holes.empty());
  EXPECT_EQ(polygons[1].shell, 1u);
  EXPECT_EQ(polygons[1].holes, (std::vector<std::size_t>{3}));
  EXPECT_EQ(polygons[2].shell, 2u);
  EXPECT_EQ(polygons[2].holes, (std::vector<std::size_t>{4, 5}));
  EXPECT_TRUE(polygons_of({}).empty());
}

TEST(Polygons, MayTouchTheirHoles) {
  // The hole shares two corners and a bit of a side with its shell, and with another hole.
  const Rings rings = {{{0, 0}, {4, 0}, {10, 0}, {10, 10}, {0, 10}},
                       {{0, 0}, {2, 6}, {5, 5}, {4, 0}},
                       {{5, 5}, {6, 9}, {9, 6}}};
  const auto polygons = polygons_of(rings);
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].holes, (std::vector<std::size_t>{1, 2}));
}

TEST(Polygons, ThatTouchAreNoHoles) {
  const Rings rings = {{{0, 0}, {10, 0}, {10, 10}, {5, 5}, {0, 10}}, {{5, 5}, {7, 9}, {3, 9}}};
  EXPECT_EQ(polygons_of(rings).size(), 2u);
}

}  // namespace
}  // namespace burin
