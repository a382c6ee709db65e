/// What is seen of each part: borders are the drawn lines.

#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/ring_size.h"
#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace burin {
namespace {

constexpr Vec3 kBall{6, -30, 3};
constexpr double kRadius = 10;

/// A ball before a plate of 60 x 40, from the front.
Drawing ball_before_plate(const char* style, bool glass, bool plate_too = false) {
  Scene scene;
  const auto add = [&](const char* name, TriMesh mesh, Vec3 by) {
    for (Vec3& p : mesh.positions) p += by;
    scene.parts.push_back({name, name, std::make_shared<MeshForm>(std::move(mesh))});
  };
  add("plate", test::box({-30, -2, -20}, {30, 2, 20}), {});
  add("ball", test::ellipsoid(Vec3(kRadius), 192, 96), kBall);
  RunContext context;
  const NamedView v = named_view("front");
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                  {.direction = v.direction, .up = v.up, .scale = 1.5, .paper = {150, 100}});
  IllustrateOptions options{.annotations = Annotations{}};
  options.part_styles.resize(2);
  options.part_styles[0].transparent = plate_too;
  options.part_styles[1].transparent = glass;
  return illustrate(scene, camera, builtin_style(style), options, context);
}

const Area* area_of(const Drawing& drawing, std::int32_t part) {
  const auto it = std::ranges::find(drawing.areas, part, &Area::part);
  return it == drawing.areas.end() ? nullptr : &*it;
}

// The plate was cut out where the ball stands before it.
TEST(Areas, OfGlassGoOnBehindOtherGlass) {
  const double scale2 = 1.5 * 1.5, ball = std::acos(-1.0) * kRadius * kRadius;
  const Drawing drawing = ball_before_plate("outline", true, true);
  double plate = 0;
  std::size_t last = 0, first_ball = drawing.areas.size();
  for (std::size_t i = 0; i < drawing.areas.size(); ++i) {
    const Area& area = drawing.areas[i];
    if (area.part == 1) {
      first_ball = std::min(first_ball, i);
      EXPECT_NEAR(test::signed_area(area), scale2 * ball, 0.004 * scale2 * ball);
      continue;
    }
    plate += test::signed_area(area);
    if (test::signed_area(area) < 1.1 * scale2 * ball) last = i;
  }
  EXPECT_NEAR(plate, scale2 * 60 * 40, 1e-6 * scale2 * 2400);
  EXPECT_GT(last, first_ball) << "what is before comes first, and is painted last";
}

TEST(Areas, AreThoseOfTheSilhouettes) {
  const double scale2 = 1.5 * 1.5, ball = std::acos(-1.0) * kRadius * kRadius;
  for (const char* style : {"outline", "engraving", "wireframe"}) {
    const Drawing drawing = ball_before_plate(style, false);
    ASSERT_EQ(drawing.areas.size(), 2u) << style;
    ASSERT_NE(area_of(drawing, 1), nullptr);
    EXPECT_NEAR(test::signed_area(*area_of(drawing, 1)), scale2 * ball, 0.004 * scale2 * ball)
        << style;
    EXPECT_NEAR(test::signed_area(*area_of(drawing, 0)), scale2 * (60 * 40 - ball),
                0.002 * scale2 * 2400)
        << style;
    EXPECT_EQ(area_of(drawing, 0)->rings.size(), 2u) << "the rim and the hole that the ball makes";
  }
}

/// Panes one over the other, and a solid block within the lowest.
Drawing stack(const std::vector<TriMesh>& panes, const TriMesh& block) {
  Scene scene;
  IllustrateOptions options{.verify = true};
  for (const TriMesh& pane : panes) {
    scene.parts.push_back({"pane", "", std::make_shared<MeshForm>(pane)});
    scene.parts.back().color = "#4080c0";
    options.part_styles.push_back({.transparent = true});
  }
  scene.parts.push_back({"block", "", std::make_shared<MeshForm>(block)});
  options.part_styles.emplace_back();
  RunContext context;
  const NamedView v = named_view("top");
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                  {.direction = v.direction, .up = v.up, .scale = 2, .paper = {150, 100}});
  return illustrate(scene, camera, builtin_style("flat"), options, context);
}

double size_of_part(const Drawing& drawing, std::int32_t part) {
  double sum = 0;
  for (const Area& area : drawing.areas) {
    if (area.part == part) sum += test::signed_area(area);
  }
  return sum;
}

// Where two touch, the ray meets both at one place.
TEST(Areas, OfPanesThatTouchAreAllThere) {
  const TriMesh low = test::box({0, 0, 0}, {20, 20, 10}),
                high = test::box({0, 0, 10}, {20, 20, 15});
  const TriMesh block = test::box({7, 7, 2}, {12, 12, 7});
  for (const auto& panes : {std::vector{low, high}, std::vector{high, low}}) {
    const Drawing drawing = stack(panes, block);
    EXPECT_EQ(drawing.stats.verify->wrong_patches, 0);
    EXPECT_NEAR(size_of_part(drawing, 0), 4 * 400, 1e-6);
    EXPECT_NEAR(size_of_part(drawing, 1), 4 * 400, 1e-6) << "over the block, too";
    EXPECT_NEAR(size_of_part(drawing, 2), 4 * 25, 1e-6);
  }
  // Faces that lie on each other.
  const Drawing twice = stack({low, test::box({0, 0, 0}, {30, 20, 10})}, block);
  EXPECT_EQ(twice.stats.verify->wrong_patches, 0);
  EXPECT_NEAR(size_of_part(twice, 0), 4 * 400, 1e-6);
  EXPECT_NEAR(size_of_part(twice, 1), 4 * 600, 1e-6);
  std::size_t rings = 0;
  for (const Area& area : twice.areas) rings += area.rings.size();
  EXPECT_LE(rings, 5u) << "one order of panes all over what they share";
}

// The referee of one pane alone has nothing near the middle of the drawing.
TEST(Areas, OfPanesFarFromEachOtherAreProvenByRays) {
  for (const double z : {-200.0, 200.0}) {
    const Drawing drawing =
        stack({test::box({0, 0, 0}, {10, 10, 2}), test::box({5, 0, z}, {15, 10, z + 2})},
              test::box({30, 0, 0}, {32, 2, 2}));
    EXPECT_EQ(drawing.stats.verify->wrong_patches, 0) << z;
    EXPECT_EQ(drawing.stats.verify->contradicted, 0) << z;
    EXPECT_NEAR(size_of_part(drawing, 1), 400, 1e-6) << z;
  }
}

TEST(Areas, OfGlassLieOverWhatIsSeenThroughIt) {
  const double scale2 = 1.5 * 1.5, ball = std::acos(-1.0) * kRadius * kRadius;
  const Drawing drawing = ball_before_plate("outline", true);
  ASSERT_EQ(drawing.areas.size(), 2u);
  EXPECT_EQ(drawing.areas[0].part, 1);
  EXPECT_NEAR(test::signed_area(drawing.areas[0]), scale2 * ball, 0.004 * scale2 * ball);
  EXPECT_NEAR(test::signed_area(drawing.areas[1]), scale2 * 2400, 0.002 * scale2 * 2400);
}

}  // namespace
}  // namespace burin
