/// Areas of shapes whose picture is known to the last corner.

#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/rings.h"
#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace burin {
namespace {

using test::kPi;

struct Shown {
  Scene scene;
  ViewOptions view{.direction = {1, -1, 1}, .up = {0, 0, 1}, .scale = 2, .paper = {200, 150}};
  Style style = builtin_style("outline");
  IllustrateOptions options{};

  void add(TriMesh mesh) {
    const std::string name = "part" + std::to_string(scene.parts.size());
    scene.parts.push_back({name, name, std::make_shared<MeshForm>(std::move(mesh))});
  }
  void fill(int steps) {
    style.fill.color = "part";
    style.fill.steps = steps;
  }
  Camera camera() const {
    return Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, view);
  }
  Drawing draw() const {
    RunContext context;
    return illustrate(scene, camera(), style, options, context);
  }
};

/// The corners are those of `wanted`, in the same turn, wherever they begin. mm.
void expect_corners(const std::vector<Vec2>& ring, const std::vector<Vec2>& wanted, double near) {
  ASSERT_EQ(ring.size(), wanted.size());
  const auto first =
      std::ranges::min_element(ring, {}, [&](Vec2 p) { return glm::distance(p, wanted[0]); });
  const auto shift = static_cast<std::size_t>(first - ring.begin());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_LT(glm::distance(ring[(shift + i) % ring.size()], wanted[i]), near) << i;
  }
}

TEST(RegionTruths, ACubeHasThreeFacesWithItsCorners) {
  for (const bool perspective : {false, true}) {
    Shown s;
    s.add(test::box(Vec3(0), Vec3(20)));
    if (perspective) s.view.perspective = 40, s.view.scale.reset();
    s.options.face_areas = true;
    const Camera camera = s.camera();
    const Drawing d = s.draw();
    ASSERT_EQ(d.areas.size(), 3u);
    const auto at = [&](double x, double y, double z) {
      return camera.to_paper({20 * x, 20 * y, 20 * z});
    };
    const std::array<std::vector<Vec2>, 3> faces = {{
        {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)},  // above
        {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)},  // y = 0
        {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)},  // x = 20
    }};
    for (const std::vector<Vec2>& face : faces) {
      Vec2 middle(0);
      for (const Vec2& p : face) middle += p / 4.0;
      const auto area = std::ranges::find_if(
          d.areas, [&](const Area& a) { return test::winding(a.rings, middle) == 1; });
      ASSERT_NE(area, d.areas.end());
      ASSERT_EQ(area->rings.size(), 1u);
      expect_corners(area->rings[0], face, 1e-6);
    }
  }
}

TEST(RegionTruths, ToneOfABallIsACapWhoseRimIsACircle) {
  Shown s;
  constexpr double kRadius = 25;
  s.add(test::ellipsoid(Vec3(kRadius), 160, 80));
  s.fill(4);
  s.style.fill.opacity = 0.5;  // each step for itself
  s.style.tone.light = {0, 0, 1};
  const Drawing d = s.draw();
  ASSERT_EQ(d.areas.size(), 4u);
  const Vec2 middle = s.camera().to_paper(Vec3(0));
  for (const Area& area : d.areas) {
    // Where the light is over i / 4 the rim is seen at sqrt(1 - (i / 4)^2) of the radius.
    const auto rim = [&](int step) { return 2 * kRadius * std::sqrt(1 - step * step / 16.0); };
    const double outer = rim(area.tone), inner = rim(area.tone + 1);
    double size = 0;
    for (const std::vector<Vec2>& ring : area.rings) {
      const double area_of_ring = test::signed_area(ring);
      size += area_of_ring;
      for (const Vec2 p : ring) {
        EXPECT_NEAR(glm::distance(p, middle), area_of_ring > 0 ? outer : inner, 0.02) << area.tone;
      }
    }
    EXPECT_NEAR(size / (kPi * (outer * outer - inner * inner)), 1, 1e-3) << area.tone;
  }
}

