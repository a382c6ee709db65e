/// Flat colours: which area has which.

#include <burin/drawing/color.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/legend.h>
#include <burin/section/section.h>

#include "burin_test/ring_size.h"
#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// A plate with a colour, two copies of a bolt without one, and a cover, in a row.
Scene row_of_boxes() {
  Scene scene;
  const auto add = [&](const char* name, double x, const char* color) {
    scene.parts.push_back(
        {name, "a.stl", std::make_shared<MeshForm>(test::box({x, -2, -20}, {x + 15, 2, 20}))});
    scene.parts.back().color = color;
  };
  add("plate", 0, "#7090b0");
  add("bolt", 20, "");
  add("bolt #2", 40, "");
  add("cover", 60, "");
  return scene;
}

Drawing draw_fills(const Scene& scene, const Style& style, std::vector<PartStyle> looks = {},
                   const char* view = "front") {
  RunContext context;
  const NamedView v = named_view(view);
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = v.direction, .up = v.up, .paper = {150, 100}});
  return illustrate(scene, camera, style, {.part_styles = std::move(looks)}, context);
}

std::vector<std::string> fills_of(const Drawing& drawing) {
  std::vector<std::string> out(4);
  for (const Area& area : drawing.areas) out.at(static_cast<std::size_t>(area.part)) = area.fill;
  return out;
}

TEST(Fills, ThereAreNoneUnlessTheyAreAskedFor) {
  EXPECT_TRUE(draw_fills(row_of_boxes(), builtin_style("outline")).areas.empty());
}

TEST(Fills, OfPartsAreTheirOwnOrThoseOfAPaletteTheSameForCopies) {
  const std::vector<std::string> all = fills_of(draw_fills(row_of_boxes(), builtin_style("flat")));
  EXPECT_EQ(all[0], "#7090b0");
  EXPECT_TRUE(rgb_of(all[1]));
  EXPECT_EQ(all[1], all[2]) << "copies of one thing";
  EXPECT_NE(all[1], all[3]);
}

TEST(Fills, OfOneColourAreThatButWhereAPartSaysOtherwise) {
  Style style = builtin_style("outline");
  set_style_key(style, "fill.color", "orange");
  std::vector<PartStyle> looks(4);
  looks[1].style = builtin_style("outline");
  looks[2].style = style;
  looks[2].style->fill.color = "#00ff00";
  const std::vector<std::string> all = fills_of(draw_fills(row_of_boxes(), style, looks));
  EXPECT_EQ(all, (std::vector<std::string>{"#f28e2b", "", "#00ff00", "#f28e2b"}));
}

/// A plate of 40 x 4 x 20 mm whose front is red up to x = 10 but for the uppermost quarter, and
/// blue from x = 30 on.
Scene painted_plate() {
  TriMesh mesh = test::box({0, 0, 0}, {40, 4, 20});
  Scene scene;
  scene.parts.push_back({"plate", "a.stl", nullptr});
  // The front in cells of 10 x 5 mm, beside the other sides of the box.
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return mesh.positions[v].y == 0; });
  });
  std::vector<std::int32_t> kind(mesh.triangles.size(), 0);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const auto& [x, z] : {std::pair(i, k), {i + 1, k}, {i + 1, k + 1}, {i, k + 1}}) {
        mesh.positions.emplace_back(10 * x, 0, 5 * z);
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
      kind.resize(kind.size() + 2, i == 0 && k < 3 ? 1 : i == 3 ? 2 : 0);
    }
  }
  auto faces = std::make_shared<std::vector<std::int32_t>>(kind);
  scene.parts[0].form = std::make_shared<MeshForm>(std::move(mesh), nullptr, std::move(faces));
  scene.parts[0].color = "#00ff00";
  scene.parts[0].face_colors =
      std::make_shared<const FaceColors>(FaceColors{{"#ff0000", "#3366ff"}, {-1, 0, 1}});
  return scene;
}

std::map<std::string, double> sizes_of_colors(const Drawing& drawing) {
  std::map<std::string, double> out;
  double all = 0;
  for (const Area& area : drawing.areas) all = std::max(all, std::abs(test::signed_area(area)));
  for (const Area& area : drawing.areas) out[area.fill] += std::abs(test::signed_area(area)) / all;
  return out;
}

