/// Shadows of parts on parts against their formulas.

#include <burin/base/parallel.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/section/section.h>

#include "burin_test/ring_size.h"
#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace burin {
namespace {

constexpr double kHalfTurn = std::numbers::pi, kLightScale = 2;
/// From the model to the light, in views from the top in the model too.
const Vec3 kLight{-0.5, 0.65, 0.6};

/// On a sheet that shows the origin in its middle, from the top.
struct Lit {
  Scene scene;
  ViewOptions view{.direction = {0, 0, 1},
                   .up = {0, 1, 0},
                   .scale = kLightScale,
                   .center = Vec3(0),
                   .paper = {600, 600}};
  Style style = builtin_style("flat");
  IllustrateOptions options{};

  Lit() {
    style.shadow.cast = true;
    style.tone.light = kLight;
  }
  void add(std::shared_ptr<const Form> form) {
    const std::string name = "part" + std::to_string(scene.parts.size());
    scene.parts.push_back({name, name, std::move(form)});
  }
  void add(TriMesh mesh, Vec3 by = Vec3(0)) {
    for (Vec3& p : mesh.positions) p += by;
    add(std::make_shared<MeshForm>(std::move(mesh)));
  }
  Camera camera() const {
    return Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, view);
  }
  Drawing draw() const {
    RunContext context;
    return illustrate(scene, camera(), style, options, context);
  }
};

void add_cube_on_plate(Lit& lit) {
  lit.add(test::box({-40, -40, -5}, {40, 40, 0}));
  lit.add(test::box({-10, -10, 0}, {10, 10, 20}));
}

const Area* toned_area(const Drawing& drawing, std::int32_t part, std::int32_t tone) {
  const auto it = std::ranges::find_if(
      drawing.areas, [&](const Area& a) { return a.part == part && a.tone == tone; });
  return it == drawing.areas.end() ? nullptr : &*it;
}

/// mm^2 of the model's size, of a view from the top.
double size_of_area(const Area& area) {
  return test::signed_area(area) / (kLightScale * kLightScale);
}

double nearest(const Area& area, Vec2 to) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec2>& ring : area.rings) {
    for (const Vec2 p : ring) least = std::min(least, glm::distance(p, to));
  }
  return least;
}

/// Where the light through a place meets the plane z = 0.
Vec3 thrown(Vec3 from) { return from - kLight * (from.z / kLight.z); }

TEST(CastShadow, OfACubeOnAPlateIsAPolygonOfSixCorners) {
  Lit lit;
  add_cube_on_plate(lit);
  const Drawing drawing = lit.draw();
  const Area* shadow = toned_area(drawing, 0, 0);
  ASSERT_NE(shadow, nullptr);
  ASSERT_EQ(shadow->rings.size(), 1u);
  EXPECT_EQ(shadow->rings[0].size(), 6u);
  const Camera camera = lit.camera();
  for (const Vec3& corner : {Vec3(10, 10, 0), Vec3(10, -10, 0), Vec3(-10, -10, 0),
                             thrown({10, 10, 20}), thrown({10, -10, 20}), thrown({-10, -10, 20})}) {
    EXPECT_LT(nearest(*shadow, camera.to_paper(corner)), 0.02);
  }
  EXPECT_EQ(toned_area(drawing, 1, 0), nullptr) << "the top of the cube is lit";
  EXPECT_NE(shadow->fill, toned_area(drawing, 0, 1)->fill);
}

TEST(CastShadow, IsAsExactInPerspectiveAndFromTheSide) {
  Lit lit;
  add_cube_on_plate(lit);
  lit.view.direction = {1, -1, 1};
  lit.view.up = {0, 0, 1};
  lit.view.perspective = 30;
  // As before in the model.
  const Camera camera = lit.camera();
  lit.style.tone.light = {glm::dot(kLight, camera.right()), glm::dot(kLight, camera.up()),
                          glm::dot(kLight, camera.direction())};
  const Drawing drawing = lit.draw();
  const Area* shadow = toned_area(drawing, 0, 0);
  ASSERT_NE(shadow, nullptr);
  for (const Vec3& corner : {thrown({10, 10, 20}), thrown({10, -10, 20}), thrown({-10, -10, 20})}) {
    EXPECT_LT(nearest(*shadow, camera.to_paper(corner)), 0.02);
  }
  EXPECT_NE(toned_area(drawing, 1, 0), nullptr) << "sides that face away";
}

