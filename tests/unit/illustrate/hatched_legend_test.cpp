/// Hatching in colours has rows in the legend.

#include <burin/base/box.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/legend.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

using Strings = std::vector<std::string>;

/// Two boxes side by side, the one red, the other nearly black.
Scene two_boxes() {
  Scene scene;
  for (const auto& [name, x, color] : {std::tuple("lid", 0, "#ff0000"), {"pin", 20, "#101010"}}) {
    scene.parts.push_back(
        {name, "a.stl", std::make_shared<MeshForm>(test::box({x, 0, 0}, {x + 10, 4, 10}))});
    scene.parts.back().color = color;
  }
  return scene;
}

/// Lines of hatching in colours.
Style hatched() {
  Style style = builtin_style("flat");
  style.fill.opacity = 0;
  style.fill.hatch.lines = FillHatch::Lines::Lines;
  style.fill.hatch.color = "fill";
  return style;
}

struct Legend {
  Drawing drawing;
  Strings seen;
};
Legend legend(const Scene& scene, const Style& style) {
  IllustrateOptions options;
  Annotations& over = options.annotations.emplace();
  over.items = {{1, "lid", {0}, "", ""}, {2, "pin", {1}, "", ""}};
  over.legend = legend_rows(scene, style, options, over.items);
  RunContext context;
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = {0, -1, 0}, .paper = {150, 100}});
  Legend out{illustrate(scene, camera, style, options, context), {}};
  for (const LegendRow& row : with_seen_rows(scene, style, options, out.drawing).legend) {
    if (row.seen) out.seen.push_back(row.square.fill);
  }
  return out;
}

/// Colours of lines of hatching by part, within the squares of the legend and elsewhere.
std::map<std::int32_t, std::set<std::string>> lines(const Drawing& drawing, bool in_squares) {
  std::map<std::int32_t, std::set<std::string>> out;
  for (const Layer& layer : drawing.layers) {
    if (layer.name != "fill-hatch") continue;
    for (const Path& path : layer.paths) {
      const bool within = std::ranges::any_of(drawing.areas, [&](const Area& area) {
        const auto& ring = area.rings.front();
        const Vec2 at = 0.5 * (path.points[0] + path.points[1]);
        return area.role == "legend" && at.x > ring[0].x && at.x < ring[2].x && at.y > ring[0].y &&
               at.y < ring[2].y;
      });
      if (within == in_squares) out[path.source.part].insert(path.color);
    }
  }
  return out;
}

TEST(HatchedLegend, HasTheColoursOfLinesAndSquaresOfThem) {
  const Legend found = legend(two_boxes(), hatched());
  EXPECT_EQ(found.seen, (Strings{"#ff0000", "#595959"}));
  EXPECT_EQ(lines(found.drawing, true), lines(found.drawing, false));
  EXPECT_EQ(lines(found.drawing, true).size(), 2u);
  std::ptrdiff_t squares = 0;
  for (const Area& area : found.drawing.areas) {
    EXPECT_TRUE(area.fill.empty()) << "lines alone";
    squares += area.role == "legend" ? 1 : 0;
  }
  EXPECT_EQ(squares, 2);
}

TEST(HatchedLegend, HasColoursThatAreNamedAndHatchesThemWhereTheShadeAloneIs) {
  Style style = hatched();
  style.fill.color = "none";
  style.fill.hatch.color = "#0000ff";
  style.fill.steps = 3;
  const Legend found = legend(two_boxes(), style);
  EXPECT_TRUE(found.seen.empty()) << "the front is in full light";
  style.tone.light = {0, 0, -1};
  EXPECT_EQ(legend(two_boxes(), style).seen, (Strings{"#0000ff", "#0000ff"}));
  EXPECT_EQ(lines(legend(two_boxes(), style).drawing, true).size(), 2u);
}

/// Fills of the squares of the legend's first row, in the order of painting, with their widths.
std::vector<std::pair<std::string, double>> first_square(const Drawing& drawing) {
  std::vector<std::pair<std::string, double>> out;
  for (const Area& area : drawing.areas) {
    if (area.role != "legend" || area.part != 0) continue;
    Box2 box;
    for (const Vec2& p : area.rings.front()) box.add(p);
    out.emplace_back(area.fill, box.size().x);
  }
  return out;
}

// Half of a ball is in each tone of an ink.
TEST(Legend, ShowsTheTonesOfAnInkAsThePictureDoes) {
  Scene scene = two_boxes();
  scene.parts[0].form = std::make_shared<MeshForm>(test::ellipsoid({6, 6, 6}, 48, 24));
  const Drawing drawing = legend(scene, builtin_style("duotone")).drawing;
  std::set<std::string> seen;
  for (const Area& area : drawing.areas) {
    if (area.role.empty() && area.part == 0) seen.insert(area.fill);
  }
  ASSERT_EQ(seen.size(), 3U);
  const auto square = first_square(drawing);
  ASSERT_EQ(square.size(), 3U) << "the lightest tone all over, the others over it";
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(seen.contains(square[i].first)) << square[i].first;
    EXPECT_NEAR(square[i].second, square[0].second * static_cast<double>(3 - i) / 3, 1e-9);
  }
  // Tones that differ in light alone: a square is the colour in full light.
  EXPECT_EQ(first_square(legend(scene, builtin_style("cel")).drawing).size(), 1U);
}

