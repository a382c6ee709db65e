/// Drawings compared line by line, and drawn in one.

#include <burin/base/error.h>
#include <burin/revisions/line_changes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace burin {
namespace {

Path line(std::vector<Vec2> points, SourceId source, LineClass kind = LineClass::Crease) {
  Path p;
  p.kind = kind;
  p.source = source;
  p.points = std::move(points);
  p.width = {0.25};
  return p;
}

/// A square of 20 mm as four creases, and a stroke.
Drawing square() {
  Drawing d;
  d.parts.push_back({0, "block", "a.stl"});
  Layer creases{"crease", {}};
  const std::vector<Vec2> corners{{50, 50}, {70, 50}, {70, 70}, {50, 70}};
  for (int i = 0; i < 4; ++i) {
    creases.paths.push_back(
        line({corners[static_cast<std::size_t>(i)], corners[static_cast<std::size_t>((i + 1) % 4)]},
             {0, -1, i}));
  }
  d.layers.push_back(std::move(creases));
  d.layers.push_back({"stroke-1", {line({{52, 60}, {68, 60}}, {0, 1, -1}, LineClass::Stroke)}});
  d.layers.push_back({"callouts", {}, {{{10, 10}, 5, TextAnchor::Middle, "1", "callout", 1}}});
  return d;
}

LineDifference compared(const Drawing& a, const Drawing& b, double tolerance = 0.1) {
  const RunContext context;
  return compare_drawings(a, b, tolerance, context);
}

std::size_t count(const LineDifference& d, LineChange change) {
  return d.counts[static_cast<std::size_t>(change)];
}

TEST(LineChanges, OneDrawingIsTheSame) {
  Drawing other = square();
  std::ranges::reverse(other.layers);
  std::ranges::reverse(other.layers.back().paths[0].points);
  const LineDifference d = compared(square(), other);
  EXPECT_TRUE(d.same());
  EXPECT_EQ(count(d, LineChange::Same), 5U);
  EXPECT_NEAR(d.lengths[static_cast<std::size_t>(LineChange::Same)], 4 * 20 + 16, 1e-9);
}

TEST(LineChanges, NewAndGoneLines) {
  Drawing other = square();
  other.layers[0].paths.erase(other.layers[0].paths.begin());
  other.layers[0].paths.push_back(line({{50, 50}, {70, 70}}, {0, -1, 9}));
  const LineDifference d = compared(square(), other);
  ASSERT_EQ(d.lines.size(), 2U);
  EXPECT_EQ(d.lines[0].change, LineChange::New);
  EXPECT_EQ(d.lines[0].part, "block");
  EXPECT_NEAR(d.lines[0].length, 20 * std::sqrt(2.0), 1);
  EXPECT_EQ(d.lines[1].change, LineChange::Gone);
  EXPECT_EQ(d.lines[1].path_index, 0U);
  EXPECT_EQ(d.lines[1].layer_index, 0U);
}

TEST(LineChanges, AMovedLineIsKnownByItsEdge) {
  Drawing other = square();
  for (Vec2& p : other.layers[0].paths[0].points) p.y -= 3;
  const LineDifference d = compared(square(), other);
  ASSERT_EQ(d.lines.size(), 1U);
  EXPECT_EQ(d.lines[0].change, LineChange::Moved);
  EXPECT_NEAR(d.lines[0].distance, 3, 1e-9);
  EXPECT_TRUE(compared(square(), other, 3.1).same());
}

TEST(LineChanges, ALineThatIsLongerIsNewBeyondTheOldOne) {
  Drawing other = square();
  other.layers[0].paths[0].points[1].x += 10;
  const LineDifference d = compared(square(), other);
  ASSERT_EQ(d.lines.size(), 1U);
  EXPECT_NEAR(d.lines[0].length, 10, 0.2);
}

TEST(LineChanges, StrokesTextsAndSheetsCount) {
  Drawing other = square();
  other.layers[1].paths.clear();
  other.layers[2].texts[0].text = "2";
  other.paper_width = 200;
  const LineDifference d = compared(square(), other);
  EXPECT_EQ(count(d, LineChange::Gone), 1U);
  ASSERT_EQ(d.texts_new.size(), 1U);
  ASSERT_EQ(d.texts_gone.size(), 1U);
  EXPECT_FALSE(d.same_sheet);
  // A stroke on a crease is not that crease.
  other = square();
  other.layers[1].paths[0].points = other.layers[0].paths[0].points;
  EXPECT_EQ(count(compared(square(), other), LineChange::New), 1U);
}

TEST(LineChanges, HiddenLinesAndWidthsDoNotCount) {
  Drawing other = square();
  other.layers[0].paths[1].width = {0.7};
  other.layers[0].paths.push_back(line({{0, 0}, {5, 5}}, {0, -1, 7}));
  other.layers[0].paths.back().visible = false;
  EXPECT_TRUE(compared(square(), other).same());
}

TEST(LineChanges, AreDrawnInTheirLooks) {
  Drawing other = square();
  other.layers[0].paths.erase(other.layers[0].paths.begin());
  other.layers[0].paths.push_back(line({{50, 50}, {70, 70}}, {0, -1, 9}));
  const LineDifference d = compared(square(), other);
  const RunContext context;
  const Drawing both = overlay({square(), other}, d, OverlayOptions{}, context);
  const auto layer = [&](const std::string& name) -> const Layer& {
    const auto found = std::ranges::find(both.layers, name, &Layer::name);
    EXPECT_NE(found, both.layers.end()) << name;
    return found == both.layers.end() ? both.layers.front() : *found;
  };
  EXPECT_EQ(layer("new-crease").color, "#00802b");
  EXPECT_GT(layer("new-crease").paths[0].width[0], 0.25) << "holds in black and white";
  EXPECT_EQ(layer("gone-crease").dashes, (std::vector<double>{2, 1}));
  EXPECT_EQ(layer("gone-crease").paths[0].source.part, -1);
  EXPECT_EQ(layer("same-crease").color, "#999999");
  EXPECT_EQ(layer("legend").texts.size(), 3U);
  EXPECT_EQ(layer("legend").texts[0].text, "1 line new");
}

TEST(LineChanges, TheLegendStandsBelowTheDrawing) {
  Drawing low = square();
  for (Layer& layer : low.layers) {
    for (Path& path : layer.paths) {
      for (Vec2& p : path.points) p.y -= 48;
    }
  }
  Drawing other = low;
  other.layers[0].paths.pop_back();
  const RunContext context;
  OverlayOptions options;
  options.margin = {10, 10, 3, 10};
  const Drawing both = overlay({low, other}, compared(low, other), options, context);
  double top = 0, foot = both.paper_height;
  for (const Layer& layer : both.layers) {
    const bool legend = layer.name.starts_with("legend");
    for (const Text& text : layer.texts) {
      if (legend) top = std::max(top, text.at.y + text.height);
      if (!legend) foot = std::min(foot, text.at.y);
    }
    for (const Path& path : layer.paths) {
      for (const Vec2 p : path.points) {
        if (!legend) foot = std::min(foot, p.y);
      }
    }
  }
  EXPECT_GT(top, 3);
  EXPECT_GT(foot, top + 1);
  EXPECT_NEAR(both.paper_height - low.paper_height, foot - 2, 1e-9) << "what was 2 mm up";
  // A drawing that leaves room stays where it was.
  Drawing high = square();
  high.layers.pop_back();
  EXPECT_EQ(overlay({high, high}, compared(high, high), options, context).paper_height, 210);
}

TEST(LineChanges, CanBeCancelled) {
  RunContext context;
  context.cancel();
  EXPECT_THROW(compare_drawings(square(), square(), 0.1, context), Cancelled);
}

/// The square painted, its right half darker: as areas that lie over each other.
Drawing painted(const char* color, double from = 60) {
  Drawing d = square();
  d.areas.push_back(
      {.part = 0, .tone = 1, .fill = color, .rings = {{{50, 50}, {70, 50}, {70, 70}, {50, 70}}}});
  d.areas.push_back({.part = 0,
                     .tone = 0,
                     .fill = "#202020",
                     .rings = {{{from, 50}, {70, 50}, {70, 70}, {from, 70}}}});
  return d;
}

TEST(LineChanges, FlatColoursOfOneDrawingAreTheSame) {
  EXPECT_TRUE(compared(painted("#80a0c0"), painted("#80a0c0")).same());
  // Rings that begin elsewhere, one area in two, and what is painted over: it looks the same.
  Drawing other = painted("#80a0c0");
  std::vector<Vec2>& ring = other.areas[0].rings[0];
  std::rotate(ring.begin(), ring.begin() + 2, ring.end());
  other.areas.insert(other.areas.begin(),
                     Area{.part = 0, .fill = "#ff0000", .rings = {{{51, 51}, {52, 51}, {52, 52}}}});
  EXPECT_TRUE(compared(painted("#80a0c0"), other).same());
  // Areas that are not painted are no ink.
  Drawing bare = square();
  bare.areas.push_back({.part = 0, .rings = {{{50, 50}, {70, 50}, {70, 70}}}});
  EXPECT_TRUE(compared(square(), bare).same());
}

TEST(LineChanges, AnotherColourOfAPart) {
  const LineDifference d = compared(painted("#80a0c0"), painted("#ff0000"));
  EXPECT_FALSE(d.same());
  EXPECT_TRUE(d.lines.empty());
  ASSERT_EQ(d.fills.size(), 1U);
  EXPECT_EQ(d.fills[0].part, "block");
  EXPECT_EQ(d.fills[0].before, "#80a0c0");
  EXPECT_EQ(d.fills[0].after, "#ff0000");
  EXPECT_NEAR(d.fills[0].size, 200, 15);
  EXPECT_GT(d.fills[0].at.x, 50);
  EXPECT_LT(d.fills[0].at.x, 60);
}

/// What has changed behind glass is the part there, not the glass.
TEST(LineChanges, AnotherColourBehindGlass) {
  const auto behind_glass = [](const char* color, const char* glass) {
    Drawing d = painted(color);
    DrawingPart pane;
    pane.id = 7;
    pane.name = "pane";
    d.parts.push_back(pane);
    d.areas.push_back({.part = 7,
                       .fill = glass,
                       .opacity = 0.25,
                       .rings = {{{50, 50}, {70, 50}, {70, 70}, {50, 70}}}});
    return d;
  };
  const LineDifference d =
      compared(behind_glass("#80a0c0", "#ffffff"), behind_glass("#ff0000", "#ffffff"));
  ASSERT_EQ(d.fills.size(), 1U);
  EXPECT_EQ(d.fills[0].part, "block");
  EXPECT_NEAR(d.fills[0].size, 200, 15);
  const LineDifference pane =
      compared(behind_glass("#80a0c0", "#ffffff"), behind_glass("#80a0c0", "#00ff00"));
  ASSERT_FALSE(pane.fills.empty());
  EXPECT_EQ(pane.fills[0].part, "pane");
}

TEST(LineChanges, AnotherToneAndAnotherOpacityOfAPart) {
  const LineDifference tone = compared(painted("#80a0c0", 60), painted("#80a0c0", 65));
  ASSERT_EQ(tone.fills.size(), 1U);
  EXPECT_EQ(tone.fills[0].before, "#202020");
  EXPECT_EQ(tone.fills[0].after, "#80a0c0");
  EXPECT_NEAR(tone.fills[0].size, 100, 10);
  Drawing pale = painted("#80a0c0");
  pale.areas[0].opacity = 0.5;
  const LineDifference opacity = compared(painted("#80a0c0"), pale);
  ASSERT_EQ(opacity.fills.size(), 1U);
  EXPECT_EQ(opacity.fills[0].after, "#c0d0e0") << "mixed with the paper";
}

TEST(LineChanges, AnotherInkOrTintThatLooksTheSame) {
  Drawing before = painted("#80a0c0");
  before.inks = {{"Spot", "#0040a0"}};
  before.areas[0].ink = "Spot";
  before.areas[0].tint = 0.5;
  EXPECT_TRUE(compared(before, before).same());
  Drawing after = before;
  after.areas[0].tint = 0.6;
  const LineDifference tint = compared(before, after);
  ASSERT_EQ(tint.fills.size(), 1U);
  EXPECT_EQ(tint.fills[0].part, "block");
  EXPECT_EQ(tint.fills[0].ink_before, (InkTint{"Spot", 0.5}));
  EXPECT_EQ(tint.fills[0].ink_after, (InkTint{"Spot", 0.6}));
  EXPECT_TRUE(tint.inks.empty());
  after = before;
  after.inks[0].name = after.areas[0].ink = "Reflex Blue";
  const LineDifference ink = compared(before, after);
  ASSERT_EQ(ink.fills.size(), 1U);
  EXPECT_EQ(ink.fills[0].ink_after, (InkTint{"Reflex Blue", 0.5}));
  ASSERT_EQ(ink.inks.size(), 2U);
  EXPECT_EQ(ink.inks[0].name, "Reflex Blue");
  EXPECT_EQ(ink.inks[0].before, "");
  EXPECT_EQ(ink.inks[1].after, "");
  after = before;
  after.inks[0].color = "#ff0000";
  EXPECT_FALSE(compared(before, after).same()) << "the plate is another one";
}

TEST(LineChanges, AColourThatIsNewOrGone) {
  const LineDifference added = compared(square(), painted("#80a0c0")),
                       gone = compared(painted("#80a0c0"), square());
  ASSERT_EQ(added.fills.size(), 2U);
  ASSERT_EQ(gone.fills.size(), 2U);
  EXPECT_EQ(added.fills[0].before, "");
  EXPECT_EQ(gone.fills[0].after, "");
  EXPECT_EQ(gone.fills[0].part, "block");
}

TEST(LineChanges, ColoursAreShownInThePicture) {
  const Drawing before = painted("#80a0c0"), after = painted("#ff0000");
  const RunContext context;
  const Drawing d = overlay({before, after}, compared(before, after), {}, context);
  ASSERT_EQ(d.areas.size(), 2U);
  EXPECT_EQ(d.areas[0].fill, "#ff0000");
  const auto fills = std::ranges::find(d.layers, "look-fills", &Layer::name);
  ASSERT_NE(fills, d.layers.end());
  EXPECT_EQ(fills->paths.size(), 2U);
  bool told = false;
  for (const Layer& layer : d.layers) {
    for (const Text& text : layer.texts) told = told || text.text == "1 of other colours";
  }
  EXPECT_TRUE(told);
  // Of colours that are gone borders are left.
  const Drawing bare = square();
  const Drawing gone = overlay({before, bare}, compared(before, bare), {}, context);
  EXPECT_TRUE(gone.areas.empty());
  EXPECT_NE(std::ranges::find(gone.layers, "look-fills", &Layer::name), gone.layers.end());
  // What did not change is not painted.
  EXPECT_TRUE(overlay({before, before}, compared(before, before), {}, context).areas.empty());
}

TEST(LineChanges, ColoursFollowASheetThatGetsHigherForTheLegend) {
  Drawing before = painted("#80a0c0"), after = painted("#ff0000");
  for (Drawing* d : {&before, &after}) {
    d->paper_width = 120, d->paper_height = 120;
    for (Layer& layer : d->layers) {
      for (Path& path : layer.paths) {
        for (Vec2& p : path.points) p.y -= 49;
      }
    }
    for (Area& area : d->areas) {
      for (Vec2& p : area.rings[0]) p.y -= 49;
    }
  }
  const RunContext context;
  const Drawing d = overlay({before, after}, compared(before, after), {}, context);
  ASSERT_GT(d.paper_height, 120);
  EXPECT_NEAR(d.areas[0].rings[0][0].y, 1 + d.paper_height - 120, 1e-9);
}

}  // namespace
}  // namespace burin
