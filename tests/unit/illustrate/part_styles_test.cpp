#include <burin/drawing/writers.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/ring_size.h"
#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace burin {
namespace {

// A small ball (part 1) behind a wall (part 0), seen from the front, and a ball beside (part 2).
Scene wall_and_balls() {
  Scene scene;
  const auto add = [&](const char* name, TriMesh mesh, Vec3 by) {
    for (Vec3& p : mesh.positions) p += by;
    scene.parts.push_back({name, name, std::make_shared<MeshForm>(std::move(mesh))});
  };
  add("wall", test::box({-20, -2, -20}, {20, 2, 20}), {0, -20, 0});
  add("ball", test::ellipsoid({10, 10, 10}, 96, 48), {0, 0, 0});
  add("other", test::ellipsoid({12, 12, 12}, 96, 48), {40, 0, 0});
  return scene;
}

Drawing draw_styled(const Scene& scene, std::vector<PartStyle> part_styles,
                    const char* style = "technical") {
  RunContext context;
  const NamedView v = named_view("front");
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = v.direction, .up = v.up, .paper = {150, 100}});
  return illustrate(scene, camera, builtin_style(style), {.part_styles = std::move(part_styles)},
                    context);
}

struct Ink {
  double lines = 0, strokes = 0;
};
Ink ink_of(const Drawing& drawing, int part) {
  Ink ink;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.source.part != part || !path.visible) continue;
      double& sum = path.kind == LineClass::Stroke ? ink.strokes : ink.lines;
      for (std::size_t i = 1; i < path.points.size(); ++i) {
        sum += glm::length(path.points[i] - path.points[i - 1]);
      }
      if (path.closed) sum += glm::length(path.points.front() - path.points.back());
    }
  }
  return ink;
}

std::string styled_json(const Drawing& drawing) {
  RunContext context;
  std::ostringstream out;
  write_json(drawing, {}, out, context);
  return out.str();
}

TEST(PartStyles, OfTheUsualKindChangeNothing) {
  const Scene scene = wall_and_balls();
  EXPECT_EQ(styled_json(draw_styled(scene, {})), styled_json(draw_styled(scene, {{}, {}, {}})));
}

TEST(PartStyles, WhatIsNotDrawnHidesNothingAndKeepsTheNumbersOfTheOthers) {
  const Scene scene = wall_and_balls();
  const Drawing all = draw_styled(scene, {});
  EXPECT_EQ(ink_of(all, 1).lines, 0);
  const Drawing without = draw_styled(scene, {{.drawn = false}});
  EXPECT_EQ(ink_of(without, 0).lines, 0);
  EXPECT_GT(ink_of(without, 1).strokes, 0);
  ASSERT_EQ(without.parts.size(), 3u);
  EXPECT_EQ(without.parts[2].name, "other");
  // The ball's outline, a circle of radius 10.
  EXPECT_NEAR(ink_of(without, 1).lines, 2 * 3.14159265 * 10 * without.view.scale,
              0.02 * 63 * without.view.scale);
}

TEST(PartStyles, ATransparentPartShowsItsLinesItsStrokesAndWhatIsBehind) {
  const Scene scene = wall_and_balls();
  const Drawing all = draw_styled(scene, {});
  const Drawing clear = draw_styled(scene, {{.transparent = true}});
  EXPECT_NEAR(ink_of(clear, 0).lines, ink_of(all, 0).lines, 1e-6);
  EXPECT_NEAR(ink_of(clear, 0).strokes, ink_of(all, 0).strokes, 0.1 * ink_of(all, 0).strokes);
  const Drawing ghost = draw_styled(scene, {{.hatched = false, .transparent = true}});
  EXPECT_EQ(ink_of(ghost, 0).strokes, 0);
  EXPECT_NEAR(ink_of(ghost, 0).lines, ink_of(all, 0).lines, 1e-6);
  const Drawing without = draw_styled(scene, {{.drawn = false}});
  EXPECT_NEAR(ink_of(clear, 1).lines, ink_of(without, 1).lines, 1e-6);
  EXPECT_GT(ink_of(clear, 1).strokes, 0);
}