TEST(CastShadow, OfAPinThroughAPlateIsItsLengthTimesItsWidth) {
  Lit lit;
  constexpr double kRadius = 6, kHeight = 30;
  lit.add(test::box({-60, -60, -5}, {60, 60, 0}));
  lit.add(test::cylinder(kRadius, kHeight + 20, 180), {0, 0, -20});
  const Drawing drawing = lit.draw();
  const Area* shadow = toned_area(drawing, 0, 0);
  ASSERT_NE(shadow, nullptr);
  ASSERT_EQ(shadow->rings.size(), 1u);
  // Of the hull of the foot and the shadow of the top the pin hides the foot.
  const double exact = 2 * kRadius * glm::length(thrown({0, 0, kHeight}));
  EXPECT_NEAR(size_of_area(*shadow), exact, 5e-3 * exact);
}

TEST(CastShadow, OfABallOnAPlaneIsAnEllipse) {
  Lit lit;
  constexpr double kRadius = 12;
  lit.add(test::box({-100, -100, -5}, {100, 100, 0}));
  lit.add(test::ellipsoid(Vec3(kRadius), 160, 80), {-25, 30, 50});
  const Drawing drawing = lit.draw();
  const Area* shadow = toned_area(drawing, 0, 0);
  ASSERT_NE(shadow, nullptr);
  ASSERT_EQ(shadow->rings.size(), 1u);
  const double exact = kHalfTurn * kRadius * kRadius / glm::normalize(kLight).z;
  EXPECT_NEAR(size_of_area(*shadow), exact, 5e-3 * exact);
  // Light that only grazes the ball does not count.
  const Vec3 light = glm::normalize(kLight);
  constexpr int kCells = 1000;
  int dark = 0;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const Vec2 at = 2.0 * Vec2(i + 0.5, j + 0.5) / static_cast<double>(kCells) - 1.0;
      const double height = 1 - glm::dot(at, at);
      if (height > 0 && glm::dot(Vec3(at, std::sqrt(height)), light) < 0.2) ++dark;
    }
  }
  const double shade = dark * 4 * kRadius * kRadius / (kCells * kCells);
  ASSERT_NE(toned_area(drawing, 1, 0), nullptr);
  EXPECT_NEAR(size_of_area(*toned_area(drawing, 1, 0)), shade, 1e-2 * shade);
}

TEST(CastShadow, HasTheDarkestOfSeveralTones) {
  Lit lit;
  add_cube_on_plate(lit);
  lit.style.fill.steps = 4;
  const Drawing drawing = lit.draw();
  ASSERT_NE(toned_area(drawing, 0, 0), nullptr);
  EXPECT_EQ(toned_area(drawing, 0, 0)->rings[0].size(), 6u);
  EXPECT_EQ(toned_area(drawing, 0, 3), nullptr) << "the plate is lit by 0.59";
  EXPECT_NE(toned_area(drawing, 0, 2), nullptr);
}

TEST(CastShadow, OnPartsWithoutAColourIsThatOfShadows) {
  Lit lit;
  add_cube_on_plate(lit);
  lit.style.fill.color = "none";
  lit.style.shadow.color = "#abcdef";
  const Drawing drawing = lit.draw();
  ASSERT_NE(toned_area(drawing, 0, 0), nullptr);
  EXPECT_EQ(toned_area(drawing, 0, 0)->fill, "#abcdef");
  EXPECT_EQ(toned_area(drawing, 0, 1)->fill, "");
}

TEST(CastShadow, GlassCastsNone) {
  Lit lit;
  add_cube_on_plate(lit);
  lit.options.part_styles.resize(2);
  lit.options.part_styles[1].transparent = true;
  EXPECT_EQ(toned_area(lit.draw(), 0, 0), nullptr);
}

