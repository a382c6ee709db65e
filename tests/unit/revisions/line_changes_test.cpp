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

}  // namespace
}  // namespace burin
