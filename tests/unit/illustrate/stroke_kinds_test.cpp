// Several kinds of strokes in one style.
#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

namespace burin {
namespace {

Scene two_balls() {
  Scene scene;
  for (const char* name : {"left", "right"}) {
    TriMesh ball = test::ellipsoid({10, 10, 10}, 96, 48);
    for (Vec3& p : ball.positions) p.x += name == std::string("left") ? -15 : 15;
    scene.parts.push_back({name, name, std::make_shared<MeshForm>(std::move(ball))});
  }
  return scene;
}

Drawing draw_kinds(const Scene& scene, const Style& style,
                   std::vector<PartStyle> part_styles = {}) {
  RunContext context;
  const NamedView v = named_view("front");
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = v.direction, .up = v.up, .paper = {120, 70}});
  return illustrate(scene, camera, style, {.part_styles = std::move(part_styles)}, context);
}

// Strokes by layer and part.
std::map<std::string, std::map<int, int>> counted(const Drawing& drawing) {
  std::map<std::string, std::map<int, int>> count;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind == LineClass::Stroke) ++count[layer.name][path.source.part];
    }
  }
  return count;
}

Style crossed() {
  Style style = builtin_style("engraving");
  style.hatch.cross_from = 2;
  style.hatch.field.name = "planes";
  style.hatch.field.direction = {1, 0, 0};
  set_style_key(style, "strokes.2.direction", "0,0,1");
  return style;
}

TEST(StrokeKinds, TwoOnOnePartAreDrawnTogetherEachByItsOwnField) {
  const Drawing drawing = draw_kinds(two_balls(), crossed());
  const auto count = counted(drawing);
  ASSERT_EQ(count.size(), 2u);
  for (const int part : {0, 1}) {
    EXPECT_GT(count.at("stroke-1").at(part), 10);
    EXPECT_GT(count.at("stroke-1-kind-2").at(part), 10);
  }
  // Each line lies in a plane across the direction of its kind.
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind != LineClass::Stroke) continue;
      EXPECT_EQ(path.stroke_kind, layer.name == "stroke-1" ? 1 : 2);
      const int axis = path.stroke_kind == 1 ? 0 : 2;
      for (const Vec3& p : path.points3) {
        EXPECT_NEAR(p[axis], path.points3.front()[axis], 0.02 / drawing.view.scale);
      }
    }
  }
}

TEST(StrokeKinds, StandOnThePartsThatTheySelect) {
  Style style = crossed();
  set_style_key(style, "strokes.2.select", "right");
  const auto count = counted(draw_kinds(two_balls(), style));
  EXPECT_EQ(count.at("stroke-1").size(), 2u);
  EXPECT_EQ(count.at("stroke-1-kind-2").size(), 1u);
  EXPECT_TRUE(count.at("stroke-1-kind-2").contains(1));
  // Where there is one kind alone it has all the ink, as it has without the other.
  Style alone = crossed();
  alone.strokes.clear();
  const auto without = counted(draw_kinds(two_balls(), alone));
  EXPECT_EQ(count.at("stroke-1").at(0), without.at("stroke-1").at(0));
}

TEST(StrokeKinds, ASelectorOfTheFirstKindHoldsToo) {
  Style style = builtin_style("engraving");
  style.hatch.select = "left";
  const auto count = counted(draw_kinds(two_balls(), style));
  EXPECT_EQ(count.at("stroke-1").size(), 1u);
  style.hatch.select = "lft";
  try {
    draw_kinds(two_balls(), style);
    FAIL() << "it was drawn";
  } catch (const UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("left"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("select"), std::string::npos) << e.what();
  }
}

TEST(StrokeKinds, OneThatIsOffChangesNothing) {
  const Style style = builtin_style("engraving");
  Style other = style;
  set_style_key(other, "strokes.2.enabled", "false");
  const Drawing a = draw_kinds(two_balls(), style), b = draw_kinds(two_balls(), other);
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    ASSERT_EQ(a.layers[i].paths.size(), b.layers[i].paths.size());
    for (std::size_t k = 0; k < a.layers[i].paths.size(); ++k) {
      EXPECT_EQ(a.layers[i].paths[k].points3, b.layers[i].paths[k].points3);
      EXPECT_EQ(a.layers[i].paths[k].width, b.layers[i].paths[k].width);
    }
  }
}

TEST(StrokeKinds, HaveToneOfTheirOwnThatTheOthersDoNotGiveWayTo) {
  Style style = crossed();
  style.strokes.front().tone.law = "silhouette";
  const auto with = counted(draw_kinds(two_balls(), style));
  style.strokes.clear();
  const auto without = counted(draw_kinds(two_balls(), style));
  EXPECT_EQ(with.at("stroke-1"), without.at("stroke-1"));
  EXPECT_GT(with.at("stroke-1-kind-2").size(), 1u);
}

// Strokes that are drawn in the shade alone stay there when they have but half of its ink.
TEST(StrokeKinds, BeginWhereTheInkOfAllTogetherIsEnough) {
  Style style = builtin_style("technical");
  const auto alone = counted(draw_kinds(two_balls(), style));
  set_style_key(style, "strokes.2.kind", "dots");
  const auto count = counted(draw_kinds(two_balls(), style));
  EXPECT_NEAR(count.at("stroke-1").at(0), alone.at("stroke-1").at(0),
              0.3 * alone.at("stroke-1").at(0));
}

TEST(StrokeKinds, OfAPartOfGlassAreAllDrawn) {
  const auto count =
      counted(draw_kinds(two_balls(), crossed(), {{.transparent = true}, {.transparent = false}}));
  EXPECT_GT(count.at("stroke-1").at(0), 10);
  EXPECT_GT(count.at("stroke-1-kind-2").at(0), 10);
}

}  // namespace
}  // namespace burin