TEST(Legend, HatchesTheTonesThatAreHatched) {
  Style style = builtin_style("flat");
  style.fill.steps = 3;
  style.fill.hatch.lines = FillHatch::Lines::Lines;
  style.fill.hatch.distance = 0.4;
  style.tone.light = {0, 0, -1};  // the front is in the dark
  const Drawing drawing = legend(two_boxes(), style).drawing;
  const auto square = first_square(drawing);
  ASSERT_EQ(square.size(), 3U);
  Box2 dark;
  for (const Area& area : drawing.areas) {
    if (area.role != "legend" || area.part != 0 || area.tone != 0) continue;
    for (const Vec2& p : area.rings.front()) dark.add(p);
  }
  int within = 0;
  for (const Layer& layer : drawing.layers) {
    if (layer.name != "fill-hatch") continue;
    for (const Path& path : layer.paths) {
      const Vec2 at = 0.5 * (path.points[0] + path.points[1]);
      if (at.x < dark.max.x - square[0].second || at.y < dark.min.y || at.y > dark.max.y) continue;
      EXPECT_GT(at.x, dark.min.x) << "the darkest tone alone has lines";
      ++within;
    }
  }
  EXPECT_GT(within, 2);
}

// The pin stands behind the lid and looks out beside it. On the sheet it is `wide` mm.
Strings seen_beside(double wide) {
  Scene scene = two_boxes();
  scene.parts.pop_back();
  constexpr double kScale = 4;
  scene.parts.push_back(
      {"pin", "a.stl",
       std::make_shared<MeshForm>(test::box({5, 6, 2}, {10 + wide / kScale, 8, 8}))});
  scene.parts.back().color = "#00ff00";
  IllustrateOptions options;
  Annotations& over = options.annotations.emplace();
  over.items = {{1, "lid", {0}, "", ""}, {2, "pin", {1}, "", ""}};
  const Style style = builtin_style("flat");
  over.legend = legend_rows(scene, style, options, over.items);
  RunContext context;
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                  {.direction = {0, -1, 0}, .scale = kScale, .paper = {150, 100}});
  const Drawing drawing = illustrate(scene, camera, style, options, context);
  Strings out;
  for (const LegendRow& row : with_seen_rows(scene, style, options, drawing).legend) {
    if (row.seen) out.push_back(row.name);
  }
  return out;
}

TEST(Legend, HasNoRowOfWhatIsHiddenOrLiesUnderLines) {
  EXPECT_EQ(seen_beside(-1), Strings{"lid"});
  EXPECT_EQ(seen_beside(0), Strings{"lid"});
  EXPECT_EQ(seen_beside(0.15), Strings{"lid"}) << "a line's width";
  EXPECT_EQ(seen_beside(0.4), (Strings{"lid", "pin"}));
}

TEST(Legend, NamesThePartsOfAnItemThatHaveSeveralColours) {
  const Scene scene = two_boxes();
  const std::vector<DrawingItem> of_both{{1, "box (2)", {0, 1}, "", ""}};
  const auto names = [&](const Scene& of) {
    Strings out;
    for (const LegendRow& row : legend_rows(of, builtin_style("flat"), {}, of_both)) {
      out.push_back(row.name);
    }
    return out;
  };
  EXPECT_EQ(names(scene), (Strings{scene.parts[0].name, scene.parts[1].name}));
  Scene alike = scene;
  alike.parts[1].color = alike.parts[0].color;
  EXPECT_EQ(names(alike), Strings{"box (2)"});
}

// Where two equal parts lie in one place the first one is seen, of others the smaller.
TEST(Legend, HasNoRowOfAPartThatAnotherCovers) {
  Scene scene = two_boxes();
  scene.parts[1].form = scene.parts[0].form;
  EXPECT_EQ(legend(scene, builtin_style("flat")).seen, Strings{"#ff0000"});
  scene.parts[1].form = std::make_shared<MeshForm>(test::box({2, 0, 2}, {8, 4, 8}));
  EXPECT_EQ(legend(scene, builtin_style("flat")).seen, (Strings{"#ff0000", "#595959"}));
}

TEST(HatchedLegend, HasNoneOfLinesInTheInkOfTheSheetOrOfGlass) {
  Style style = hatched();
  style.fill.hatch.color = "";
  EXPECT_TRUE(legend_rows(two_boxes(), style, {}, {{{1, "lid", {0}, "", ""}}}).empty());
  IllustrateOptions options;
  options.part_styles.resize(2);
  options.part_styles[0].transparent = true;
  EXPECT_TRUE(legend_rows(two_boxes(), hatched(), options, {{{1, "lid", {0}, "", ""}}}).empty());
}

}  // namespace
}  // namespace burin
