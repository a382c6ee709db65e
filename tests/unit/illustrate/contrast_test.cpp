/// Lines are seen on the colours of areas.

#include <burin/drawing/color.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace burin {
namespace {

constexpr double kRounding = 0.03;  // of eight bits

Drawing colored_ball(const std::string& color, const Style& style) {
  Scene scene;
  scene.parts.push_back(
      {"ball", "a.stl", std::make_shared<MeshForm>(test::ellipsoid(Vec3(20), 32, 16))});
  scene.parts[0].color = color;
  RunContext context;
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = {0, -1, 0}, .paper = {100, 100}});
  return illustrate(scene, camera, style, {}, context);
}

std::set<std::string> fill_colors(const Drawing& drawing) {
  std::set<std::string> out;
  for (const Area& area : drawing.areas) out.insert(area.fill);
  return out;
}

double least_contrast(const Drawing& drawing, const Rgb& ink) {
  double least = 21;
  for (const std::string& fill : fill_colors(drawing)) {
    least = std::min(least, contrast(rgb_of(fill).value(), ink));
  }
  return least;
}

std::ptrdiff_t warnings(const Drawing& drawing) {
  return std::ranges::count(drawing.diagnostics.entries(), "fill.low_contrast", &Diagnostic::code);
}

TEST(Contrast, IsThatOfWcag) {
  EXPECT_NEAR(contrast({0, 0, 0}, {255, 255, 255}), 21, 1e-9);
  EXPECT_NEAR(contrast({119, 119, 119}, {255, 255, 255}), 4.48, 0.005) << "known of #777777";
  EXPECT_EQ(contrast({9, 8, 7}, {9, 8, 7}), 1);
}

TEST(Contrast, OfBlackLinesIsKeptInAllTonesOfColoursOfTheInput) {
  for (const std::string color :
       {"#000000", "#202020", "#102080", "#0000ff", "#d62728", "#6e6e6e"}) {
    for (const double darkest : {0.0, 0.55, 0.8, 1.0}) {
      Style style = builtin_style("flat");
      style.fill.steps = 3;
      style.fill.darkest = darkest;
      const Drawing drawing = colored_ball(color, style);
      EXPECT_GE(least_contrast(drawing, {0, 0, 0}), kLeastShadeContrast - kRounding)
          << color << darkest;
      double most = 1;
      for (const std::string& fill : fill_colors(drawing)) {
        most = std::max(most, contrast(rgb_of(fill).value(), {0, 0, 0}));
      }
      EXPECT_GE(most, kLeastContrast - kRounding) << color << darkest << " in full light";
      EXPECT_EQ(fill_colors(drawing).size(), darkest < 1 ? 3u : 1u) << "tones are told apart";
      EXPECT_EQ(warnings(drawing), 0);
    }
  }
}

TEST(Contrast, ChangesNoColourThatHasIt) {
  Style style = builtin_style("cel");
  const std::string pale = "#e0c080";
  std::set<std::string> wanted;
  for (const double light : {0.0, 0.5, 1.0}) {
    const double share = style.fill.darkest + (1 - style.fill.darkest) * light;
    wanted.insert(to_text(with_lightness(rgb_of(pale).value(), share)));
  }
  EXPECT_EQ(fill_colors(colored_ball(pale, style)), wanted);
}

TEST(Contrast, OfWhiteLinesIsKeptByDarkerColours) {
  Style style = builtin_style("flat");
  style.line.color = "#ffffff";
  for (const std::string color : {"#fafafa", "#ffee00", "#999999"}) {
    EXPECT_GE(least_contrast(colored_ball(color, style), {255, 255, 255}),
              kLeastContrast - kRounding)
        << color;
  }
  EXPECT_EQ(fill_colors(colored_ball("#808080", style)), std::set<std::string>{"#808080"})
      << "dark enough";
}

TEST(Contrast, OfGreyLinesLeavesTonesApart) {
  Style style = builtin_style("flat");
  style.line.color = "#8c8c8c";
  style.fill.steps = 2;
  EXPECT_EQ(fill_colors(colored_ball("#ffffff", style)).size(), 2u);
  EXPECT_FALSE(fill_colors(colored_ball("#2040a0", style)).contains("#ffffff")) << "still blue";
}

TEST(Contrast, OfNamedColoursIsAsTheUserSaysAndTold) {
  Style style = builtin_style("flat");
  style.fill.color = "#202020";
  const Drawing dark = colored_ball("#ffffff", style);
  EXPECT_EQ(fill_colors(dark), std::set<std::string>{"#202020"});
  ASSERT_EQ(warnings(dark), 1);
  const auto told =
      std::ranges::find(dark.diagnostics.entries(), "fill.low_contrast", &Diagnostic::code);
  EXPECT_EQ(told->message,
            "lines can hardly be seen on 'ball': #000000 on #202020 has a contrast "
            "of 1.3; choose another line.color or fill.color");
  style.line.color = "#ffffff";
  EXPECT_EQ(warnings(colored_ball("#ffffff", style)), 0);
  style.fill.color = "#f0f0f0";
  EXPECT_EQ(warnings(colored_ball("#ffffff", style)), 1) << "white on white";
  style.fill.color = "part";
  style.fill.opacity = 0.4;
  EXPECT_EQ(warnings(colored_ball("#ffffff", style)), 1) << "the paper is white, too";
  // Its darkest tone, which is none where areas are not painted.
  style = builtin_style("flat");
  style.fill.color = "#d62728";
  style.fill.steps = 3;
  style.fill.darkest = 0.3;
  EXPECT_EQ(warnings(colored_ball("#ffffff", style)), 1);
  style.fill.opacity = 0;
  EXPECT_EQ(warnings(colored_ball("#ffffff", style)), 0);
}

TEST(Contrast, OfAColourThatStaysIsWhatItsDarkestToneCanGive) {
  EXPECT_EQ(readable_darkest({{255, 255, 255}, 0.55}, {0, 0, 0}), 0.55) << "seen as it is";
  EXPECT_EQ(readable_darkest({{242, 142, 43}, 0.55}, {0, 0, 0}), 0.55) << "its shade is, too";
  const double share = readable_darkest({{214, 39, 40}, 0.55}, {0, 0, 0});
  EXPECT_NEAR(contrast(with_lightness({214, 39, 40}, share), {0, 0, 0}), kLeastShadeContrast,
              kRounding);
  EXPECT_EQ(readable_darkest({{0, 0, 0}, 0.55}, {0, 0, 0}), 0.86) << "no tone of black does";
  EXPECT_EQ(readable_darkest({{0, 0, 0}, 0.9}, {0, 0, 0}), 0.9);
}

TEST(Contrast, OfHatchingInTheColourOfAPartIsThatOfThePaintedColour) {
  Style style = builtin_style("flat");
  const std::set<std::string> painted = fill_colors(colored_ball("#101010", style));
  style.fill.opacity = 0;
  style.fill.hatch.lines = FillHatch::Lines::Lines;
  style.fill.hatch.color = "fill";
  std::set<std::string> colors;
  for (const Layer& layer : colored_ball("#101010", style).layers) {
    if (layer.name != "fill-hatch") continue;
    for (const Path& path : layer.paths) colors.insert(path.color);
  }
  EXPECT_EQ(colors, painted);
}

}  // namespace
}  // namespace burin
