/// The shadow on an invisible ground under the parts.

#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/ground.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/ring_size.h"
#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace burin {
namespace {

constexpr double kScale = 1.5;

struct Seen {
  Drawing drawing;
  Vec3 to_light;
  Vec3 to_viewer;
  Camera camera;
};

/// `glass`: all parts, or the last one alone.
enum class Glass { None, Last, All };
Seen draw_on_ground(const Scene& scene, const char* view, Glass glass = Glass::None) {
  Style style = builtin_style("flat");
  style.shadow.ground = true;
  RunContext context;
  const NamedView v = named_view(view);
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                  {.direction = v.direction, .up = v.up, .scale = kScale, .paper = {300, 300}});
  IllustrateOptions options;
  options.part_styles.resize(scene.parts.size());
  for (PartStyle& look : options.part_styles) look.transparent = glass == Glass::All;
  if (glass == Glass::Last) options.part_styles.back().transparent = true;
  const Vec3 light = glm::normalize(style.tone.light);
  return {illustrate(scene, camera, style, options, context),
          camera.right() * light.x + camera.up() * light.y + camera.direction() * light.z,
          camera.direction(), camera};
}

Scene boxes(std::initializer_list<Box3> all) {
  Scene scene;
  for (const Box3& b : all) {
    scene.parts.push_back({"box", "a.stl", std::make_shared<MeshForm>(test::box(b.min, b.max))});
  }
  return scene;
}

const Area* shadow_of(const Drawing& drawing) {
  const auto it = std::ranges::find(drawing.areas, -1, &Area::part);
  return it == drawing.areas.end() ? nullptr : &*it;
}

TEST(GroundShadow, OfABoxIsItsFootprintSweptAlongTheLight) {
  const double w = 20, d = 30, h = 25;
  const Seen seen = draw_on_ground(boxes({{{-10, -15, 4}, {10, 15, 4 + h}}}), "iso");
  const Area* shadow = shadow_of(seen.drawing);
  ASSERT_NE(shadow, nullptr);
  EXPECT_EQ(shadow, &seen.drawing.areas.front()) << "it lies below all parts";
  EXPECT_EQ(shadow->fill, "#d1d1d1");
  const Vec3 l = seen.to_light;
  const double model = w * d + h / l.z * (std::abs(l.x) * d + std::abs(l.y) * w);
  const double paper = model * kScale * kScale * seen.to_viewer.z;
  EXPECT_NEAR(std::abs(test::signed_area(*shadow)) / paper, 1, 1e-3);
}

TEST(GroundShadow, AndItsPartsFillTheSheetInPerspectiveToo) {
  const Scene scene = boxes({{{0, 0, 0}, {30, 20, 40}}});
  Style style = builtin_style("flat");
  style.shadow.ground = true;
  for (const double angle : {0.0, 5.0, 40.0}) {
    const NamedView v = named_view("iso");
    ViewOptions view{.direction = v.direction, .up = v.up, .paper = {200, 200}};
    if (angle > 0) view.perspective = angle;
    RunContext context;
    const Camera camera = Camera::fit(extent_with_shadow(scene, style, {}, view), view);
    const Drawing drawing = illustrate(scene, camera, style, {}, context);
    ASSERT_TRUE(shadow_of(drawing)) << angle;
    Box2 box;
    for (const Area& area : drawing.areas) {
      for (const std::vector<Vec2>& ring : area.rings) {
        for (const Vec2& p : ring) box.add(p);
      }
    }
    EXPECT_NEAR(std::max(box.size().x, box.size().y), 180, 2) << angle;
    EXPECT_GT(std::min(box.min.x, box.min.y), 9.9) << angle;
    EXPECT_LT(std::max(box.max.x, box.max.y), 190.1) << angle;
  }
}