TEST(Fills, OfFacesAreTheirOwn) {
  const std::map<std::string, double> found =
      sizes_of_colors(draw_fills(painted_plate(), builtin_style("flat")));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_NEAR(found.at("#00ff00"), 1, 1e-9) << "below the others";
  EXPECT_NEAR(found.at("#ff0000"), 150 / 800.0, 1e-4);
  EXPECT_NEAR(found.at("#3366ff"), 200 / 800.0, 1e-4);
}

TEST(Fills, OfFacesAreThatOfTheStyleWhereItSaysOne) {
  Style style = builtin_style("flat");
  set_style_key(style, "fill.color", "orange");
  const Drawing drawing = draw_fills(painted_plate(), style);
  ASSERT_EQ(drawing.areas.size(), 1u);
  EXPECT_EQ(drawing.areas[0].fill, "#f28e2b");
}

TEST(Fills, OfFacesAreKeptByMirroredAndCutParts) {
  Scene scene = painted_plate();
  Placement mirror;
  mirror.linear[0][0] = -1;
  scene.parts[0].form = scene.parts[0].form->mapped(mirror);
  auto found = sizes_of_colors(draw_fills(scene, builtin_style("flat")));
  EXPECT_NEAR(found["#ff0000"], 150 / 800.0, 1e-4);
  // What is left is the right half, seen mirrored: red and half of the rest.
  scene.parts[0].form = cut_form(scene.parts[0].form, CutPlane{{-1, 0, 0}, 20}, 0, "plate");
  found = sizes_of_colors(draw_fills(scene, builtin_style("flat")));
  EXPECT_NEAR(found["#ff0000"], 150 / 400.0, 1e-4);
  EXPECT_FALSE(found.contains("#3366ff"));
}

TEST(Fills, OfGlassAreSeenThroughAndPaintedLast) {
  Scene scene = row_of_boxes();
  scene.parts.resize(2);
  // The bolt stands behind the plate, which is of glass.
  scene.parts[1].form = std::make_shared<MeshForm>(test::box({5, 10, -5}, {10, 12, 5}));
  std::vector<PartStyle> looks(2);
  looks[0].transparent = true;
  scene.parts[0].opacity = 0.4;
  const Drawing drawing = draw_fills(scene, builtin_style("flat"), looks);
  ASSERT_EQ(drawing.areas.size(), 2u);
  EXPECT_EQ(drawing.areas[0].part, 1);
  EXPECT_EQ(drawing.areas[0].opacity, 1);
  EXPECT_EQ(drawing.areas[1].part, 0);
  EXPECT_EQ(drawing.areas[1].opacity, 0.4);
}

TEST(Fills, AColourThatIsNoneIsRefused) {
  Style style = builtin_style("flat");
  style.fill.color = "orangge";
  try {
    check_style(style);
    FAIL();
  } catch (const std::exception& e) {
    EXPECT_STREQ(e.what(),
                 "style key 'fill.color' takes a colour #rrggbb, orange, red, blue, green, yellow, "
                 "purple, cyan, pink, brown, gray, grey, black, white, another name of CSS such as "
                 "steelblue, part or none, not 'orangge'; the nearest is 'orange'");
  }
  EXPECT_ANY_THROW(set_style_key(style, "tone.steps", "1"));
  EXPECT_ANY_THROW(set_style_key(style, "tone.steps", "6"));
  set_style_key(style, "tone.steps", "5");
  EXPECT_EQ(style.fill.steps, 5);
}

TEST(Fills, OfDarkPartsAreLighterWhereBlackLinesWouldVanish) {
  Scene scene = row_of_boxes();
  scene.parts[0].color = "#000000";
  scene.parts[1].color = "#404047";
  scene.parts[2].color = "#595959";
  scene.parts[3].color = "#5a5a5a";
  Style style = builtin_style("flat");
  EXPECT_EQ(fills_of(draw_fills(scene, style)),
            (std::vector<std::string>{"#595959", "#59595d", "#595959", "#5a5a5a"}));
  style.sheet.ink = "#ffffff";
  EXPECT_EQ(fills_of(draw_fills(scene, style))[0], "#000000") << "white lines are seen";
  style = builtin_style("flat");
  style.fill.color = "#000000";
  EXPECT_EQ(fills_of(draw_fills(scene, style))[0], "#000000") << "as the user says";
}

