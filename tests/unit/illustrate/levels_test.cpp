// Lines at whole steps of what a field keeps, and choices of strokes that mean nothing.
#include <burin/base/error.h>
#include <burin/forms/charted/nurbs.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/illustrate/illustrate.h>

#include <burin_test/nurbs_shapes.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

namespace burin {
namespace {

Scene faceted_ball(bool faceted) {
  Scene scene;
  std::shared_ptr<const Form> form = std::make_shared<ParametricForm>(
      std::vector<std::shared_ptr<const Chart>>{make_nurbs_chart(test::sphere_nurbs(10))});
  if (faceted) form = std::make_shared<MeshForm>(test::ellipsoid({10, 10, 10}, 96, 48));
  scene.parts.push_back({"ball", "ball", form});
  return scene;
}

Drawing draw_levels(const Scene& scene, const Style& style) {
  RunContext context;
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = {1, -1, 0.7}, .paper = {90, 90}});
  return illustrate(scene, camera, style, {}, context);
}

// Length of the strokes at each step, and how far any point is from its step, in model mm.
struct Steps {
  std::map<long, double> length;
  double off = 0;
};
Steps steps_of(const Drawing& drawing, double step) {
  Steps out;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind != LineClass::Stroke) continue;
      const long number = std::lround(path.points3.front().z / step);
      for (std::size_t i = 0; i < path.points3.size(); ++i) {
        out.off =
            std::max(out.off, std::abs(path.points3[i].z - step * static_cast<double>(number)));
        if (i > 0) out.length[number] += glm::distance(path.points3[i - 1], path.points3[i]);
      }
    }
  }
  return out;
}

TEST(Levels, OfPlanesAreContourLinesAtWholeStepsOfHeight) {
  for (const bool faceted : {false, true}) {
    SCOPED_TRACE(faceted);
    Style style = builtin_style("contour-map");
    style.hatch.level_step = 1;
    const Steps steps = steps_of(draw_levels(faceted_ball(faceted), style), 1);
    EXPECT_LT(steps.off, faceted ? 0.02 : 1e-6);
    for (long z = -7; z <= 9; ++z) {
      // The part of the circle that faces the viewer; the line of sight rises by 26 degrees.
      const double radius = std::sqrt(100.0 - static_cast<double>(z * z));
      const double rise = 0.7 / std::sqrt(2.0), edge = -rise * static_cast<double>(z) / radius;
      const double seen = 2 * radius * std::acos(std::clamp(edge, -1.0, 1.0));
      const auto found = steps.length.find(z);
      ASSERT_NE(found, steps.length.end()) << z;
      EXPECT_NEAR(found->second, seen, 0.04 * seen + 1) << z;
    }
  }
}

TEST(Levels, HaveARoundStepWhereNoneIsGiven) {
  const Drawing drawing = draw_levels(faceted_ball(false), builtin_style("contour-map"));
  // About 1.6 mm on paper, of 1, 2, 5 and so on: half a model mm at a scale of 3.5.
  EXPECT_LT(steps_of(drawing, 0.5).off, 1e-6);
}

TEST(Levels, ThatAFieldDoesNotHaveOrThatLieTooCloseAreRefused) {
  Style style = builtin_style("contour-map");
  style.hatch.field.name = "smoothed";
  try {
    draw_levels(faceted_ball(false), style);
    FAIL() << "it was drawn";
  } catch (const UsageError& e) {
    EXPECT_NE(
        std::string(e.what()).find("isophote, isophote-light, silhouette, planes, screen-vertical"),
        std::string::npos)
        << e.what();
  }
  style.hatch.field.name = "planes";
  style.hatch.level_step = 0.001;
  EXPECT_THROW(draw_levels(faceted_ball(false), style), UsageError);
}

std::string reported(const Drawing& drawing) {
  std::string all;
  for (const auto& d : drawing.diagnostics.entries()) {
    if (d.code == "option.unused") all += d.message + "\n";
  }
  return all;
}

TEST(UnusedChoices, OfStrokesAreToldOnce) {
  Style style = builtin_style("engraving");
  EXPECT_EQ(reported(draw_levels(faceted_ball(false), style)), "");
  style.hatch.length_law = "2";
  style.hatch.motif = "M0 0h1";
  style.tone.shadow = 0.5;
  style.tone.law = "constant";
  EXPECT_EQ(reported(draw_levels(faceted_ball(false), style)),
            "hatch.length_law has no effect: it is for strokes on points (hatch.placing points, "
            "discs), not even\n"
            "hatch.motif has no effect: it is for strokes on points (hatch.placing points, discs), "
            "not even\n"
            "tone.shadow has no effect: tone.law constant looks at no light\n");
  style.hatch.placing = "discs";
  style.tone.law = "lambert";
  EXPECT_EQ(reported(draw_levels(faceted_ball(false), style)), "");
}

}  // namespace
}  // namespace burin
