/// Which parts of two revisions are one, by numbers alone.

#include <burin/diff/match.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace burin {
namespace {

/// A cube of a side whose middle stands somewhere.
RevisionPart cube(const std::string& name, double side, Vec3 at) {
  RevisionPart p;
  p.path = p.stem = name;
  p.shape.area = 6 * side * side;
  p.shape.volume = side * side * side;
  p.shape.moments = Vec3(side * side * side * side);
  p.shape.faces = 6;
  p.pose.middle = at;
  p.pose.spread = Mat3(side * side / 6);
  p.pose.box = {at - 0.5 * side, at + 0.5 * side};
  return p;
}

std::vector<PartMatch> match(const std::vector<RevisionPart>& before,
                             const std::vector<RevisionPart>& after,
                             const LieOnEachOther& lie = {}) {
  const RunContext context;
  return match_parts(before, after, {.place = 1e-3}, lie, context);
}

TEST(Match, PartsThatStayAreTheSameInAnyOrder) {
  const std::vector<RevisionPart> before{cube("a", 1, {0, 0, 0}), cube("b", 2, {5, 0, 0})};
  const auto found = match(before, {before[1], before[0]});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].same());
  EXPECT_EQ(found[0].before, 1U);
  EXPECT_TRUE(found[1].same());
}

TEST(Match, OneOfManyEqualPartsIsGone) {
  std::vector<RevisionPart> before, after;
  for (int i = 0; i < 6; ++i) {
    RevisionPart bolt = cube("bolt_" + std::to_string(i + 1), 1, Vec3(10 * i, 0, 0));
    bolt.stem = "bolt";
    before.push_back(bolt);
  }
  // The third is gone, and the program has numbered the others anew.
  for (int i = 0; i < 5; ++i) {
    RevisionPart bolt = before[static_cast<std::size_t>(i < 2 ? i : i + 1)];
    bolt.path = "bolt_" + std::to_string(i + 1);
    after.push_back(bolt);
  }
  const auto found = match(before, after);
  ASSERT_EQ(found.size(), 6U);
  EXPECT_EQ(std::ranges::count_if(found, &PartMatch::same), 5);
  EXPECT_EQ(found[5].before, 2U);
  EXPECT_EQ(found[5].after, kNoPart);
}

TEST(Match, TheNearestOfEqualPartsHasMoved) {
  const auto bolt = [](Vec3 at) { return cube("bolt", 1, at); };
  const auto found = match({bolt({0, 0, 0}), bolt({10, 0, 0}), bolt({20, 0, 0})},
                           {bolt({20, 0, 1}), bolt({0, 0, 0})});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].before, 2U);
  EXPECT_TRUE(found[0].moved);
  EXPECT_TRUE(found[1].same());
  EXPECT_EQ(found[2].before, 1U);
  EXPECT_EQ(found[2].after, kNoPart);
}

TEST(Match, ARenamedPartIsKnownByItsShapeAndPlace) {
  const auto found = match({cube("lid", 1, {0, 0, 0})}, {cube("cover", 1, {0, 0, 0})});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].renamed);
  EXPECT_FALSE(found[0].moved || found[0].changed);
}

TEST(Match, PathGoesBeforeShape) {
  // "a" has another shape now, and what looks as it did is called otherwise and stands elsewhere.
  const auto found =
      match({cube("a", 1, {0, 0, 0})}, {cube("b", 1, {50, 0, 0}), cube("a", 1.2, {0, 0, 0})});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].before, kNoPart);
  EXPECT_EQ(found[1].before, 0U);
  EXPECT_TRUE(found[1].changed);
}

TEST(Match, AShapeOfAnotherNameElsewhereHasMovedAndIsRenamed) {
  const auto found = match({cube("a", 1, {0, 0, 0})}, {cube("b", 1, {50, 0, 0})});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].moved && found[0].renamed);
}

TEST(Match, NothingInCommonIsGoneAndNew) {
  const auto found = match({cube("a", 1, {0, 0, 0})}, {cube("b", 3, {50, 0, 0})});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].before, kNoPart);
  EXPECT_EQ(found[1].after, kNoPart);
}

TEST(Match, WhatStandsWhereAnotherPartStoodHasChanged) {
  const auto found = match({cube("a", 1, {0, 0, 0})}, {cube("b", 1.1, {0, 0, 0})});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].changed && found[0].renamed);
}