TEST(PartStyles, ATransparentPartIsHiddenBySolidOnes) {
  const Scene scene = wall_and_balls();
  const Drawing drawing = draw_styled(scene, {{}, {.transparent = true}});
  EXPECT_EQ(ink_of(drawing, 1).lines, 0);
}

// Strokes behind a part of another style would be traced for nothing, and would take part in the
// widths of those that are seen.
TEST(PartStyles, NoStrokesArePlacedBehindPartsOfAnotherStyle) {
  Scene scene = wall_and_balls();
  scene.parts.pop_back();  // the ball beside the wall: the other one is behind it
  PartStyle bare;
  bare.style = builtin_style("outline");
  EXPECT_GT(draw_styled(scene, {{.drawn = false}}).stats.coverage_points, 10);
  EXPECT_EQ(draw_styled(scene, {bare}).stats.coverage_points, 0);
}

TEST(PartStyles, WhatIsNotHatchedKeepsItsLines) {
  const Scene scene = wall_and_balls();
  const Drawing all = draw_styled(scene, {});
  const Drawing bare = draw_styled(scene, {{}, {}, {.hatched = false}});
  EXPECT_GT(ink_of(all, 2).strokes, 0);
  EXPECT_EQ(ink_of(bare, 2).strokes, 0);
  EXPECT_EQ(ink_of(bare, 2).lines, ink_of(all, 2).lines);
}

TEST(PartStyles, APartMayHaveAStyleOfItsOwn) {
  const Scene scene = wall_and_balls();
  Style thick = builtin_style("outline");
  thick.line.outer = 1.5;
  PartStyle look;
  look.style = thick;
  const Drawing drawing = draw_styled(scene, {{}, {}, look});
  EXPECT_EQ(ink_of(drawing, 2).strokes, 0);
  bool seen = false;
  for (const Layer& layer : drawing.layers) {
    if (layer.name != "outline") continue;
    for (const Path& path : layer.paths) {
      ASSERT_EQ(path.width.size(), 1u);
      EXPECT_EQ(path.width[0], path.source.part == 2 ? 1.5 : builtin_style("technical").line.outer);
      seen |= path.source.part == 2;
    }
  }
  EXPECT_TRUE(seen);
}

std::set<std::string> colors_of(const Drawing& drawing, int part, bool strokes) {
  std::set<std::string> colors;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.source.part == part && (path.kind == LineClass::Stroke) == strokes) {
        colors.insert(path.color);
      }
    }
  }
  return colors;
}

TEST(PartStyles, TheLinesAndStrokesOfAPartHaveItsColor) {
  const Scene scene = wall_and_balls();
  PartStyle red;
  red.style = builtin_style("technical");
  red.style->line.color = "#d00000";
  const std::set<std::string> usual{""}, reds{"#d00000"}, blues{"#0000d0"};
  const Drawing drawing = draw_styled(scene, {{}, {}, red});
  EXPECT_EQ(colors_of(drawing, 2, false), reds);
  EXPECT_EQ(colors_of(drawing, 2, true), reds);
  EXPECT_EQ(colors_of(drawing, 0, false), usual);
  red.style->hatch.color = "#0000d0";
  const Drawing two = draw_styled(scene, {{}, {}, red});
  EXPECT_EQ(colors_of(two, 2, false), reds);
  EXPECT_EQ(colors_of(two, 2, true), blues);
  // Where it is that of the sheet nothing is said of it.
  red.style->line.color = red.style->hatch.color = red.style->sheet.ink;
  EXPECT_EQ(colors_of(draw_styled(scene, {{}, {}, red}), 2, true), usual);
}

// A flat egg (part 1) runs into the wall (part 0).
Scene wall_with_egg() {
  Scene scene = wall_and_balls();
  scene.parts.erase(scene.parts.begin() + 1, scene.parts.end());
  // Its outline does not lie on the line.
  TriMesh egg = test::ellipsoid({10, 12, 10}, 96, 48);
  for (Vec3& p : egg.positions) p.y -= 20;
  scene.parts.push_back({"egg", "egg", std::make_shared<MeshForm>(std::move(egg))});
  return scene;
}

// Part, colour and width of the lines in which parts run into each other.
using MeetingLines = std::set<std::tuple<int, std::string, double>>;
MeetingLines meeting_lines(const Drawing& drawing) {
  MeetingLines out;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind != LineClass::Intersection) continue;
      out.insert({path.source.part, path.color, path.width.front()});
    }
  }
  return out;
}

