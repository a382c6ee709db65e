// Where dimensions stand about a drawing.
#include <burin/annotate/dimensions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace burin {
namespace {

/// From the front, a mm of paper a mm.
const PaperView kFront{Mat3(Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(0, 1, 0)), 1, Vec2(0)};

/// An upright length, whose extension lines begin between two places of the width.
Dimension upright(double height, double from, double to, const std::string& text) {
  Dimension one;
  one.from = {from, 0, -0.5 * height};
  one.to = {from, 0, 0.5 * height};
  one.from_points = {one.from, {to, 0, -0.5 * height}};
  one.to_points = {one.to, {to, 0, 0.5 * height}};
  one.text = text;
  return one;
}

Vec2 place_of(const LaidDimensions& laid, const std::string& text) {
  const auto found = std::ranges::find(laid.layer.texts, text, &Text::text);
  return found == laid.layer.texts.end() ? Vec2(1e9) : found->at;
}

ViewDimensions about_shaft(std::vector<Dimension> list) {
  return {std::move(list), Box3{{0, -15, -15}, {100, 15, 15}}};
}

/// A journal and a hole at one end: the number of the hole makes room for the lines of the journal,
/// which would run through the whole shaft to its other end.
TEST(DimensionLayout, LeavesAFreeSideToLinesThatBeginThere) {
  const LaidDimensions laid = lay_out(
      about_shaft({upright(5, 0, 15, "M6"), upright(20, 0, 30, "⌀20"), upright(10, 0, 30, "10")}),
      kFront, {});
  for (const char* text : {"M6", "⌀20", "10"}) EXPECT_LT(place_of(laid, text).x, 0) << text;
}

TEST(DimensionLayout, PrefersTheShorterWayOverThePart) {
  const LaidDimensions near = lay_out(about_shaft({upright(10, 54, 56, "10")}), kFront, {});
  EXPECT_GT(place_of(near, "10").x, 100);
  const LaidDimensions left = lay_out(about_shaft({upright(10, 49, 51, "10")}), kFront, {});
  EXPECT_LT(place_of(left, "10").x, 0);
}

}  // namespace
}  // namespace burin
