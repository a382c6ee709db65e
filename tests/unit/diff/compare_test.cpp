/// Revisions of meshes: how far moved and turned, what has changed, what is only written anew.

#include <burin/base/error.h>
#include <burin/base/placement.h>
#include <burin/diff/difference.h>
#include <burin/forms/mesh/mesh_form.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace burin {
namespace {

Part part(const std::string& name, TriMesh mesh, const std::string& source = "a.stl") {
  Part p;
  p.name = name;
  p.source = source;
  p.form = std::make_shared<MeshForm>(std::move(mesh));
  return p;
}

Difference compared(std::vector<Part> before, std::vector<Part> after) {
  Scene was, is;
  was.parts = std::move(before);
  is.parts = std::move(after);
  RunContext context;
  Diagnostics said;
  Difference difference =
      compare_revisions(was, is, std::vector<bool>(was.parts.size(), true),
                        std::vector<bool>(is.parts.size(), true), said, context);
  EXPECT_TRUE(said.empty());
  return difference;
}

TriMesh renumbered(TriMesh mesh) {
  const auto n = static_cast<std::uint32_t>(mesh.positions.size());
  std::ranges::reverse(mesh.positions);
  std::ranges::reverse(mesh.triangles);
  for (Triangle& t : mesh.triangles) t = {n - 1 - t[1], n - 1 - t[2], n - 1 - t[0]};
  return mesh;
}

TriMesh placed(TriMesh mesh, const Placement& at) {
  for (Vec3& p : mesh.positions) p = at.point(p);
  return mesh;
}

/// A bent arm: no two of its moments are one.
TriMesh arm() {
  return test::joined(
      test::joined(test::box({0, 0, 0}, {10, 2, 2}), test::box({8, 3, 0}, {10, 9, 2})),
      test::box({0, 0, 3}, {2, 2, 7}));
}

TriMesh prism(int sides, double radius, double height) {
  return test::cylinder(radius, height, static_cast<std::uint32_t>(sides));
}

/// A cube with numbered faces: the colour of each, "" as the part.
Part painted(const std::vector<std::string>& colors, bool other_way = false) {
  TriMesh mesh = test::box({100, 0, 0}, {110, 10, 10});
  auto faces = std::make_shared<std::vector<std::int32_t>>();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 n = mesh.normal(t);
    const int axis = std::abs(n.x) > 0.5 ? 0 : std::abs(n.y) > 0.5 ? 1 : 2;
    faces->push_back(2 * axis + (n[axis] > 0 ? 1 : 0));
  }
  if (other_way) {
    std::ranges::reverse(mesh.triangles);
    std::ranges::reverse(*faces);
  }
  Part p{"cube", "a.stl", std::make_shared<MeshForm>(std::move(mesh), nullptr, std::move(faces))};
  p.color = "#00ff00";
  FaceColors of;
  for (const std::string& color : colors) {
    of.of_face.push_back(color.empty() ? -1 : static_cast<std::int32_t>(of.colors.size()));
    if (!color.empty()) of.colors.push_back(color);
  }
  p.face_colors = std::make_shared<const FaceColors>(std::move(of));
  return p;
}

TEST(Compare, ColoursOfFacesAreTold) {
  const std::vector<std::string> top = {"", "", "", "", "", "#ff0000"};
  EXPECT_TRUE(compared({painted(top)}, {painted(top, true)}).same());
  const std::vector<std::vector<std::string>> others = {{"", "", "", "", "", "#0000ff"},
                                                        {"", "", "", "", "#ff0000", ""},
                                                        {"", "", "", "#0000ff", "", "#ff0000"},
                                                        {"", "", "", "", "", ""}};
  for (const auto& other : others) {
    const Difference found = compared({painted(top)}, {painted(other)});
    ASSERT_EQ(found.parts.size(), 1u);
    EXPECT_EQ(found.parts[0].changes(), std::vector<PartChange>{PartChange::Look});
    EXPECT_TRUE(found.parts[0].match.face_colors);
  }
  // Opposite faces change places: the middles stay.
  const std::vector<std::string> ring = {"#ff0000", "#ff0000", "#0000ff", "#0000ff", "", ""},
                                 turned = {"#0000ff", "#0000ff", "#ff0000", "#ff0000", "", ""};
  EXPECT_TRUE(compared({painted(ring)}, {painted(turned)}).parts[0].match.face_colors);
}

TEST(Compare, WhatIsWrittenInAnotherOrderIsTheSame) {
  const Difference d =
      compared({part("arm", arm()), part("ball", test::ellipsoid({5, 4, 3}, 24, 12))},
               {part("ball", renumbered(test::ellipsoid({5, 4, 3}, 24, 12))),
                part("arm", renumbered(arm()))});
  EXPECT_TRUE(d.same());
  EXPECT_EQ(d.count(PartChange::Same), 2U);
}

