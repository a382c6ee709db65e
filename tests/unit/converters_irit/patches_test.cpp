// Bezier patches of Geomview and plain patch lists.
#include <burin/base/rng.h>

#include "reading.h"

#include <burin_test/shapes.h>

#include <numbers>

namespace burin {
namespace {

using test::expect_error;
using test::expect_near;

TEST(GeomviewPatches, UFastest) {
  const Scene scene = test::scene_of(
      "# made by hand\nBEZ213 # three by two points\n0 0 0  1 0 5  2 0 0\n0 1 0  1 1 7  2 1 0\n",
      "wave.bez");
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_TRUE(scene.parts[0].name.ends_with("wave"));
  const auto& patches = test::patches_of(scene.parts[0]);
  ASSERT_EQ(patches.size(), 1u);
  expect_near(patches[0]->position({0.5, 0}), {1, 0, 2.5}, 1e-15);
  expect_near(patches[0]->position({0.5, 1}), {1, 1, 3.5}, 1e-15);
  expect_near(patches[0]->position({1, 0}), {2, 0, 0}, 1e-15);
}

TEST(GeomviewPatches, PointsAtInfinityAreSplitAway) {
  // Half a circle with one control point at infinity, swept along z.
  const Scene scene = test::scene_of(
      "BEZ214\n1 0 0 1  0 1 0 0  -1 0 0 1\n1 0 2 1  0 1 0 0  -1 0 2 1\n", "half.bez");
  const auto& patches = test::patches_of(scene.parts[0]);
  ASSERT_EQ(patches.size(), 2u);
  for (const auto& patch : patches) {
    for (double u = 0; u <= 1; u += 0.125) {
      const Vec3 p = patch->position({u, 0.5});
      EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-15);
      EXPECT_GE(p.y, -1e-15);
    }
  }
  expect_near(patches[0]->position({0, 0}), {1, 0, 0}, 1e-15);
  expect_near(patches[0]->position({1, 0}), {0, 1, 0}, 1e-15);
  expect_near(patches[1]->position({1, 0}), {-1, 0, 0}, 1e-15);
}

TEST(GeomviewPatches, ColoursAndTexturesArePassed) {
  const std::string points = " 0 0 0  1 0 0  0 1 0  1 1 0", texture = " 0 0 0 1 1 0 1 1";
  const std::string colors = " 1 0 0 1  0 1 0 1  0 0 1 1  1 1 1 1";
  const auto patches = [&](const std::string& text) {
    const Scene scene = test::scene_of(text, "a.bez");
    return test::patches_of(scene.parts[0]).size();
  };
  EXPECT_EQ(patches("BEZ113_ST" + points + texture + points + texture), 2u);
  EXPECT_EQ(patches("CBEZ113" + points + colors + points + colors), 2u);
  EXPECT_EQ(patches("CBEZ113_ST" + points + texture + colors), 1u);
}

TEST(GeomviewPatches, Errors) {
  expect_error("BEZ113\n0 0 0  1 0 0\n0 1 0", 3, "the file ends where a coordinate", "a.bez");
  expect_error("BEZ113\n0 0 0  1 0 x\n0 1 0 1 1 0", 2, "column 12: 'x' is not a coordinate",
               "a.bez");
  expect_error("BEZ113\n0 0 0  1 0 inf\n0 1 0 1 1 0", 2, "'inf' is not", "a.bez");
  expect_error("BEZ114\n0 0 0 1  1 0 0 0\n0 1 0 1 1 1 0 1", 2, "at infinity", "a.bez");
  expect_error("BEZ713\n0 0 0", 0, "neither", "a.bez");
  expect_error("BBP\n", 0, "holds no patch", "a.bez");
}

std::string list_text(int points, int patches) {
  std::string text = fmt::format("# a list\n{} {}\n", points, patches);
  for (int i = 1; i <= points; ++i) {
    text += fmt::format("{} {} {} {}\n", i, (i - 1) % 4, (i - 1) / 4, i == 6 ? 9 : 0);
  }
  for (int k = 0; k < patches; ++k) {
    for (int i = 1; i <= 16; ++i) text += fmt::format("{} ", i);
    text += "\n";
  }
  return text;
}

TEST(PatchList, IsKnownByItsContent) {
  const std::string text = list_text(16, 1);
  EXPECT_TRUE(is_irit_content(text));
  const Scene scene = test::scene_of(text, "pot.txt");
  EXPECT_TRUE(scene.parts[0].name.ends_with("pot"));
  const auto& patches = test::patches_of(scene.parts[0]);
  ASSERT_EQ(patches.size(), 1u);
  // v fastest: x goes with v; the point raised to 9 has 3 (1-u)^2 u 3 (1-v)^2 v at its place.
  expect_near(patches[0]->position({0, 1}), {3, 0, 0}, 1e-15);
  expect_near(patches[0]->position({1.0 / 3, 1.0 / 3}), {1, 1, 9 * 16.0 / 81}, 1e-14);
}

TEST(PatchList, Errors) {
  expect_error(list_text(16, 1) + "3\n", 20, "follows the end of the list", "a.txt");
  std::string cut = list_text(16, 2);
  cut.resize(cut.size() - 8);
  expect_error(cut, 20, "the file ends", "a.txt");
  std::string many = list_text(16, 1);
  many.replace(many.find("16 1"), 4, "16 900");
  expect_error(many, 2, "cannot fit", "a.txt");
  std::string wrong = list_text(16, 1);
  wrong.replace(wrong.rfind("16"), 2, "17");
  expect_error(wrong, 19, "'17' is not the number of a point, 1 to 16", "a.txt");
}

TEST(PatchList, TheClassicLayoutCountsPatchesFirst) {
  std::string text = "1\n1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16\n16\n";
  for (int i = 0; i < 16; ++i) text += fmt::format("{}.0,{}.0,{}\n", i % 4, i / 4, i == 5 ? 9 : 0);
  EXPECT_TRUE(is_irit_content(text));
  const Scene scene = test::scene_of(text, "pot.txt");
  const auto& patches = test::patches_of(scene.parts[0]);
  ASSERT_EQ(patches.size(), 1u);
  expect_near(patches[0]->position({1.0 / 3, 1.0 / 3}), {1, 1, 9 * 16.0 / 81}, 1e-14);
  expect_error("2\n" + text.substr(2), 4, "is not the number of a point", "a.txt");
  expect_error(text + "0 0 0\n", 20, "follows the end", "a.txt");
  expect_error(text.substr(0, text.size() - 9), 19, "the file ends", "a.txt");
}

TEST(PatchList, OthersAreNot) {
  EXPECT_FALSE(is_irit_content("3\n1 2 3\n4 5 6\n"));
  EXPECT_FALSE(is_irit_content("12 14\n1 2 3\n4 5 6\n"));
  EXPECT_FALSE(is_irit_content("OFF\n4 4 6\n"));
  EXPECT_FALSE(is_irit_content("solid [object\n"));
  EXPECT_FALSE(is_irit_content(""));
  EXPECT_TRUE(is_irit_content(" \n# x\n[ object"));
  EXPECT_TRUE(is_irit_content("BBP\n"));
}

}  // namespace
}  // namespace burin
