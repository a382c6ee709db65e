// Annotations that parts carry, in drawings.
#include <burin/explode/explode.h>
#include <burin/illustrate/illustrate.h>

#include <burin_test/exploded.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

namespace burin {
namespace {

/// A line of 10 mm, read from the front, at a place.
PmiItem item_at(Vec3 place) {
  PmiItem item;
  item.kind = PmiKind::Note;
  item.views = {"A"};
  item.plane = PmiPlane{place, {0, -1, 0}, {1, 0, 0}};
  item.lines = {{{place, place + Vec3(10, 0, 0)}}};
  return item;
}

/// A cube of 20 mm that has these annotations.
Scene cube_with(std::vector<PmiItem> items) {
  Scene scene;
  test::add_part(scene, "cube", test::box({0, 0, 0}, {20, 20, 20}));
  scene.parts[0].pmi.pmi = std::make_shared<Pmi>(Pmi{std::move(items)});
  return scene;
}

Drawing draw(const Scene& scene, Vec3 direction, const Style& style = builtin_style("outline")) {
  RunContext context;
  ViewOptions view;
  view.direction = direction;
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return drawn_bounds(scene, {}, axes); }, view);
  return illustrate(scene, camera, style, {}, context);
}

std::size_t annotated(const Drawing& drawing) {
  const auto layer = std::ranges::find(drawing.layers, "pmi", &Layer::name);
  return layer == drawing.layers.end() ? 0 : layer->paths.size();
}

std::int64_t told(const Drawing& drawing, const std::string& code) {
  std::int64_t count = 0;
  for (const Diagnostic& d : drawing.diagnostics.entries()) count += d.code == code ? d.count : 0;
  return count;
}

constexpr Vec3 kFront{0, -1, 0}, kBack{0, 1, 0}, kSide{1, 0, 0};

TEST(Annotations, AreDrawnOnTheSideThatTheyFace) {
  const Scene scene = cube_with({item_at({0, -5, 5})});
  EXPECT_EQ(annotated(draw(scene, kFront)), 1u);
  EXPECT_EQ(annotated(draw(scene, {1, -1, 1})), 1u);
  for (const Vec3 direction : {kBack, kSide}) {
    const Drawing drawing = draw(scene, direction);
    EXPECT_EQ(annotated(drawing), 0u);
    EXPECT_EQ(told(drawing, "pmi.turned_away"), 1);
  }
}

TEST(Annotations, AreReadTheOtherWayInMirroredParts) {
  Scene scene = cube_with({item_at({0, 25, 5})});
  scene.parts[0].pmi.placement.linear[1] = {0, -1, 0};  // before the cube, the letters from left
  EXPECT_EQ(annotated(draw(scene, kFront)), 1u);
  scene.parts[0].pmi.placement = {};
  scene.parts[0].pmi.placement.linear[0] = {-1, 0, 0};  // letters that run to the left
  EXPECT_EQ(annotated(draw(scene, kFront)), 0u);
}

TEST(Annotations, AreWholeOrNotThere) {
  // A tenth of the line is behind the cube, then nine.
  const Drawing part = draw(cube_with({item_at({19, 30, 5})}), kFront);
  ASSERT_EQ(annotated(part), 1u);
  EXPECT_EQ(part.layers.back().paths[0].points3[0], Vec3(19, 30, 5));
  const Drawing most = draw(cube_with({item_at({11, 30, 5})}), kFront);
  EXPECT_EQ(annotated(most), 0u);
  EXPECT_EQ(told(most, "pmi.covered"), 1);
  // On the face itself nothing covers it.
  EXPECT_EQ(annotated(draw(cube_with({item_at({5, 0, 5})}), kFront)), 1u);
}

TEST(Annotations, OfASavedViewAlone) {
  PmiItem other = item_at({0, -5, 15});
  other.views = {"B"};
  const Scene scene = cube_with({item_at({0, -5, 5}), other});
  Style style = builtin_style("outline");
  EXPECT_EQ(annotated(draw(scene, kFront, style)), 2u);
  style.pmi.view = "B";
  EXPECT_EQ(annotated(draw(scene, kFront, style)), 1u);
}

TEST(Annotations, WithoutLinesAreNamed) {
  PmiItem bare = item_at({0, 0, 0}), shared = bare;
  bare.lines.clear();
  bare.text = "flatness 0.1";
  shared.lines.clear();
  shared.shown_with = 0;
  const Drawing drawing = draw(cube_with({item_at({0, -5, 5}), bare, shared}), kFront);
  EXPECT_EQ(told(drawing, "pmi.not_shown"), 1);
  const auto& all = drawing.diagnostics.entries();
  const auto found = std::ranges::find(all, "pmi.not_shown", &Diagnostic::code);
  EXPECT_NE(found->message.find("flatness 0.1"), std::string::npos);
}

TEST(Annotations, MoveWithTheirPart) {
  Scene scene = cube_with({item_at({0, -5, 5})});
  move_parts(scene, {Vec3(0, 0, 100)});
  const Drawing drawing = draw(scene, kFront);
  ASSERT_EQ(annotated(drawing), 1u);
  EXPECT_EQ(drawing.layers.back().paths[0].points3[0], Vec3(0, -5, 105));
}

TEST(Annotations, OfPartsThatAreNotDrawnAreNot) {
  Scene scene = cube_with({item_at({0, -5, 5})});
  test::add_part(scene, "other", test::box({50, 0, 0}, {70, 20, 20}));
  IllustrateOptions options;
  options.part_styles.resize(2);
  options.part_styles[0].drawn = false;
  RunContext context;
  ViewOptions view;
  view.direction = kFront;
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return drawn_bounds(scene, {}, axes); }, view);
  EXPECT_EQ(annotated(illustrate(scene, camera, builtin_style("outline"), options, context)), 0u);
}

}  // namespace
}  // namespace burin