TEST(Compare, TheFileIsNoName) {
  const Difference d =
      compared({part("old", arm(), "x/old.stl")}, {part("new", arm(), "y/new.stl")});
  EXPECT_TRUE(d.same());
}

TEST(Compare, AShiftIsToldToItsLength) {
  const Difference d = compared({part("arm", arm())},
                                {part("arm", renumbered(placed(arm(), {Mat3(1), {3, 4, 0}})))});
  ASSERT_EQ(d.parts.size(), 1U);
  EXPECT_EQ(d.parts[0].change(), PartChange::Moved);
  EXPECT_NEAR(glm::length(d.parts[0].motion->by), 5, 1e-9);
  ASSERT_TRUE(d.parts[0].motion->degrees.has_value());
  EXPECT_NEAR(*d.parts[0].motion->degrees, 0, 1e-9);
}

TEST(Compare, ATurnIsToldByAngleAndAxis) {
  // In the same order of points and in another one; about an axis of the model and not.
  for (const bool other_order : {false, true}) {
    const Mat3 turn = rotation({0, 0, 37});
    TriMesh moved = placed(arm(), {turn, {1, 2, 3}});
    if (other_order) moved = renumbered(moved);
    const Difference d = compared({part("arm", arm())}, {part("arm", moved)});
    ASSERT_EQ(d.parts[0].change(), PartChange::Moved);
    ASSERT_TRUE(d.parts[0].motion->degrees.has_value());
    EXPECT_NEAR(*d.parts[0].motion->degrees, 37, 1e-4);
    EXPECT_NEAR(std::abs(d.parts[0].motion->axis.z), 1, 1e-6);
  }
}

TEST(Compare, OfTurnsThatLookAlikeTheLeastIsTold) {
  const TriMesh nut = prism(6, 5, 4);
  for (const double angle : {0.0, 20.0, 60.0, 75.0}) {
    const Difference d =
        compared({part("nut", nut)},
                 {part("nut", renumbered(placed(nut, {rotation({0, 0, angle}), {30, 0, 0}})))});
    ASSERT_EQ(d.parts[0].change(), PartChange::Moved) << angle;
    ASSERT_TRUE(d.parts[0].motion->degrees.has_value()) << angle;
    const double least = std::min(std::fmod(angle, 60), 60 - std::fmod(angle, 60));
    EXPECT_NEAR(*d.parts[0].motion->degrees, least, 1e-4) << angle;
  }
}

TEST(Compare, ANutTurnedInItsPlaceHasMoved) {
  const TriMesh nut = prism(6, 5, 4);
  const Difference d =
      compared({part("nut", nut)}, {part("nut", placed(nut, {rotation({0, 0, 30}), Vec3(0)}))});
  EXPECT_EQ(d.parts[0].change(), PartChange::Moved);
  EXPECT_NEAR(d.parts[0].motion->degrees.value_or(0), 30, 1e-4);
  const Difference same =
      compared({part("nut", nut)}, {part("nut", placed(nut, {rotation({0, 0, 60}), Vec3(0)}))});
  EXPECT_TRUE(same.same()) << "by a sixth of a turn it is what it was";
}

TEST(Compare, ACubeTurnsAboutItsCorners) {
  const TriMesh cube = test::box({-1, -1, -1}, {1, 1, 1});
  const Difference d = compared({part("cube", cube)},
                                {part("cube", placed(cube, {rotation({10, 20, 30}), {9, 0, 0}}))});
  ASSERT_EQ(d.parts[0].change(), PartChange::Moved);
  ASSERT_TRUE(d.parts[0].motion->degrees.has_value());
  const Mat3 turn = rotation({10, 20, 30});
  const double degrees =
      std::acos(0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1)) * 180 / test::kPi;
  EXPECT_LE(*d.parts[0].motion->degrees, degrees + 1e-6);
  EXPECT_GT(*d.parts[0].motion->degrees, 5);
}

TEST(Compare, AChangedPartThatStaysHasNotMoved) {
  const TriMesh plate = test::box({0, 0, 0}, {40, 30, 2});
  const TriMesh longer = test::box({0, 0, 0}, {44, 30, 2});
  const Difference d = compared({part("plate", plate)}, {part("plate", longer)});
  ASSERT_EQ(d.parts[0].changes(), std::vector{PartChange::Changed});
  EXPECT_NEAR(d.parts[0].numbers_before->volume, 2400, 1e-9);
  EXPECT_NEAR(d.parts[0].numbers_after->volume, 2640, 1e-9);
  EXPECT_NEAR(d.parts[0].numbers_after->box.x, 44, 1e-12);
  EXPECT_GT(d.parts[0].surface_changed, 0);
  EXPECT_LT(d.parts[0].surface_changed, 0.15);
}