TEST(Fills, OfTwoTonesLeaveTheLeftSideOfABoxInLightAndTheRightInShade) {
  Scene scene;
  scene.parts.push_back({"box", "a.stl", std::make_shared<MeshForm>(test::box(Vec3(0), Vec3(20)))});
  for (const char* name : {"shaded", "manual"}) {
    double all = 0, shade = 0;
    for (const Area& area : draw_fills(scene, builtin_style(name), {}, "iso").areas) {
      if (area.part < 0) continue;
      (area.tone > 0 ? all : shade) += std::abs(test::signed_area(area));
    }
    EXPECT_NEAR(shade / all, 1 / 3.0, 1e-6) << name;
  }
}

TEST(Fills, OfAnInkAreTintsOfItTheDarkestAllOfIt) {
  Style style = builtin_style("duotone");
  style.shadow.ground = false;
  Scene scene;
  scene.parts.push_back(
      {"ball", "a.stl", std::make_shared<MeshForm>(test::ellipsoid(Vec3(20), 48, 24))});
  const Drawing drawing = draw_fills(scene, style);
  ASSERT_EQ(drawing.inks, (std::vector<SpotInk>{{"Spot", "#0078bf"}}));
  std::vector<double> tints;
  for (const Area& area : drawing.areas) {
    EXPECT_EQ(area.ink, "Spot");
    tints.push_back(area.tint);
    if (area.tone == 0) {
      EXPECT_EQ(area.fill, "#0078bf");
    }
  }
  ASSERT_EQ(tints.size(), 3u);
  EXPECT_NEAR(tints[0], 0.15, 1e-12);
  EXPECT_NEAR(tints[1], 0.575, 1e-12);
  EXPECT_NEAR(tints[2], 1, 1e-12);
}

// "Black" is the plate of the lines: it prints what red it stands for as black.
TEST(Fills, OfAnInkNamedBlackThatIsNoneAreTold) {
  const auto told = [](const char* color) {
    Style style = builtin_style("flat");
    style.fill.ink = "Black";
    style.fill.color = color;
    const Drawing drawing = draw_fills(row_of_boxes(), style);
    return std::ranges::any_of(drawing.diagnostics.entries(),
                               [](const Diagnostic& d) { return d.code == "fill.ink_black"; });
  };
  EXPECT_TRUE(told("#d62728"));
  EXPECT_FALSE(told("#808080"));
}

TEST(Fills, OfOneInkInTwoColoursAreTold) {
  Style style = builtin_style("flat");
  style.fill.ink = "Blue";
  const Drawing drawing = draw_fills(row_of_boxes(), style);
  EXPECT_TRUE(std::ranges::any_of(drawing.diagnostics.entries(), [](const Diagnostic& d) {
    return d.code == "fill.ink_colors" && d.count == 3;
  }));
  style.fill.ink = std::string(128, 'x');
  EXPECT_ANY_THROW(check_style(style)) << "a name in PDF has 127 bytes";
  style.fill.ink = "All";
  EXPECT_ANY_THROW(check_style(style));
}

TEST(Fills, FacesThatAnInkCannotShowAreTold) {
  Style style = builtin_style("flat");
  const auto told = [&] {
    const Drawing drawing = draw_fills(painted_plate(), style);
    std::set<std::string> colors;
    for (const Area& area : drawing.areas) colors.insert(area.fill);
    const auto& all = drawing.diagnostics.entries();
    const auto said = std::ranges::count(all, "fill.ink_faces", &Diagnostic::code);
    return std::pair(static_cast<int>(said), colors.size());
  };
  EXPECT_EQ(told(), std::pair(0, std::size_t{3}));
  style.fill.ink = "Spot";
  EXPECT_EQ(told(), std::pair(1, std::size_t{1})) << "one tint of one ink, as it is printed";
  style.fill.color = "#ff0000";
  EXPECT_EQ(told(), std::pair(0, std::size_t{1})) << "no faces were asked for";
}