TEST(GroundShadow, LiesOnTheGroundOfTheLowestPart) {
  // A second box, lower and far away, lets the shadow of the first fall farther.
  const Seen alone = draw_on_ground(boxes({{{-5, -5, 40}, {5, 5, 50}}}), "iso");
  const Seen both =
      draw_on_ground(boxes({{{-5, -5, 40}, {5, 5, 50}}, {{-60, -60, 0}, {-55, -55, 5}}}), "iso");
  EXPECT_EQ(shadow_of(alone.drawing)->rings.size(), 1u);
  EXPECT_EQ(shadow_of(both.drawing)->rings.size(), 2u);
  // Glass casts none and stands on the ground too: the shadow of what it holds lies at its foot.
  const Scene held = boxes({{{-5, -5, 40}, {5, 5, 50}}, {{-20, -20, 0}, {20, 20, 60}}});
  const Seen seen = draw_on_ground(held, "iso", Glass::Last);
  const Area* at_foot = shadow_of(seen.drawing);
  ASSERT_NE(at_foot, nullptr);
  Box2 box;
  for (const Vec2& p : at_foot->rings.at(0)) box.add(p);
  const Vec3 foot = Vec3(0, 0, 45) - seen.to_light * (45 / seen.to_light.z);
  EXPECT_LT(glm::distance(box.center(), seen.camera.to_paper(foot)), 0.1);
}

TEST(GroundShadow, ThereIsNoneFromBelowFromTheSideAndOfGlass) {
  const Scene scene = boxes({{{-10, -15, 4}, {10, 15, 29}}});
  EXPECT_EQ(shadow_of(draw_on_ground(scene, "bottom").drawing), nullptr);
  EXPECT_EQ(shadow_of(draw_on_ground(scene, "front").drawing), nullptr);
  EXPECT_EQ(shadow_of(draw_on_ground(scene, "iso", Glass::All).drawing), nullptr);
}

Box2 box_of(const Drawing& drawing) {
  Box2 box;
  for (const Area& area : drawing.areas) {
    for (const std::vector<Vec2>& ring : area.rings) {
      for (const Vec2 p : ring) box.add(p);
    }
  }
  return box;
}

TEST(GroundShadow, HasRoomInPerspectiveAndNoMore) {
  const Scene scene = boxes({{{-10, -15, 0}, {10, 15, 40}}});
  Style style = builtin_style("flat");
  style.shadow.ground = true;
  RunContext context;
  for (const char* view : {"iso", "trimetric", "1,-1,0.4"}) {
    for (const double degrees : {20.0, 60.0}) {
      const NamedView v = named_view(view);
      const ViewOptions options{.direction = v.direction,
                                .up = v.up,
                                .perspective = degrees,
                                .margin = 10,
                                .paper = {200, 150}};
      const Camera camera = Camera::fit(extent_with_shadow(scene, style, {}, options), options);
      const Box2 box = box_of(illustrate(scene, camera, style, {}, context));
      SCOPED_TRACE(view);
      // It touches two sides of the inner sheet, or stands in the middle between them.
      EXPECT_GT(box.min.x, 9.9);
      EXPECT_GT(box.min.y, 9.9);
      EXPECT_LT(box.max.x, 190.1);
      EXPECT_LT(box.max.y, 140.1);
      EXPECT_TRUE(box.size().x > 175 || box.size().y > 125) << box.size().x << ' ' << box.size().y;
    }
  }
}

TEST(GroundShadow, HasNoRoomWhereGlassCastsNone) {
  const Scene scene = boxes({{{-9, -9, 0}, {9, 9, 2}}, {{-10, -10, 2}, {10, 10, 60}}});
  Style style = builtin_style("flat");
  std::vector<PartStyle> looks(2);
  looks[1].transparent = true;
  const NamedView v = named_view("iso");
  const ViewOptions options{.direction = v.direction, .up = v.up, .paper = {200, 200}};
  const auto scale = [&] {
    return Camera::fit(extent_with_shadow(scene, style, looks, options), options).scale();
  };
  const double without = scale();
  style.shadow.ground = true;
  EXPECT_NEAR(scale() / without, 1, 0.01) << "the foot's is hardly wider than the bulb";
  looks[0].transparent = true;
  EXPECT_EQ(scale(), without);
  looks[1].transparent = false;
  EXPECT_LT(scale(), 0.9 * without);
}