TEST(Compare, AChangedPartThatHasMovedIsBoth) {
  const TriMesh plate =
      test::joined(test::box({0, 0, 0}, {40, 30, 2}), test::box({5, 5, 2}, {9, 9, 20}));
  const TriMesh other =
      test::joined(test::box({0, 0, 0}, {40, 30, 2}), test::box({5, 5, 2}, {9, 9, 18}));
  const Difference d =
      compared({part("plate", plate)}, {part("plate", placed(other, {Mat3(1), {60, 0, 0}}))});
  ASSERT_EQ(d.parts[0].changes(), (std::vector{PartChange::Changed, PartChange::Moved}));
  EXPECT_NEAR(d.parts[0].motion->by.x, 60, 1e-9);
  EXPECT_NEAR(glm::length(d.parts[0].motion->by), 60, 1e-9);
}

TEST(Compare, AMirrorImageHasChanged) {
  TriMesh mirror = arm();
  for (Vec3& p : mirror.positions) p.z = -p.z;
  for (Triangle& t : mirror.triangles) std::swap(t[1], t[2]);
  const Difference d = compared({part("arm", arm())}, {part("arm", mirror)});
  EXPECT_EQ(d.parts[0].change(), PartChange::Changed);
}

TEST(Compare, OpenSheetsHaveNoVolumeAndAreCompared) {
  TriMesh sheet;
  sheet.positions = {{0, 0, 0}, {10, 0, 0}, {10, 5, 0}, {0, 5, 1}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_TRUE(compared({part("s", sheet)}, {part("s", renumbered(sheet))}).same());
  const Difference d =
      compared({part("s", sheet)}, {part("s", placed(sheet, {Mat3(1), {0, 0, 2}}))});
  EXPECT_EQ(d.parts[0].change(), PartChange::Moved);
  EXPECT_EQ(d.parts[0].numbers_after->volume, 0);
}

TEST(Compare, PartsOfOneNameAreToldApartByTheirPlaces) {
  std::vector<Part> before, after;
  for (int i = 0; i < 6; ++i) {
    const std::string name = i == 0 ? "bolt" : "bolt #" + std::to_string(i + 1);
    before.push_back(part(name, placed(prism(6, 2, 9), {Mat3(1), {10.0 * i, 0, 0}})));
  }
  int number = 0;
  for (int i = 0; i < 6; ++i) {
    if (i == 3) continue;
    const std::string name = ++number == 1 ? "bolt" : "bolt #" + std::to_string(number);
    after.push_back(part(name, placed(prism(6, 2, 9), {Mat3(1), {10.0 * i, 0, 0}})));
  }
  const Difference d = compared(before, after);
  EXPECT_EQ(d.count(PartChange::Same), 5U);
  ASSERT_EQ(d.count(PartChange::Removed), 1U);
  EXPECT_EQ(d.parts.back().before, "bolt #4");
}

TEST(Compare, FarFromTheOriginAndSmallItIsAllTheSame) {
  for (const double scale : {1e-3, 1.0, 1e4}) {
    const Placement far{Mat3(scale), Vec3(3e5 * scale, -2e5 * scale, 1e5 * scale)};
    const TriMesh mesh = placed(arm(), far);
    EXPECT_TRUE(compared({part("arm", mesh)}, {part("arm", renumbered(mesh))}).same()) << scale;
    const TriMesh moved = placed(mesh, {Mat3(1), Vec3(0.1 * scale, 0, 0)});
    const Difference d = compared({part("arm", mesh)}, {part("arm", moved)});
    EXPECT_EQ(d.parts[0].change(), PartChange::Moved) << scale;
    EXPECT_NEAR(d.parts[0].motion->by.x, 0.1 * scale, 1e-6 * scale) << scale;
  }
}

TEST(Compare, NothingOnOneSideIsAllNew) {
  const Difference d = compared({}, {part("a", arm())});
  EXPECT_EQ(d.count(PartChange::Added), 1U);
  EXPECT_FALSE(d.same());
  EXPECT_TRUE(compared({}, {}).same());
}

TEST(Compare, CanBeCancelled) {
  Scene scene;
  scene.parts = {part("a", arm())};
  RunContext context;
  Diagnostics said;
  context.cancel();
  EXPECT_THROW(compare_revisions(scene, scene, {true}, {true}, said, context), Cancelled);
}

}  // namespace
}  // namespace burin
