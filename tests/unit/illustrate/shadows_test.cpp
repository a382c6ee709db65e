// Shadows that parts cast.
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/tone/tone.h>

#include "burin_test/ink.h"
#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace burin {
namespace {

Camera from_above() {
  Box3 box{{-30, -30, -1}, {30, 30, 12}};
  return Camera::fit([&](const Mat3&) { return box; },
                     {.direction = {0, 0, 1}, .up = {0, 1, 0}, .scale = 1, .paper = {80, 80}});
}

// A lid of 10 x 10 at a height of 10 over a floor; the light comes from the right, 45 degrees up:
// the shadow lies 10 to the left.
Scene lid_over_floor() {
  Scene scene;
  scene.parts.push_back(
      {"floor", "", std::make_shared<MeshForm>(test::box({-30, -30, -1}, {30, 30, 0}))});
  scene.parts.push_back(
      {"lid", "", std::make_shared<MeshForm>(test::box({-5, -5, 10}, {5, 5, 10.5}))});
  return scene;
}

Style lit() {
  Style style = builtin_style("engraving");
  style.tone = {.light = {1, 0, 1}, .ambient = 0.3, .diffuse = 1, .highlight = 1, .rim = 0};
  style.feature.contours = style.feature.creases = style.feature.boundaries = false;
  return style;
}

// The ink in a square of 4 mm about a point of the floor.
double ink_at(const Drawing& drawing, const Camera& camera, Vec2 at) {
  test::Sheet sheet(80, 80, 0.05);
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) sheet.paint(path);
  }
  const std::vector<float> shares = sheet.shares(20);  // 1 mm
  const Vec2 paper = camera.to_paper({at.x, at.y, 0});
  double sum = 0;
  for (int dy = -2; dy < 2; ++dy) {
    for (int dx = -2; dx < 2; ++dx) {
      sum += shares[static_cast<std::size_t>((std::lround(paper.y) + dy) * 80 +
                                             std::lround(paper.x) + dx)];
    }
  }
  return sum / 16;
}

TEST(Shadows, LieWhereTheLightIsHidden) {
  const Camera camera = from_above();
  RunContext context;
  Style style = lit();
  const Drawing without = illustrate(lid_over_floor(), camera, style, {}, context);
  style.tone.shadow = 1;
  const Drawing with = illustrate(lid_over_floor(), camera, style, {}, context);
  for (const Vec2 at : {Vec2(12, 0), Vec2(-10, 12), Vec2(-10, -12), Vec2(-22, 0)}) {
    EXPECT_LT(ink_at(with, camera, at), 0.03) << at.x << ' ' << at.y;
  }
  EXPECT_LT(ink_at(without, camera, {-10, 0}), 0.03);
  // 0.7 of ink, the ambient light is left; half of it with half a shadow.
  EXPECT_NEAR(ink_at(with, camera, {-10, 0}), 0.7, 0.08);
  style.tone.shadow = 0.5;
  const Drawing half = illustrate(lid_over_floor(), camera, style, {}, context);
  EXPECT_NEAR(ink_at(half, camera, {-10, 0}), 0.7 - 0.5 * std::sqrt(0.5), 0.08);
}

TEST(Shadows, OfAWideLightHaveSoftBorders) {
  const Camera camera = from_above();
  tone::ToneOptions options = lit().tone;
  options.shadow = 1;
  // A half plane at a height of 10, from x = 0 to the left, hides the light that comes from there.
  const tone::Blocked blocked = [](Vec3 p, Vec3, Vec3 towards, double) {
    return p.x + 10 * towards.x / towards.z < 0;
  };
  const auto at = [&](double width, double x) {
    options.shadow_width = width;
    return tone::make(camera, options, blocked)({x, 0, 0}, {0, 0, 1});
  };
  EXPECT_NEAR(at(0, -11), 0.3, 1e-12);
  EXPECT_EQ(at(0, -9), 1);
  EXPECT_NEAR(at(20, -10.01), 0.65, 0.08);  // half of the light is seen
  double last = 0;
  for (double x = -20; x <= 0; x += 0.25) {
    const double light = at(20, x);
    EXPECT_GE(light, last - 1e-12);
    last = light;
  }
  // The disc of the light ends 10 degrees either way of 45.
  const auto border = [](double degrees) {
    return -10 * std::tan(degrees * std::numbers::pi / 180);
  };
  EXPECT_NEAR(at(20, border(56)), 0.3, 1e-12);
  EXPECT_EQ(at(20, border(34)), 1);
}

TEST(Shadows, ALightInTheSceneIsNotHiddenByWhatIsBehindIt) {
  Style style = lit();
  style.tone.shadow = 1;
  const Camera camera = from_above();
  RunContext context;
  // Under the lid, above the floor: nothing stands between.
  style.tone.lights = {{tone::Light::Kind::Ambient, Vec3(0), 0.3},
                       {tone::Light::Kind::At, {-12, 0, 8}, 1}};
  const Drawing drawing = illustrate(lid_over_floor(), camera, style, {}, context);
  EXPECT_LT(ink_at(drawing, camera, {-12, 0}), 0.05);
}

TEST(Shadows, OfABallOnItselfChangeLittle) {
  // Its triangles stand for a smooth surface, and that casts none on what is lit.
  Scene scene;
  scene.parts.push_back(
      {"ball", "", std::make_shared<MeshForm>(test::ellipsoid({10, 10, 10}, 96, 48))});
  const Camera camera = from_above();
  RunContext context;
  Style style = lit();
  const auto length = [&] {
    double sum = 0;
    const Drawing drawing = illustrate(scene, camera, style, {}, context);
    for (const Layer& layer : drawing.layers) {
      for (const Path& path : layer.paths) {
        for (std::size_t i = 1; i < path.points.size(); ++i) {
          sum += glm::distance(path.points[i - 1], path.points[i]);
        }
      }
    }
    return sum;
  };
  const double without = length();
  style.tone.shadow = 1;
  EXPECT_NEAR(length() / without, 1, 0.02);
}

}  // namespace
}  // namespace burin