TEST(Fills, OfAnInkOnAShadowOfTheGroundAreMixedWithThePaper) {
  Style style = builtin_style("duotone");
  style.fill.steps = 0;
  style.fill.opacity = 0.5;
  style.fill.tint = 0.6;
  style.shadow.ground = true;
  const Drawing drawing = draw_fills(row_of_boxes(), style, {}, "iso");
  ASSERT_EQ(drawing.areas.front().part, -1) << "the shadow";
  for (const Area& area : drawing.areas) {
    if (area.part < 0) continue;
    EXPECT_EQ(area.opacity, 1);
    EXPECT_NEAR(area.tint, 0.3, 1e-12);
  }
}

TEST(Fills, TheLegendHasCopiesOnceAndLeavesOutWhatItIsToldTo) {
  const Scene scene = row_of_boxes();
  const std::vector<DrawingItem> items = {
      {1, "plate", {0}, "", ""}, {2, "bolt", {1, 2}, "", ""}, {3, "cover", {3}, "", ""}};
  IllustrateOptions options;
  const auto rows = legend_rows(scene, builtin_style("shaded"), options, items);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].name, "plate");
  EXPECT_EQ(rows[0].square.fill, "#7090b0") << "in full light";
  EXPECT_EQ(rows[1].name, "bolt");
  EXPECT_EQ(rows[1].item, 2);
  options.part_styles.resize(4);
  options.part_styles[0].style = builtin_style("flat");
  options.part_styles[0].style->fill.legend = false;
  options.part_styles[3].drawn = false;
  EXPECT_EQ(legend_rows(scene, builtin_style("flat"), options, items).size(), 1u);
  EXPECT_TRUE(legend_rows(scene, builtin_style("outline"), {}, items).empty());
}

/// Names and colours of a legend of a drawing of one part.
std::vector<std::string> seen_colors(const Scene& scene, const Style& style) {
  const std::vector<DrawingItem> items = {{1, "plate", {0}, "", ""}};
  IllustrateOptions options;
  options.annotations.emplace();
  options.annotations->items = items;
  options.annotations->legend = legend_rows(scene, style, options, items);
  std::vector<std::string> out;
  const Drawing drawing = draw_fills(scene, style);
  for (const LegendRow& row : with_seen_rows(scene, style, options, drawing).legend) {
    if (!row.seen) continue;
    EXPECT_EQ(row.name, "plate");
    out.push_back(row.square.fill);
  }
  return out;
}

TEST(Fills, TheLegendHasAllOfAnInkWhereThereAreTintsOfIt) {
  const std::vector<DrawingItem> items = {{1, "plate", {0}, "", ""}};
  Style style = builtin_style("duotone");
  const auto square = [&] { return legend_rows(painted_plate(), style, {}, items).at(0).square; };
  EXPECT_EQ(square().fill, to_text(rgb_of(style.fill.color).value()));
  EXPECT_EQ(square().tint, 1);
  EXPECT_EQ(seen_colors(painted_plate(), style).size(), 1u);
  style.fill.steps = 0;
  EXPECT_DOUBLE_EQ(square().tint, style.fill.tint) << "the only one";
}

TEST(Fills, TheLegendHasColoursOfFacesAndThoseThatAreSeenAlone) {
  Scene scene = painted_plate();
  using Strings = std::vector<std::string>;
  EXPECT_EQ(seen_colors(scene, builtin_style("flat")), (Strings{"#00ff00", "#ff0000", "#3366ff"}));
  EXPECT_EQ(seen_colors(scene, builtin_style("cel")), (Strings{"#00ff00", "#ff0000", "#3366ff"}))
      << "in whatever tone";
  // All of the front in colours of its own: the green of the part is at its back alone.
  scene.parts[0].face_colors =
      std::make_shared<const FaceColors>(FaceColors{{"#ff0000", "#3366ff"}, {0, 0, 1}});
  EXPECT_EQ(seen_colors(scene, builtin_style("flat")), (Strings{"#ff0000", "#3366ff"}));
  Style style = builtin_style("flat");
  style.fill.opacity = 0.5;
  style.shadow.ground = true;  // mixes colours with the paper
  EXPECT_EQ(seen_colors(scene, style), (Strings{"#ff0000", "#3366ff"}));
  style.fill.ink = "Blue";
  EXPECT_EQ(seen_colors(scene, style).size(), 1u) << "an ink has no colours of faces";
}