// The border of a part that stands out is its own, whichever of both comes first.
TEST(PartStyles, LinesInWhichPartsMeetAreThoseOfThePartThatShowsMore) {
  const Scene scene = wall_with_egg();
  PartStyle pale, bold;
  pale.style = bold.style = builtin_style("outline");
  pale.style->line.color = "#a0a0a0";
  bold.style->line.intersection = 0.5;
  const double usual = pale.style->line.intersection;
  const auto drawn = [&](const PartStyle& wall, const PartStyle& egg) {
    return meeting_lines(draw_styled(scene, {wall, egg}, "outline"));
  };
  EXPECT_EQ(drawn({}, {}), (MeetingLines{{1, "", usual}})) << "the smaller of equal ones";
  EXPECT_EQ(drawn(pale, {}), (MeetingLines{{1, "", usual}}));
  EXPECT_EQ(drawn({}, pale), (MeetingLines{{0, "", usual}}));
  EXPECT_EQ(drawn({}, bold), (MeetingLines{{1, "", 0.5}}));
  EXPECT_EQ(drawn(pale, pale), (MeetingLines{{1, "#a0a0a0", usual}}));
  PartStyle none;
  none.style = builtin_style("outline");
  none.style->feature.intersections = false;
  EXPECT_EQ(drawn(none, pale), (MeetingLines{{1, "#a0a0a0", usual}}));
}

// Two crossing bars.
TEST(PartStyles, LinesOfGlassInGlassAreSeenAsItsOtherLines) {
  Scene scene;
  scene.parts.push_back(
      {"long", "long", std::make_shared<MeshForm>(test::box({-30, -6, -6}, {30, 6, 6}))});
  scene.parts.push_back(
      {"up", "up", std::make_shared<MeshForm>(test::box({-4, -4, -30}, {4, 4, 30}))});
  PartStyle usual, glass;
  glass.transparent = true;
  const auto lengths = [&](const PartStyle& other) {
    RunContext context;
    const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                      {.direction = {1, -2, 1.5}, .scale = 2});
    const Drawing drawing = illustrate(
        scene, camera, builtin_style("outline"),
        {.hidden = HiddenLines::Dashed, .part_styles = {glass, other}, .verify = true}, context);
    EXPECT_EQ(drawing.stats.verify->contradicted, 0);
    double seen = 0, hidden = 0;
    for (const Layer& layer : drawing.layers) {
      for (const Path& path : layer.paths) {
        if (path.kind != LineClass::Intersection) continue;
        for (std::size_t i = 0; i + 1 < path.points3.size(); ++i) {
          (path.visible ? seen : hidden) += glm::distance(path.points3[i], path.points3[i + 1]);
        }
        if (path.closed) seen += glm::distance(path.points3.front(), path.points3.back());
      }
    }
    return std::pair(seen, hidden);
  };
  // The square on the top of the long bar, and two sides of that below, on the front of the other.
  const auto [seen, hidden] = lengths(glass);
  EXPECT_NEAR(seen, 6 * 8, 0.1);
  EXPECT_NEAR(hidden, 2 * 8, 0.1);
  // Those of a solid bar are where it is seen.
  const auto [seen_of_one, hidden_of_one] = lengths(usual);
  EXPECT_NEAR(seen_of_one, 4 * 8, 0.1);
  EXPECT_NEAR(hidden_of_one, 4 * 8, 0.1);
}

// A block (part 1, or 0 where it is `first`) is let into a plate; their tops are one plane.
Drawing flush(bool first, const PartStyle& plate, const PartStyle& block) {
  Scene scene;
  scene.parts.push_back(
      {"plate", "plate", std::make_shared<MeshForm>(test::box({-20, -5, -15}, {20, 5, 15}))});
  scene.parts.push_back(
      {"block", "block", std::make_shared<MeshForm>(test::box({-8, -5, -6}, {8, 4, 6}))});
  std::vector<PartStyle> styles{plate, block};
  if (first) std::swap(scene.parts[0], scene.parts[1]), std::swap(styles[0], styles[1]);
  RunContext context;
  const NamedView v = named_view("front");
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                  {.direction = v.direction, .up = v.up, .scale = 2, .paper = {150, 100}});
  Style style = builtin_style("flat");
  return illustrate(scene, camera, style, {.part_styles = std::move(styles), .verify = true},
                    context);
}

