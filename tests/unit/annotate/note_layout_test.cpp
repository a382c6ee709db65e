// Where notes stand about a drawing, and where their leaders end.
#include <burin/annotate/dimensions.h>
#include <burin/drawing/font.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {
namespace {

/// From above, a mm of paper a mm.
const PaperView kTop{Mat3(1), 1, Vec2(0)};

Dimension note(const std::string& text, Vec3 tip, double room = 3) {
  Dimension one;
  one.kind = Dimension::Kind::Note;
  one.label = std::make_shared<const Label>(text_label(text, false, {}));
  one.targets = {{.tips = {tip}, .rooms = {room}}};
  return one;
}

ViewDimensions about_plate(std::vector<Dimension> list) {
  return {std::move(list), Box3{{0, 0, 0}, {80, 50, 10}}};
}

bool apart(const Box2& a, const Box2& b) {
  return a.max.x <= b.min.x || b.max.x <= a.min.x || a.max.y <= b.min.y || b.max.y <= a.min.y;
}

TEST(NoteLayout, ALeaderEndsInADotWhereThereIsRoomElseInAnArrow) {
  const LaidDimensions wide = lay_out(about_plate({note("oil", {40, 25, 10})}), kTop, {});
  const LaidDimensions narrow = lay_out(about_plate({note("oil", {40, 25, 10}, 0.2)}), kTop, {});
  ASSERT_EQ(wide.notes.paths.size(), 3U);  // the leader, its dot, the shoulder
  EXPECT_EQ(wide.notes.paths[0].points[0], Vec2(40, 25));
  EXPECT_EQ(wide.notes.paths[1].points, (std::vector<Vec2>{{40, 25}, {40, 25}}));
  const Path& arrow = narrow.notes.paths.at(1);
  EXPECT_EQ(arrow.points.back(), Vec2(40, 25));
  EXPECT_EQ(arrow.width.back(), 0);
  EXPECT_TRUE(wide.layer.paths.empty());
}

TEST(NoteLayout, TakesATipWithRoomRatherThanANearOne) {
  Dimension one = note("oil", {79, 25, 10}, 0.1);
  one.targets[0].tips.push_back({70, 25, 10});
  one.targets[0].rooms.push_back(4);
  const LaidDimensions laid = lay_out(about_plate({one}), kTop, {});
  EXPECT_EQ(laid.notes.paths.at(0).points[0], Vec2(70, 25));
}

/// Wherever they point: no words lie on others or on the drawing.
TEST(NoteLayout, TwentyNotesLieOnNothing) {
  std::vector<Dimension> list;
  for (int k = 0; k < 20; ++k) {
    const std::string text = "note " + std::to_string(k) + (k % 3 ? "" : "\nof two lines");
    list.push_back(
        note(text, {5 + 70.0 * ((7 * k) % 20) / 19, 5 + 40.0 * ((11 * k) % 20) / 19, 10}));
  }
  const LaidDimensions laid = lay_out(about_plate(list), kTop, {});
  std::vector<Box2> boxes;
  for (const Text& text : laid.notes.texts) {
    Box2 box = text_box(text);
    box.min.y = text.at.y;  // tails may come near
    for (const Box2& other : boxes) EXPECT_TRUE(apart(box, other)) << text.text;
    EXPECT_TRUE(apart(box, Box2{{0, 0}, {80, 50}})) << text.text;
    boxes.push_back(box);
  }
  EXPECT_EQ(boxes.size(), 27U);
}

TEST(NoteLayout, TwoHundredNotesHavePlaces) {
  std::vector<Dimension> list;
  for (int k = 0; k < 200; ++k) {
    list.push_back(
        note("n", {5 + 70.0 * ((7 * k) % 40) / 39, 5 + 40.0 * ((11 * k) % 40) / 39, 10}));
  }
  EXPECT_EQ(lay_out(about_plate(list), kTop, {}).notes.texts.size(), 200U);
}

/// The line of a section goes up from the drawing, where a note would stand.
TEST(NoteLayout, KeepsOffLinesThatAreLaidOverTheDrawingLater) {
  const auto lies_on_it = [](bool told) {
    const std::vector<Vec2> line{{64, 0}, {64, 64}, {72, 64}};
    ViewDimensions dimensions = about_plate({note("a note of some length", {40, 45, 10})});
    if (told) dimensions.over_it.push_back(line);
    const LaidDimensions laid = lay_out(dimensions, kTop, {});
    const Box2 box = text_box(laid.notes.texts.at(0));
    return !apart(box, Box2{{64, 0}, {64, 64}}) || !apart(box, Box2{{64, 64}, {72, 64}});
  };
  EXPECT_TRUE(lies_on_it(false));
  EXPECT_FALSE(lies_on_it(true));
}

/// Another view begins beside the drawing.
TEST(NoteLayout, StandsInWhatOtherViewsLeave) {
  const auto right_end = [](std::optional<Box2> within) {
    ViewDimensions dimensions = about_plate({note("of some length", {70, 25, 10})});
    dimensions.within = within;
    return text_box(lay_out(dimensions, kTop, {}).notes.texts.at(0)).max.x;
  };
  EXPECT_GT(right_end({}), 90);
  EXPECT_LE(right_end(Box2{{-60, -40}, {90, 90}}), 90);
}

/// Tails of letters end above the shoulder of a leader.
TEST(NoteLayout, TailsStandOverTheLeader) {
  const Label label = text_label("jpg", false, {});
  Box2 ink;
  for (const auto& ring : text_outlines(label.texts.at(0), 0.01)) {
    for (const Vec2& p : ring) ink.add(p);
  }
  EXPECT_GT(ink.min.y, label.shoulder + 0.1);
}

TEST(NoteLayout, SeveralTargetsShareAnElbow) {
  Dimension one = note("break edges", {10, 25, 10});
  one.targets.push_back(
      {.source = {.part = 3}, .tips = {{30, 40, 10}, {70, 5, 10}}, .rooms = {0, 0}});
  const LaidDimensions laid = lay_out(about_plate({one}), kTop, {});
  std::vector<Vec2> elbows;
  for (const Path& path : laid.notes.paths) {
    if (path.points.size() != 2 || path.width.size() != 1) continue;
    if (path.points[0].y == path.points[1].y) continue;  // the shoulder, the dot
    elbows.push_back(path.points[1]);
    if (path.source.part == 3) {
      EXPECT_LT(path.points[0].x, 40);
    }
  }
  ASSERT_EQ(elbows.size(), 2U);
  EXPECT_EQ(elbows[0], elbows[1]);
}

TEST(NoteLayout, APlaceOfItsOwnIsKeptAndOthersAvoidIt) {
  const Vec2 free = lay_out(about_plate({note("first", {75, 45, 10})}), kTop, {}).notes.texts[0].at;
  Dimension fixed = note("fixed", {40, 25, 10});
  fixed.place = free;
  const LaidDimensions laid = lay_out(about_plate({note("first", {75, 45, 10}), fixed}), kTop, {});
  ASSERT_EQ(laid.notes.texts.size(), 2U);
  EXPECT_NEAR(laid.notes.texts[1].at.x, free.x, 2);
  EXPECT_TRUE(apart(text_box(laid.notes.texts[0]), text_box(laid.notes.texts[1])));
}

TEST(NoteLayout, AFrameIsAboutAllLines) {
  const Label label = text_label("one\nanother", true, {.height = 5});
  ASSERT_EQ(label.paths.size(), 1U);
  ASSERT_EQ(label.texts.size(), 2U);
  for (const Text& text : label.texts) {
    const Box2 box = text_box(text);
    EXPECT_GT(box.min.x, 0);
    EXPECT_GT(text.at.y, 0);
    EXPECT_LT(box.max.x, label.size.x);
    EXPECT_LT(text.at.y + 5, label.size.y);
  }
  EXPECT_GT(label.texts[0].at.y, label.texts[1].at.y);
}

}  // namespace
}  // namespace burin