TEST(Fills, OfGlassHaveTheColoursAndOpacitiesOfItsFaces) {
  Scene scene = painted_plate();
  scene.parts[0].face_colors =
      std::make_shared<const FaceColors>(FaceColors{{"#ff0000", "#3366ff33"}, {-1, 0, 1}});
  std::vector<PartStyle> looks(1);
  looks[0].transparent = true;
  const Drawing drawing = draw_fills(scene, builtin_style("flat"), looks);
  std::map<std::string, std::pair<double, double>> found;  // opacity, area
  double all = 0;
  for (const Area& area : drawing.areas) {
    found[area.fill] = {area.opacity, std::abs(test::signed_area(area))};
    all += found[area.fill].second;
  }
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found["#00ff00"].first, 0.25);
  EXPECT_EQ(found["#ff0000"].first, 0.25) << "as the part";
  EXPECT_EQ(found["#3366ff"].first, 0.2);
  EXPECT_NEAR(found["#ff0000"].second / all, 150 / 800.0, 1e-3);
  EXPECT_NEAR(found["#3366ff"].second / all, 200 / 800.0, 1e-3);
  const auto tells = [](const Drawing& d) {
    return std::ranges::any_of(d.diagnostics.entries(),
                               [](const Diagnostic& e) { return e.code == "fill.solid_glass"; });
  };
  EXPECT_FALSE(tells(drawing));
  // A part that is solid as a whole is: that is told.
  const Drawing solid = draw_fills(scene, builtin_style("flat"));
  EXPECT_TRUE(tells(solid));
  for (const Area& area : solid.areas) EXPECT_EQ(area.opacity, 1);
  EXPECT_TRUE(sizes_of_colors(solid).contains("#3366ff"));
  EXPECT_FALSE(tells(draw_fills(scene, builtin_style("outline"))));
}

/// Paper mm of all lines of the layer of hatching.
double hatched_length(const Drawing& drawing) {
  double sum = 0;
  for (const Layer& layer : drawing.layers) {
    if (layer.name != "fill-hatch") continue;
    for (const Path& path : layer.paths) sum += glm::distance(path.points[0], path.points[1]);
  }
  return sum;
}

TEST(Fills, AreHatchedInTheTonesThatAreAskedFor) {
  Scene scene;
  scene.parts.push_back(
      {"ball", "a.stl", std::make_shared<MeshForm>(test::ellipsoid(Vec3(20), 48, 24))});
  Style style = builtin_style("cel");  // three tones, each of which holds the darker ones
  style.fill.hatch.lines = FillHatch::Lines::Lines;
  style.fill.hatch.distance = 0.2;
  const auto size = [&](const Drawing& drawing, int tone) {
    const auto area = std::ranges::find(drawing.areas, tone, &Area::tone);
    return area == drawing.areas.end() ? 0 : std::abs(test::signed_area(*area));
  };
  for (int tones = 1; tones <= 3; ++tones) {
    style.fill.hatch.tones = tones;
    const Drawing drawing = draw_fills(scene, style);
    const double wanted = size(drawing, tones - 1);
    EXPECT_GT(wanted, 100);
    EXPECT_NEAR(hatched_length(drawing) * 0.2, wanted, 0.01 * wanted) << tones;
    EXPECT_EQ(drawing.layers.front().name, "fill-hatch") << "below the lines";
  }
  // Crossed, each tone has what is darker once more.
  style.fill.hatch.tones = 2;
  style.fill.hatch.lines = FillHatch::Lines::Cross;
  const Drawing crossed = draw_fills(scene, style);
  const double both = size(crossed, 1) + size(crossed, 0);
  EXPECT_NEAR(hatched_length(crossed) * 0.2, both, 0.01 * both);
  // In the stead of a colour.
  style.shadow.cast = false;
  const double unshaded = hatched_length(draw_fills(scene, style));
  style.fill.color = "none";
  const Drawing alone = draw_fills(scene, style);
  EXPECT_NEAR(hatched_length(alone), unshaded, 1e-6);
  EXPECT_TRUE(std::ranges::all_of(alone.areas, [](const Area& a) { return a.fill.empty(); }));
}