double area_of_part(const Drawing& drawing, const std::string& part) {
  double sum = 0;
  for (const Area& area : drawing.areas) {
    if (drawing.parts[static_cast<std::size_t>(area.part)].name == part) {
      sum += test::signed_area(area);
    }
  }
  return sum;
}

// Nothing else tells which of both is seen: the one that is to stand out, in any order.
TEST(PartStyles, OfPartsThatLieOnEachOtherTheOneThatShowsMoreIsSeen) {
  constexpr double kPlate = 40 * 30 * 4, kBlock = 16 * 12 * 4;
  PartStyle usual, pale, own;
  pale.style = own.style = builtin_style("flat");
  pale.style->line.color = "#a0a0a0";
  own.style->fill.color = "#d00000";
  const auto block_is_seen = [&](bool first, const PartStyle& plate, const PartStyle& block) {
    const Drawing drawing = flush(first, plate, block);
    EXPECT_EQ(drawing.stats.verify->wrong_patches, 0);
    EXPECT_NEAR(area_of_part(drawing, "plate") + area_of_part(drawing, "block"), kPlate, 1);
    EXPECT_TRUE(area_of_part(drawing, "block") < 1 ||
                std::abs(area_of_part(drawing, "block") - kBlock) < 1);
    return area_of_part(drawing, "block") > 1;
  };
  EXPECT_TRUE(block_is_seen(true, usual, usual));
  EXPECT_TRUE(block_is_seen(false, usual, usual)) << "the smaller of equal ones";
  for (const bool first : {true, false}) {
    EXPECT_TRUE(block_is_seen(first, pale, usual));
    EXPECT_FALSE(block_is_seen(first, usual, pale));
    EXPECT_TRUE(block_is_seen(first, usual, own));
    EXPECT_FALSE(block_is_seen(first, own, usual));
    // Lines in which parts meet are not all: a style may have none.
    pale.style->feature.intersections = false;
    usual.style = builtin_style("flat");
    usual.style->feature.intersections = false;
    EXPECT_TRUE(block_is_seen(first, pale, usual));
    usual.style.reset();
    pale.style->feature.intersections = true;
  }
}

TEST(PartStyles, OfGlassAndASolidPartThatLieOnEachOtherThatWhichShowsMoreIsSeen) {
  PartStyle usual, glass, pale, pale_glass;
  glass.transparent = pale_glass.transparent = true;
  pale.style = pale_glass.style = builtin_style("flat");
  pale.style->line.color = pale_glass.style->line.color = "#a0a0a0";
  const auto glass_is_seen = [](bool first, const PartStyle& plate, const PartStyle& block) {
    const Drawing drawing = flush(first, plate, block);
    EXPECT_EQ(drawing.stats.verify->wrong_patches, 0);
    return area_of_part(drawing, "block") > 1;
  };
  for (const bool first : {true, false}) {
    EXPECT_FALSE(glass_is_seen(first, usual, glass)) << "of equal ones what is solid";
    EXPECT_TRUE(glass_is_seen(first, pale, glass));
    EXPECT_FALSE(glass_is_seen(first, usual, pale_glass));
  }
}

TEST(PartStyles, KeysThatHoldForAWholeDrawingAreTold) {
  const Scene scene = wall_and_balls();
  PartStyle white;
  white.style = builtin_style("scratchboard");
  const Drawing drawing = draw_styled(scene, {{}, {}, white});
  const auto entries = drawing.diagnostics.entries();
  const auto reported = std::ranges::find(entries, "option.unused", &Diagnostic::code);
  ASSERT_NE(reported, entries.end());
  EXPECT_NE(reported->message.find("sheet.ink, sheet.paper of style 'scratchboard'"),
            std::string::npos)
      << reported->message;
  EXPECT_NE(reported->message.find("line.color"), std::string::npos);
  PartStyle plain;
  plain.style = builtin_style("outline");
  EXPECT_TRUE(draw_styled(scene, {{}, {}, plain}).diagnostics.entries().empty());
}

}  // namespace
}  // namespace burin
