#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace burin {
namespace {

// A wall with level strokes, and a post before it that parts it in two.
Drawing wall_behind_post() {
  Scene scene;
  scene.parts.push_back(
      {"wall", "", std::make_shared<MeshForm>(test::box({-30, 0, -30}, {30, 2, 30}))});
  scene.parts.push_back(
      {"post", "", std::make_shared<MeshForm>(test::box({-9, -12, -31}, {2, -8, 31}))});
  const NamedView v = named_view("front");
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = v.direction, .up = v.up, .paper = {80, 80}});
  Style style = builtin_style("engraving");
  style.hatch.field.name = "fixed";
  style.hatch.field.direction = {1, 0, 0};
  style.hatch.cross_from = 2;
  RunContext context;
  return illustrate(scene, camera, style, {}, context);
}

TEST(Strokes, GoOnBehindWhatHidesThemAsTheSameLine) {
  const Drawing drawing = wall_behind_post();
  const double left = 40 - 9 * drawing.view.scale, right = 40 + 2 * drawing.view.scale;
  // Heights of the ends of the wall's strokes at both sides of the post.
  std::vector<double> ends[2];
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind != LineClass::Stroke || path.source.part != 0) continue;
      for (const Vec2 p : {path.points.front(), path.points.back()}) {
        if (std::abs(p.x - left) < 0.1) ends[0].push_back(p.y);
        if (std::abs(p.x - right) < 0.1) ends[1].push_back(p.y);
      }
    }
  }
  ASSERT_GT(ends[0].size(), 40u);
  int alone = 0;
  for (const double y : ends[0]) {
    alone += std::none_of(ends[1].begin(), ends[1].end(),
                          [&](double other) { return std::abs(other - y) < 0.02; });
  }
  EXPECT_EQ(alone, 0) << "of " << ends[0].size();
}

}  // namespace
}  // namespace burin