TEST(Fills, OfFacesAreHatchedOnceInTheirColours) {
  const Scene scene = painted_plate();
  Style style = builtin_style("flat");
  style.fill.hatch.lines = FillHatch::Lines::Lines;
  style.fill.hatch.distance = 0.2;
  style.fill.hatch.color = "fill";
  for (const double opacity : {1.0, 0.5, 0.0}) {
    style.fill.opacity = opacity;
    const Drawing drawing = draw_fills(scene, style);
    std::map<std::string, double> lengths;
    for (const Layer& layer : drawing.layers) {
      if (layer.name != "fill-hatch") continue;
      for (const Path& path : layer.paths) {
        lengths[path.color] += glm::distance(path.points[0], path.points[1]);
      }
    }
    const double all = lengths["#00ff00"] + lengths["#ff0000"] + lengths["#3366ff"];
    EXPECT_EQ(lengths.size(), 3u);
    EXPECT_NEAR(lengths["#ff0000"] / all, 150 / 800.0, 2e-3) << opacity;
    EXPECT_NEAR(lengths["#3366ff"] / all, 200 / 800.0, 2e-3) << opacity;
    for (const Area& area : drawing.areas) EXPECT_EQ(area.fill.empty(), opacity == 0);
  }
  // In one colour no line is drawn twice.
  style.fill.opacity = 1;
  style.fill.hatch.color = "#000000";
  const double painted = hatched_length(draw_fills(scene, style));
  style.fill.color = "#f28e2b";
  EXPECT_NEAR(painted, hatched_length(draw_fills(scene, style)), 1e-3 * painted);
}

TEST(Fills, HatchedInTheColourOfAnInkAreInIt) {
  Style style = builtin_style("flat");
  style.fill.color = "#000000";
  style.fill.ink = "Spot";
  style.fill.opacity = 0;
  style.fill.hatch.lines = FillHatch::Lines::Lines;
  EXPECT_TRUE(draw_fills(row_of_boxes(), style).inks.empty()) << "nothing is printed in it";
  style.fill.hatch.color = "fill";
  const Drawing drawing = draw_fills(row_of_boxes(), style);
  EXPECT_EQ(drawing.inks, (std::vector<SpotInk>{{"Spot", "#000000"}}));
  ASSERT_EQ(drawing.layers.front().name, "fill-hatch");
  EXPECT_EQ(drawing.layers.front().paths.front().color, "#000000") << "that of the sheet says less";
}

TEST(Fills, OfGlassAreNotHatched) {
  Style style = builtin_style("shaded");
  style.fill.hatch.lines = FillHatch::Lines::Lines;
  style.fill.hatch.tones = 2;
  std::vector<PartStyle> looks(4);
  looks[1].transparent = true;
  std::set<std::int32_t> parts;
  for (const Layer& layer : draw_fills(row_of_boxes(), style, looks).layers) {
    if (layer.name != "fill-hatch") continue;
    for (const Path& path : layer.paths) parts.insert(path.source.part);
  }
  EXPECT_EQ(parts, (std::set<std::int32_t>{0, 2, 3}));
}

TEST(Fills, LightnessIsThatOfTheEye) {
  // In OKLab the lightness of a grey is the cube root of its light: half as light is an eighth.
  EXPECT_EQ(with_lightness({255, 255, 255}, 1), (Rgb{255, 255, 255}));
  EXPECT_EQ(with_lightness({255, 255, 255}, 0), (Rgb{0, 0, 0}));
  EXPECT_EQ(with_lightness({255, 255, 255}, 0.5), (Rgb{99, 99, 99}));
  const Rgb red = with_lightness({200, 0, 0}, 0.7);
  EXPECT_EQ(red[1], 0) << "its hue stays";
}

}  // namespace
}  // namespace burin