TEST(Match, SurfacesThatDoNotLieOnEachOtherHaveMoved) {
  const RevisionPart part = cube("a", 1, {0, 0, 0});
  int asked = 0;
  const auto found = match({part}, {part}, [&](std::size_t, std::size_t) {
    ++asked;
    return false;
  });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].moved);
  EXPECT_EQ(asked, 3) << "once a rule of places";
}

TEST(Match, LooksAndMirrorImagesAreTold) {
  RevisionPart was = cube("a", 1, {0, 0, 0}), is = was;
  is.color = "#ff0000";
  EXPECT_TRUE(match({was}, {is})[0].look);
  is = was;
  is.drawn = false;
  EXPECT_TRUE(match({was}, {is})[0].look);
  is = was;
  is.opacity = 0.3;
  EXPECT_TRUE(match({was}, {is})[0].look) << "it has become glass";
  is.opacity = 1 - 0.5 / 255;
  EXPECT_TRUE(match({was}, {is})[0].same()) << "a byte holds it";
  is = was;
  was.shape.handedness = 0.1;
  is.shape.handedness = -0.1;
  EXPECT_TRUE(match({was}, {is})[0].changed) << "a mirror image is another shape";
}

TEST(Match, ColoursOfFacesAreTold) {
  RevisionPart was = cube("a", 1, {0, 0, 0});
  was.face_colors = {{"", 5, {0, 0, -0.1}, {0.1, 0.1, 0.1}},
                     {"#ff0000", 1, {0, 0, 0.5}, {0.08, 0.08, 0}}};
  RevisionPart is = was;
  EXPECT_TRUE(match({was}, {is})[0].same());
  is.face_colors[1].color = "#0000ff";
  PartMatch found = match({was}, {is})[0];
  EXPECT_TRUE(found.look && found.face_colors);
  EXPECT_FALSE(found.renamed);
  is = was;
  is.face_colors[1].middle = {0, 0, -0.5};
  EXPECT_TRUE(match({was}, {is})[0].face_colors) << "another face is red";
  is.pose.middle.x += 2;
  for (ColorShare& one : is.face_colors) one.middle.x += 2;
  found = match({was}, {is})[0];
  EXPECT_TRUE(found.moved);
  EXPECT_FALSE(found.face_colors) << "moved, it may have been turned, too";
  is.face_colors.clear();
  EXPECT_TRUE(match({was}, {is})[0].face_colors);
}

TEST(Match, ToleratesWhatTheShapesAreMeasuredBy) {
  const RevisionPart was = cube("a", 1, {0, 0, 0});
  RevisionPart is = was;
  is.pose.middle.x = 0.9e-3;
  is.shape.volume *= 1 + 1e-8;
  EXPECT_TRUE(match({was}, {is})[0].same());
  is.pose.middle.x = 1.1e-3;
  EXPECT_TRUE(match({was}, {is})[0].moved);
  is.pose.error = 1e-3;
  EXPECT_TRUE(match({was}, {is})[0].same());
}

TEST(Match, TenThousandPartsOfOneName) {
  std::vector<RevisionPart> before, after;
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 at(3 * (i % 100), 3 * (i / 100), 0);
    before.push_back(cube("bolt", 1, at));
    // Every third one has moved; one is gone.
    if (i != 5000) after.push_back(cube("bolt", 1, i % 3 == 0 ? at + Vec3(0, 0, 1) : at));
  }
  const auto found = match(before, after);
  ASSERT_EQ(found.size(), 10'000U);
  EXPECT_EQ(std::ranges::count_if(found, &PartMatch::same), 10'000 - 3334 - 1);
  EXPECT_EQ(found.back().before, 5000U);
  for (const PartMatch& one : found) {
    if (one.moved) {
      EXPECT_EQ(before[one.before].pose.middle + Vec3(0, 0, 1), after[one.after].pose.middle);
    }
  }
}

TEST(Match, TenThousandPartsThatAllHaveMoved) {
  std::vector<RevisionPart> before, after;
  for (int i = 0; i < 10'000; ++i) {
    before.push_back(cube("bolt", 1, Vec3(3 * i, 0, 0)));
    after.push_back(cube("bolt", 1, Vec3(3 * i, 1, 0)));
  }
  const auto found = match(before, after);
  ASSERT_EQ(found.size(), 10'000U);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].before, i);
}

}  // namespace
}  // namespace burin