TEST(RegionTruths, ATorusFromAboveIsARingBetweenTwoCircles) {
  Shown s;
  s.add(test::torus(20, 6, 200, 100));
  s.view.direction = {0, 0, 1}, s.view.up = {0, 1, 0};
  s.fill(0);
  const Drawing d = s.draw();
  ASSERT_EQ(d.areas.size(), 1u);
  ASSERT_EQ(d.areas[0].rings.size(), 2u);
  const Vec2 middle = s.camera().to_paper(Vec3(0));
  EXPECT_EQ(test::winding(d.areas[0].rings, middle), 0) << "the hole";
  for (const std::vector<Vec2>& ring : d.areas[0].rings) {
    const double radius = test::signed_area(ring) > 0 ? 52 : 28;
    for (const Vec2 p : ring) EXPECT_NEAR(glm::distance(p, middle), radius, 0.02);
  }
}

TEST(RegionTruths, FlushBoxesShareTheirBorder) {
  Shown s;
  s.add(test::box({0, 0, 0}, {20, 10, 30}));
  s.add(test::box({20, 0, 0}, {50, 10, 30}));
  s.view.direction = {0, -1, 0};
  s.fill(0);
  const Camera camera = s.camera();
  const Drawing d = s.draw();
  ASSERT_EQ(d.areas.size(), 2u);
  const auto at = [&](double x, double z) { return camera.to_paper({x, 0, z}); };
  expect_corners(d.areas[0].rings.at(0), {at(0, 0), at(20, 0), at(20, 30), at(0, 30)}, 1e-6);
  expect_corners(d.areas[1].rings.at(0), {at(20, 0), at(50, 0), at(50, 30), at(20, 30)}, 1e-6);
}

TEST(RegionTruths, TheShadowOfACubeOnTheGroundIsAHexagon) {
  Shown s;
  s.add(test::box(Vec3(0), Vec3(20)));
  s.fill(0);
  s.style.shadow.ground = true;
  const Camera camera = s.camera();
  const Drawing d = s.draw();
  const auto shadow = std::ranges::find(d.areas, -1, &Area::part);
  ASSERT_NE(shadow, d.areas.end());
  ASSERT_EQ(shadow->rings.size(), 1u);
  const Vec3 l = glm::normalize(s.style.tone.light);
  const Vec3 light = camera.right() * l.x + camera.up() * l.y + camera.direction() * l.z;
  ASSERT_GT(light.z, 0);
  // Its foot and its top, which falls beside it: of the eight corners two lie within the hexagon.
  std::vector<Vec2> places;
  for (const double z : {0.0, 20.0}) {
    for (const double y : {0.0, 20.0}) {
      for (const double x : {0.0, 20.0}) {
        places.push_back(camera.to_paper(Vec3(x, y, z) - light * (z / light.z)));
      }
    }
  }
  std::vector<Vec2> hull;  // gift wrapping, counterclockwise
  Vec2 from = *std::ranges::min_element(places, {}, [](Vec2 p) { return p.x; });
  do {
    hull.push_back(from);
    Vec2 to = from;
    for (const Vec2 p : places) {
      const Vec2 a = to - from, b = p - from;
      if (to == from || a.x * b.y - a.y * b.x < 0) to = p;
    }
    from = to;
  } while (glm::distance(from, hull[0]) > 1e-9 && hull.size() < 9);
  ASSERT_EQ(hull.size(), 6u);
  std::vector<Vec2> ring = shadow->rings[0];
  if (test::signed_area(ring) < 0) std::ranges::reverse(ring);
  expect_corners(ring, hull, 1e-3);
}

TEST(RegionTruths, OfAPartSeenAlongItsSlotTheSlotIsPaper) {
  Shown s;
  s.add(test::slotted());
  s.view.direction = {0, -1, 0};
  s.fill(3);
  const Camera camera = s.camera();
  const Drawing d = s.draw();
  ASSERT_EQ(d.areas.size(), 1u);
  ASSERT_EQ(d.areas[0].rings.size(), 1u);
  std::vector<Vec2> wanted;
  for (const Vec2 p : test::slotted_profile()) wanted.push_back(camera.to_paper({p.x, 0, p.y}));
  expect_corners(d.areas[0].rings[0], wanted, 1e-6);
}

}  // namespace
}  // namespace burin
