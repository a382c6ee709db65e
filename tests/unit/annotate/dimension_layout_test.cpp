// Where dimensions stand about a drawing.
#include <burin/annotate/dimensions.h>
#include <burin/annotate/sections.h>
#include <burin/drawing/font.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

/// Wherever a hole is: half a wide line and as much again between letters and the outline.
TEST(DimensionLayout, KeepsLettersOffTheOutline) {
  for (int k = 0; k < 40; ++k) {
    const int row = k / 8, column = k % 8;
    const double x = 8 + 84.0 * column / 7, z = -10 + 5.0 * row;
    Dimension hole;
    hole.kind = Dimension::Kind::Round;
    hole.from = {x, 0, z};
    hole.to = {x + 2, 0, z};
    hole.other = {0, -1, 0};
    hole.text = "⌀4";
    // Lengths below take its other places.
    const LaidDimensions laid =
        lay_out(about_shaft({hole, upright(12, x, x + 1, "12")}), kFront, {});
    const auto letters = std::ranges::find(laid.layer.texts, "⌀4", &Text::text);
    ASSERT_NE(letters, laid.layer.texts.end());
    const Box2 box = text_box(*letters);
    const double apart = std::max({box.min.y - 15, -15 - box.max.y, box.min.x - 100, -box.max.x});
    EXPECT_GT(apart, 0.6) << x << " " << z;
  }
}

/// From where two sides of a bevel meet: an angle, one side along x, the other with `way`.
Dimension angle(Vec3 vertex, Vec3 first, Vec3 second, const std::string& text) {
  Dimension one;
  one.kind = Dimension::Kind::Angle;
  one.from = vertex;
  one.to = vertex + first;
  one.other = vertex + second;
  one.from_points = {vertex, one.to};
  one.to_points = {vertex, one.other};
  one.text = text;
  return one;
}

/// Both angles of a bevel: the arrows of one do not lie on the arc of the other.
TEST(DimensionLayout, KeepsArrowsOffArcs) {
  const double slope = std::tan(glm::radians(30.0));
  ViewDimensions both{{angle({5, 0, 10}, {55, 0, 0}, {-5, 0, -5 * slope}, "150"),
                       angle({0, 0, 10 - 5 * slope}, {0, 0, -17}, {5, 0, 5 * slope}, "120")},
                      Box3{{0, -1, -10}, {60, 1, 10}}};
  const LaidDimensions laid = lay_out(both, kFront, {});
  // In the order of the list: each an arc, and after it its two arrows.
  std::vector<std::vector<Path>> groups;
  for (const Path& path : laid.layer.paths) {
    if (path.points.size() > 2) groups.emplace_back();
    if (!groups.empty()) groups.back().push_back(path);
  }
  ASSERT_EQ(groups.size(), 2U);
  for (const int arrows : {0, 1}) {
    const Path& arc = groups[static_cast<std::size_t>(1 - arrows)].front();
    for (const Path& arrow : groups[static_cast<std::size_t>(arrows)]) {
      if (arrow.width.size() < 2) continue;
      for (const Vec2& p : arrow.points) {
        for (const Vec2& q : arc.points) EXPECT_GT(glm::distance(p, q), 0.8);
      }
    }
  }
}

bool crosses(const Path& path, const Box2& box) {
  constexpr int kSteps = 200;
  for (int i = 0; i <= kSteps; ++i) {
    if (box.contains(glm::mix(path.points[0], path.points[1], 1.0 * i / kSteps))) return true;
  }
  return false;
}

/// Lines of dimensions beside the mark of a section, and a centre line that goes beyond its view.
TEST(SectionLetters, StandOffLines) {
  Drawing sheet;
  sheet.paper_width = 200, sheet.paper_height = 200;
  const auto add = [&](const char* layer, Vec2 from, Vec2 to) {
    Path path;
    path.points = {from, to};
    path.width = {0.18};
    sheet.layers.push_back({layer, {path}});
  };
  add("dimensions", {10, 96.5}, {60, 96.5});
  add("centre-lines", {100, 120}, {100, 153});
  SectionMark mark;
  mark.course = {{40, 100}, {90, 100}};
  mark.sight = {0, 1};
  mark.letter = "A";
  lay_sections(sheet, std::vector{mark}, std::vector{SectionName{{{60, 120}, {140, 150}}, "A"}},
               {});
  int seen = 0;
  for (const Text& text : sheet.layers.back().texts) {
    ++seen;
    for (const char* layer : {"dimensions", "centre-lines"}) {
      const auto found = std::ranges::find(sheet.layers, layer, &Layer::name);
      EXPECT_FALSE(crosses(found->paths.front(), text_box(text))) << text.text << " " << layer;
    }
  }
  EXPECT_EQ(seen, 3);
}

}  // namespace
}  // namespace burin