TEST(GroundShadow, APartThatCastsNoneHasNeitherShadowNorRoomForIt) {
  const Scene scene = boxes({{{-9, -9, 0}, {9, 9, 2}}, {{-10, -10, 2}, {10, 10, 60}}});
  Style style = builtin_style("flat");
  style.shadow.ground = true;
  std::vector<PartStyle> looks(2);
  looks[1].style = style;
  const NamedView v = named_view("iso");
  const ViewOptions options{.direction = v.direction, .up = v.up, .paper = {200, 200}};
  const auto size = [&](bool shadow) {
    looks[1].style->fill.shadow = shadow;
    const Camera camera = Camera::fit(extent_with_shadow(scene, style, looks, options), options);
    RunContext context;
    const Drawing drawing = illustrate(scene, camera, style, {.part_styles = looks}, context);
    const Area* seen = shadow_of(drawing);
    const double scale = camera.scale();
    return std::pair(scale, seen ? test::signed_area(*seen) / (scale * scale) : 0);
  };
  const auto with = size(true), without = size(false);
  EXPECT_LT(with.first, 0.9 * without.first);
  EXPECT_GT(with.second, 4 * without.second);
  EXPECT_GT(without.second, 0) << "that of the foot";
}

TEST(GroundShadow, IsCutAtTheEdgeOfTheSheetUnlessTheStyleKeepsIt) {
  const Scene scene = boxes({{{-10, -15, 0}, {10, 15, 40}}});
  Style style = builtin_style("flat");
  style.shadow.ground = true;
  RunContext context;
  const NamedView v = named_view("iso");
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                  {.direction = v.direction, .up = v.up, .margin = 1, .paper = {60, 60}});
  const Box2 box = box_of(illustrate(scene, camera, style, {}, context));
  EXPECT_NEAR(box.max.x, 60, 1e-9);
  style.sheet.clip = false;
  EXPECT_GT(box_of(illustrate(scene, camera, style, {}, context)).max.x, 65);
}

TEST(GroundShadow, ThatReachesBehindTheViewerStaysBelowTheHorizon) {
  const Scene scene = boxes({{{-10, -10, 0}, {10, 10, 120}}});
  Style style = builtin_style("flat");
  style.shadow.ground = true;
  style.sheet.clip = false;
  style.tone.light = {0.1, 0.9, -0.9};  // from above and beyond
  RunContext context;
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, {.direction = {1, 0, 0.3},
                                                                         .up = {0, 0, 1},
                                                                         .perspective = 80,
                                                                         .scale = 2,
                                                                         .center = Vec3(0, 0, 30),
                                                                         .paper = {200, 200}});
  const Drawing drawing = illustrate(scene, camera, style, {}, context);
  const Area* shadow = shadow_of(drawing);
  ASSERT_NE(shadow, nullptr);
  const double horizon = camera.to_paper(camera.eye() - Vec3(1e6, 0, 0)).y;
  for (const std::vector<Vec2>& ring : shadow->rings) {
    for (const Vec2 p : ring) EXPECT_LT(p.y, horizon);
  }
}

TEST(GroundShadow, IsNotSeenThroughPartsWhoseColourIsPale) {
  Style style = builtin_style("flat");
  style.shadow.ground = true;
  style.fill.color = "#000000";
  style.fill.opacity = 0.5;
  style.sheet.paper = "#8000ff";
  RunContext context;
  const Scene scene = boxes({{{-10, -15, 4}, {10, 15, 29}}});
  const NamedView v = named_view("iso");
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = v.direction, .up = v.up, .paper = {100, 100}});
  const Drawing drawing = illustrate(scene, camera, style, {}, context);
  ASSERT_EQ(drawing.areas.size(), 2u);
  EXPECT_EQ(drawing.areas[1].opacity, 1);
  EXPECT_EQ(drawing.areas[1].fill, "#400080");

  style.fill.color = "none";
  const Drawing bare = illustrate(scene, camera, style, {}, context);
  ASSERT_EQ(bare.areas.size(), 2u);
  EXPECT_EQ(bare.areas[1].fill, "#8000ff");
}

}  // namespace
}  // namespace burin
