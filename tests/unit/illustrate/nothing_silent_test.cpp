// What a user asked for and does not get is reported.
#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace burin {
namespace {

Scene scene_of_meshes(std::vector<TriMesh> meshes) {
  Scene scene;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    scene.parts.push_back({"part " + std::to_string(i), "part.stl",
                           std::make_shared<MeshForm>(std::move(meshes[i]))});
  }
  return scene;
}

Scene one_box() { return scene_of_meshes({test::box({0, 0, 0}, {10, 10, 10})}); }

Drawing draw_silent(const Scene& scene, const Style& style,
                    const ViewOptions& view = {.paper = {100, 80}},
                    const IllustrateOptions& options = {}) {
  RunContext context;
  const auto extent = [&](const Mat3& axes) { return scene.bounds(axes); };
  return illustrate(scene, Camera::fit(extent, view), style, options, context);
}

Style engraving(const char* field, Vec3 direction = {0, 0, 1}) {
  Style style = builtin_style("engraving");
  style.hatch.field.name = field;
  style.hatch.field.direction = direction;
  return style;
}

// The message of a diagnostic; empty where there is none.
std::string said(const Drawing& drawing, const std::string& code) {
  for (const Diagnostic& d : drawing.diagnostics.entries()) {
    if (d.code == code) return d.message;
  }
  return "";
}

TEST(NothingSilent, StrokesWithoutADirectionAreTold) {
  const Scene two =
      scene_of_meshes({test::box({0, 0, 0}, {10, 10, 10}), test::torus(20, 8, 64, 32)});
  const std::string none =
      said(draw_silent(one_box(), engraving("isoparametric")), "strokes.no_direction");
  EXPECT_NE(none.find("'part 0' gets no strokes"), std::string::npos) << none;
  EXPECT_NE(none.find("no parameter lines"), std::string::npos) << none;
  const std::string flat = said(draw_silent(two, engraving("principal")), "strokes.no_direction");
  EXPECT_NE(flat.find("'part 0' gets no strokes"), std::string::npos) << flat;
  EXPECT_EQ(flat.find("'part 1'"), std::string::npos) << flat;
  Style dim = engraving("fixed");
  dim.tone.ambient = 0.2;  // else its top is white
  const std::string top = said(draw_silent(one_box(), dim), "strokes.no_direction");
  EXPECT_NE(top.find("in places"), std::string::npos) << top;
}

TEST(NothingSilent, StrokesThatCanBeDrawnAreNoMatter) {
  const Scene torus = scene_of_meshes({test::torus(20, 8, 64, 32)});
  for (const char* field : {"smoothed", "principal", "isophote", "isophote-light", "steepest",
                            "silhouette", "screen-vertical"}) {
    const Drawing d = draw_silent(torus, engraving(field));
    EXPECT_TRUE(d.diagnostics.empty()) << field << ": " << d.diagnostics.entries().front().message;
  }
  for (const StyleInfo& style : builtin_styles()) {
    EXPECT_TRUE(draw_silent(one_box(), builtin_style(style.name)).diagnostics.empty())
        << style.name;
  }
  // Full light asks for no strokes.
  Style light = engraving("isoparametric");
  light.tone.ambient = 1;
  EXPECT_EQ(said(draw_silent(one_box(), light), "strokes.no_direction"), "");
}

TEST(NothingSilent, StrokesThatBeginAtFewerPlacesAreTold) {
  const Drawing d =
      draw_silent(scene_of_meshes({test::stacked_sheets(400)}), builtin_style("pencil"),
                  {.direction = {0, -1, 0}, .paper = {100, 80}});
  EXPECT_NE(said(d, "stroke.many_sheets"), "");
}

TEST(NothingSilent, AWordThatNoKeyTakesIsAnError) {
  Style style = engraving("principle");
  EXPECT_THROW(check_style(style), UsageError);
  EXPECT_THROW(draw_silent(one_box(), style), UsageError);
  style = builtin_style("engraving");
  style.hatch.field.faces.cylinder = static_cast<field::FacePolicy::Ruled>(2);
  EXPECT_THROW(draw_silent(one_box(), style), UsageError);
  style = builtin_style("engraving");
  style.line.outer = -1;
  EXPECT_THROW(draw_silent(one_box(), style), UsageError);
}

TEST(NothingSilent, AnEmptyDrawingSaysWhy) {
  Style style = builtin_style("outline");
  EXPECT_NE(
      said(draw_silent(one_box(), style, {.paper = {100, 80}}, {.part_styles = {{.drawn = false}}}),
           "drawing.empty")
          .find("every part is left out"),
      std::string::npos);
  style.feature = {.contours = false,
                   .creases = false,
                   .boundaries = false,
                   .intersections = false,
                   .smooth = false,
                   .trails = false};
  EXPECT_NE(said(draw_silent(one_box(), style), "drawing.empty").find("neither feature lines"),
            std::string::npos);
}

TEST(NothingSilent, WhatRunsOffTheSheetIsCutAndTold) {
  const Style style = builtin_style("engraving");
  const ViewOptions large{.scale = 20.0, .paper = {100, 80}};
  const Drawing cut = draw_silent(one_box(), style, large);
  EXPECT_NE(said(cut, "sheet.clipped").find("would hold it all"), std::string::npos);
  std::size_t strokes = 0;
  for (const Layer& layer : cut.layers) {
    for (const Path& path : layer.paths) {
      strokes += path.kind == LineClass::Stroke;
      ASSERT_EQ(path.points.size(), path.points3.size());
      for (const Vec2& p : path.points) {
        EXPECT_GE(std::min(p.x, p.y), -0.02);
        EXPECT_LE(p.x, 100.02);
        EXPECT_LE(p.y, 80.02);
      }
    }
  }
  EXPECT_EQ(cut.stats.strokes, static_cast<std::int64_t>(strokes));
  EXPECT_GT(strokes, 20u);
  Style whole = style;
  whole.sheet.clip = false;
  const Drawing kept = draw_silent(one_box(), whole, large);
  EXPECT_TRUE(kept.diagnostics.empty());
  double most = 0;
  for (const Layer& layer : kept.layers) {
    for (const Path& path : layer.paths) {
      for (const Vec2& p : path.points) most = std::max(most, p.x);
    }
  }
  EXPECT_GT(most, 150);
}

TEST(NothingSilent, ADrawingOffTheSheetOrADotIsTold) {
  const Style style = builtin_style("outline");
  const Drawing off =
      draw_silent(one_box(), style, {.scale = 2.0, .center = Vec3(500), .paper = {100, 80}});
  EXPECT_NE(said(off, "sheet.outside").find("nothing of the drawing lies on the sheet"),
            std::string::npos);
  EXPECT_TRUE(off.layers.empty());
  const Drawing dot = draw_silent(one_box(), style, {.scale = 0.001, .paper = {100, 80}});
  EXPECT_NE(said(dot, "sheet.dot").find("larger scale"), std::string::npos);
}

TEST(NothingSilent, ADrawingThatFillsTheSheetIsNotCut) {
  for (const char* view : {"front", "iso"}) {
    const NamedView v = named_view(view);
    const Drawing d =
        draw_silent(one_box(), builtin_style("engraving"),
                    {.direction = v.direction, .up = v.up, .margin = 0, .paper = {50, 80}});
    EXPECT_TRUE(d.diagnostics.empty()) << view;
  }
}

}  // namespace
}  // namespace burin
