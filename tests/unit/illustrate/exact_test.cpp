// Drawings of exact forms: what each path says of the faces that it runs over.

#include <burin/forms/patches/parametric_form.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/charts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <set>

namespace burin {
namespace {

/// A ball of six patches that meet in smooth edges.
Drawing draw_ball(const Style& style) {
  Scene scene;
  scene.parts.push_back(
      {"ball", "ball.itd", std::make_shared<ParametricForm>(test::six_patches(Vec3(10)))});
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                  {.direction = glm::normalize(Vec3(1, -0.7, 0.4)), .paper = {100, 80}});
  RunContext context;
  return illustrate(scene, camera, style, {}, context);
}

double paper_length(const Path& p, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) {
    sum += glm::distance(p.points[i], p.points[i + 1 == p.points.size() ? 0 : i + 1]);
  }
  return sum;
}

TEST(ExactDrawing, AContourOverManyFacesIsOneCircle) {
  const Drawing d = draw_ball(builtin_style("outline"));
  ASSERT_EQ(d.parts.size(), 1u);
  EXPECT_EQ(d.parts[0].faces, 6);
  ASSERT_EQ(d.layers.size(), 1u) << "edges that divide one sphere are no lines";
  ASSERT_EQ(d.layers[0].name, "outline");
  ASSERT_EQ(d.layers[0].paths.size(), 1u);
  const Path& p = d.layers[0].paths[0];
  EXPECT_EQ(p.kind, LineClass::Contour);
  EXPECT_TRUE(p.closed);
  EXPECT_EQ(p.source.edge, -1);
  const double radius = 10 * d.view.scale;
  EXPECT_NEAR(paper_length(p, 0, p.points.size()), 2 * std::numbers::pi * radius, 0.05);
  // The faces: in order, each different from the one before, the main one the longest.
  ASSERT_GE(p.faces.size(), 4u);
  EXPECT_EQ(p.faces[0].first_point, 0u);
  std::map<std::int32_t, double> length;
  for (std::size_t i = 0; i < p.faces.size(); ++i) {
    const bool last = i + 1 == p.faces.size();
    const std::size_t end = last ? p.points.size() : p.faces[i + 1].first_point;
    ASSERT_LT(p.faces[i].first_point, end);
    if (!last) {
      EXPECT_NE(p.faces[i].face, p.faces[i + 1].face);
    }
    EXPECT_GE(p.faces[i].face, 0);
    EXPECT_LT(p.faces[i].face, 6);
    length[p.faces[i].face] += paper_length(p, p.faces[i].first_point, end);
    const Vec3 middle = p.points3[(p.faces[i].first_point + end) / 2 % p.points3.size()];
    EXPECT_NEAR(glm::length(middle), 10, 0.01);
  }
  for (const auto& [face, sum] : length) EXPECT_LE(sum, length[p.source.face] + 0.02);
}

TEST(ExactDrawing, StrokesRunOnOverFacesAndNameThem) {
  const Drawing d = draw_ball(builtin_style("engraving"));
  std::set<std::int32_t> faces;
  std::size_t several = 0;
  for (const Layer& layer : d.layers) {
    for (const Path& p : layer.paths) {
      if (p.kind != LineClass::Stroke) continue;
      faces.insert(p.source.face);
      if (!p.faces.empty()) {
        ++several;
        EXPECT_LT(p.faces.back().first_point + 1, p.points.size());
      }
    }
  }
  EXPECT_GE(faces.size(), 3u);
  EXPECT_GE(several, 10u);
}

TEST(ExactDrawing, SeamsAreDrawnWhereTheStyleAsksForThem) {
  Style style = builtin_style("outline");
  style.feature.seams = true;
  const Drawing d = draw_ball(style);
  ASSERT_EQ(d.layers.size(), 2u);
  EXPECT_EQ(d.layers[0].name, "seam");
  std::set<std::int32_t> edges;
  for (const Path& p : d.layers[0].paths) {
    EXPECT_EQ(p.kind, LineClass::Seam);
    EXPECT_TRUE(p.faces.empty());
    EXPECT_EQ(p.width, std::vector<double>{style.line.smooth});
    edges.insert(p.source.edge);
  }
  for (const Layer& layer : d.layers) {
    for (const Path& p : layer.paths) {
      for (const PathSource& also : p.also) {
        if (also.kind == LineClass::Seam) edges.insert(also.source.edge);
      }
    }
  }
  // Of the cube's twelve edges nine face a viewer at a corner; three pairs of ends at the contour.
  EXPECT_GE(edges.size(), 9u);
  EXPECT_LE(edges.size(), 12u);
}

}  // namespace
}  // namespace burin