TEST(CastShadow, FallsOnAPartThatCastsNoneAndThroughIt) {
  Lit lit;
  add_cube_on_plate(lit);
  // A lid that the light passes through, over half of the plate.
  lit.add(test::box({-40, -40, 24}, {40, 0, 25}));
  lit.add(test::box({-12, -12, 30}, {-2, -2, 34}));
  lit.options.part_styles.resize(4);
  lit.options.verify = true;
  Style& lid = lit.options.part_styles[2].style.emplace(lit.style);
  lid.fill.shadow = false;
  lit.view.direction = {0, 1, 1};
  lit.view.up = {0, 0, 1};
  const Drawing drawing = lit.draw();
  EXPECT_NE(toned_area(drawing, 0, 0), nullptr);
  EXPECT_NE(toned_area(drawing, 2, 0), nullptr) << "it has the shadow of the box over it";
  EXPECT_EQ(drawing.stats.verify->wrong_patches, 0);
  lid.fill.shadow = true;
  EXPECT_GT(test::signed_area(*toned_area(lit.draw(), 0, 0)),
            test::signed_area(*toned_area(drawing, 0, 0)) + 100);
  for (PartStyle& one : lit.options.part_styles) {
    one.style = lit.style;
    one.style->fill.shadow = false;
  }
  const Drawing none = lit.draw();
  EXPECT_EQ(toned_area(none, 0, 0)->fill, toned_area(drawing, 0, 0)->fill) << "walls in shade";
  EXPECT_LT(test::signed_area(*toned_area(none, 0, 0)),
            test::signed_area(*toned_area(drawing, 0, 0)) - 100);
  EXPECT_EQ(none.stats.verify->wrong_patches, 0);
}

TEST(CastShadow, FacesOfCutsAreLit) {
  Lit lit;
  lit.add(cut_form(std::make_shared<MeshForm>(test::box({-40, -40, -5}, {40, 40, 5})),
                   CutPlane{{0, 0, 1}, 0}, 0, "plate"));
  lit.add(test::box({-10, -10, 1}, {10, 10, 20}));
  const Drawing drawing = lit.draw();
  EXPECT_NE(toned_area(drawing, 0, 1), nullptr);
  EXPECT_EQ(toned_area(drawing, 0, 0), nullptr) << "hatching is read on it";
}

TEST(CastShadow, OfASheetIsThatOfItsBorder) {
  Lit lit;
  lit.add(test::box({-60, -60, -5}, {60, 60, 0}));
  TriMesh sheet;
  sheet.positions = {{-10, -10, 30}, {10, -10, 30}, {10, 10, 30}, {-10, 10, 30}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  lit.add(std::move(sheet));
  const Drawing drawing = lit.draw();
  const Area* shadow = toned_area(drawing, 0, 0);
  ASSERT_NE(shadow, nullptr);
  EXPECT_EQ(shadow->rings[0].size(), 4u);
  for (const Vec3& corner : {Vec3(-10, -10, 30), Vec3(10, 10, 30)}) {
    EXPECT_LT(nearest(*shadow, lit.camera().to_paper(thrown(corner))), 0.02);
  }
}

TEST(CastShadow, IsTheSameForAnyNumberOfThreads) {
  Lit lit;
  lit.add(test::box({-60, -60, -5}, {60, 60, 0}));
  lit.add(test::torus(20, 6, 80, 40), {0, 0, 20});
  lit.add(test::ellipsoid(Vec3(8), 60, 30), {0, 0, 40});
  const Drawing many = lit.draw();
  const ThreadLimit one(1);
  const Drawing alone = lit.draw();
  ASSERT_EQ(many.areas.size(), alone.areas.size());
  for (std::size_t i = 0; i < many.areas.size(); ++i) {
    EXPECT_EQ(many.areas[i].rings, alone.areas[i].rings);
  }
}

TEST(CastShadow, LinesStayAsTheyAre) {
  Lit lit;
  add_cube_on_plate(lit);
  const Drawing with = lit.draw();
  lit.style.shadow.cast = false;
  const Drawing without = lit.draw();
  EXPECT_EQ(toned_area(without, 0, 0), nullptr);
  ASSERT_EQ(with.layers.size(), without.layers.size());
  for (std::size_t i = 0; i < with.layers.size(); ++i) {
    ASSERT_EQ(with.layers[i].paths.size(), without.layers[i].paths.size());
    for (std::size_t k = 0; k < with.layers[i].paths.size(); ++k) {
      EXPECT_EQ(with.layers[i].paths[k].points, without.layers[i].paths[k].points);
    }
  }
}

}  // namespace
}  // namespace burin
