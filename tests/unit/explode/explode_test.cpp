/// Exploded views of assemblies that can be thought through.

#include <burin/assembly/select.h>
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/explode/explode.h>

#include <burin_test/exploded.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace burin {
namespace {

using Parts = std::vector<std::size_t>;

Explosion explode(const Scene& scene, const ExplodeOptions& options = {},
                  Diagnostics* reported = nullptr) {
  RunContext context;
  Diagnostics diagnostics;
  const ExplodeModel model(scene, std::vector<bool>(scene.parts.size(), true), context);
  Explosion explosion = model.find(options, diagnostics, context);
  if (reported) *reported = diagnostics;
  return explosion;
}

std::vector<Curve3> trails(const Scene& scene, const std::vector<ExplodeStep>& steps) {
  RunContext context;
  return ExplodeModel(scene, std::vector<bool>(scene.parts.size(), true), context).trails(steps, 1);
}

double gap(const Scene& scene) { return 0.06 * scene.bounds().diagonal(); }

Scene bolt_in_plate() {
  Scene scene;
  test::add_part(scene, "plate", test::ring(5, 30, 0, 10));
  test::add_part(scene, "bolt", test::bolt(5, 9, 0, 10, 16));
  return scene;
}

TEST(Explode, ABoltLeavesItsPlateByTheHead) {
  const Scene scene = bolt_in_plate();
  const Explosion e = explode(scene);
  ASSERT_EQ(e.steps.size(), 1U);
  EXPECT_EQ(e.steps[0].parts, (Parts{1}));
  EXPECT_LT(glm::distance(e.steps[0].along, Vec3(0, 0, 1)), 1e-9);
  EXPECT_NEAR(e.steps[0].by, 10 + gap(scene), 1e-3);
  EXPECT_TRUE(e.interlocked.empty());
  test::expect_takes_apart(scene, e.steps);
}

// No ray along the axis meets both.
TEST(Explode, ANutClearsItsShank) {
  Scene scene;
  test::add_part(
      scene, "bolt",
      test::moved(test::bolt(5, 12, -40, 0, 8), Mat3(1, 0, 0, 0, -1, 0, 0, 0, -1), Vec3(0)));
  test::add_part(scene, "nut", test::ring(5, 9, 12, 18));
  const Explosion e = explode(scene);
  ASSERT_EQ(e.steps.size(), 1U);
  EXPECT_EQ(e.steps[0].parts, (Parts{1}));
  EXPECT_LT(glm::distance(e.steps[0].along, Vec3(0, 0, 1)), 1e-9);
  EXPECT_NEAR(e.steps[0].by, 40 - 12 + gap(scene), 1e-3);
}

Scene box_with_lid() {
  Scene scene;
  test::add_part(
      scene, "ball",
      test::moved(test::turned(test::sphere_profile(6, 24), 24), Mat3(1), Vec3(0, 0, 10)));
  test::add_part(scene, "box",
                 test::turned({{1, 0}, {30, 0}, {30, 20}, {25, 20}, {25, 4}, {1, 4}}, 48, true));
  test::add_part(
      scene, "lid",
      test::turned({{1, 17}, {25, 17}, {25, 20}, {30, 20}, {30, 24}, {1, 24}}, 48, true));
  return scene;
}

TEST(Explode, TheLidGoesBeforeWhatIsInTheBox) {
  const Scene scene = box_with_lid();
  const Explosion e = explode(scene);
  ASSERT_EQ(e.steps.size(), 2U);
  EXPECT_EQ(e.steps[0].parts, (Parts{2}));
  EXPECT_EQ(e.steps[1].parts, (Parts{0}));
  for (const ExplodeStep& step : e.steps) {
    EXPECT_LT(glm::distance(step.along, Vec3(0, 0, 1)), 1e-9);
  }
  EXPECT_NEAR(e.steps[1].by, 20 - 4 + gap(scene), 0.2) << "the ball clears the rim";
  test::expect_takes_apart(scene, e.steps);
}

TEST(Explode, InterlockedPartsAreNamedAndMoveAsOne) {
  Scene scene;
  test::add_part(scene, "left", test::torus(10, 2, 48, 24));
  test::add_part(
      scene, "right",
      test::moved(test::torus(10, 2, 48, 24), Mat3(1, 0, 0, 0, 0, 1, 0, -1, 0), Vec3(10, 0, 0)));
  Diagnostics reported;
  Explosion e = explode(scene, {}, &reported);
  EXPECT_TRUE(e.steps.empty());
  ASSERT_EQ(e.interlocked.size(), 1U);
  EXPECT_EQ(e.interlocked[0], (Parts{0, 1}));
  ASSERT_EQ(reported.entries().size(), 1U);
  EXPECT_EQ(reported.entries()[0].code, "explode.interlocked");
  EXPECT_NE(reported.entries()[0].message.find("'left', 'right'"), std::string::npos);

  test::add_part(scene, "table", test::box({-60, -60, -20}, {60, 60, -12}));
  e = explode(scene);
  ASSERT_EQ(e.steps.size(), 1U);
  EXPECT_EQ(e.steps[0].parts, (Parts{0, 1}));
  EXPECT_EQ(e.interlocked, (std::vector<Parts>{{0, 1}}));
  test::expect_takes_apart(scene, e.steps);
}

TEST(Explode, HalvesOfAShellComeOffTheirCore) {
  Scene scene;
  const auto half = [](double sign) {
    std::vector<Vec2> profile = {{12, 0}, {20, 0}, {20, 20}, {1, 20}, {1, 12}, {12, 12}};
    return test::moved(test::turned(profile, 48, true),
                       sign > 0 ? Mat3(1) : Mat3(1, 0, 0, 0, -1, 0, 0, 0, -1), Vec3(0));
  };
  test::add_part(scene, "upper", half(1));
  test::add_part(scene, "lower", half(-1));
  test::add_part(scene, "core", test::moved(test::cylinder(12, 24, 48), Mat3(1), Vec3(0, 0, -12)));
  const Explosion e = explode(scene);
  EXPECT_TRUE(e.interlocked.empty());
  test::expect_takes_apart(scene, e.steps);
  const auto moves = moves_of(e.steps, 3, 1);
  EXPECT_GT(moves[0].z - moves[2].z, gap(scene));
  EXPECT_GT(moves[2].z - moves[1].z, gap(scene));
}

TEST(Explode, AClosedShellKeepsItsCore) {
  Scene scene;
  test::add_part(scene, "shell", test::joined(test::box(Vec3(-20), Vec3(20)), [] {
                   TriMesh hollow = test::box(Vec3(-12), Vec3(12));
                   for (Triangle& t : hollow.triangles) std::swap(t[1], t[2]);
                   return hollow;
                 }()));
  test::add_part(scene, "core", test::box(Vec3(-8), Vec3(8)));
  const Explosion e = explode(scene);
  EXPECT_TRUE(e.steps.empty());
  EXPECT_EQ(e.interlocked, (std::vector<Parts>{{0, 1}}));
}

// A stud that is 0.5 mm too thick for its hole.
TEST(Explode, ThreadsAndPressFitsComeApartWhereTheFitIsSaid) {
  Scene scene;
  test::add_part(scene, "plate", test::ring(5, 30, 0, 10));
  test::add_part(scene, "stud", test::bolt(5.5, 9, 0, 10, 16));
  EXPECT_EQ(explode(scene).interlocked.size(), 1U);
  const Explosion e = explode(scene, {.fit = 0.8});
  EXPECT_TRUE(e.interlocked.empty());
  ASSERT_EQ(e.steps.size(), 1U);
  EXPECT_GT(e.steps[0].along.z, 0.999);
}

/// A base with two carriages, each a block on which a knob sits; the names make them assemblies.
Scene carriages() {
  Scene scene;
  test::add_part(scene, "base", test::box({-50, -20, -10}, {50, 20, 0}));
  for (const double x : {-25.0, 25.0}) {
    const std::string name = x < 0 ? "left" : "right";
    test::add_part(scene, "block", test::box({x - 15, -10, 0}, {x + 15, 10, 12}), {"m", name});
    test::add_part(scene, "knob", test::ring(2, 6, 12, 20, {x, 0, 0}), {"m", name});
  }
  scene.parts[0].assembly = {"m"};
  return scene;
}

TEST(Explode, WhatIsOneThingStaysTogether) {
  Scene scene = bolt_in_plate();
  test::add_part(scene, "tip", test::moved(test::ring(0.5, 4, 16, 20), Mat3(1), Vec3(0)));
  scene.parts[1].assembly = scene.parts[2].assembly = {"bolt"};
  EXPECT_EQ(explode(scene).steps.size(), 2U);
  scene.parts[2].joined = true;
  const Explosion e = explode(scene);
  ASSERT_EQ(e.steps.size(), 1U);
  EXPECT_EQ(e.steps[0].parts, (Parts{1, 2}));
  EXPECT_TRUE(e.interlocked.empty());
}

TEST(Explode, SubAssembliesLeaveAsWholesAndComeApartAfterwards) {
  const Scene scene = carriages();
  const Explosion e = explode(scene);
  ASSERT_GE(e.steps.size(), 2U);
  EXPECT_EQ(e.steps[0].parts, (Parts{1, 2, 3, 4})) << "equal ones together";
  test::expect_takes_apart(scene, e.steps);
  EXPECT_EQ(selectors_of(scene, e.steps[0].parts),
            (std::vector<std::string>{"/m/left", "/m/right"}));
  const auto moves = moves_of(e.steps, 5, 1);
  EXPECT_GT(moves[2].z, moves[1].z);
  // Half-way all is half as far.
  EXPECT_NEAR(moves_of(e.steps, 5, 0.5)[2].z, 0.5 * moves[2].z, 1e-12);
}

// A bolt through a plate whose nut belongs to the same assembly: it cannot leave as a whole.
TEST(Explode, SubAssembliesThatHoldOthersComeApartAtOnce) {
  Scene scene;
  test::add_part(scene, "plate", test::ring(5, 30, 0, 10), {"m"});
  test::add_part(scene, "bolt", test::bolt(5, 9, -10, 10, 16), {"m", "set"});
  test::add_part(scene, "nut", test::ring(5, 9, -8, 0), {"m", "set"});
  const Explosion e = explode(scene);
  EXPECT_TRUE(e.interlocked.empty());
  ASSERT_EQ(e.steps.size(), 2U);
  EXPECT_EQ(e.steps[0].parts, (Parts{2}));
  EXPECT_LT(e.steps[0].along.z, -0.999);
  EXPECT_EQ(e.steps[1].parts, (Parts{1}));
  test::expect_takes_apart(scene, e.steps);
}

TEST(Explode, AlongOneAxisAndOneWay) {
  Scene scene;
  test::add_part(scene, "middle", test::box({-20, -20, -5}, {20, 20, 5}));
  test::add_part(scene, "above", test::box({-10, -10, 5}, {10, 10, 9}));
  test::add_part(scene, "below", test::box({-10, -10, -9}, {10, 10, -5}));
  const Explosion both = explode(scene, {.along = Vec3(0, 0, 1)});
  EXPECT_EQ(both.steps.size(), 2U);
  const Explosion up = explode(scene, {.along = Vec3(0, 0, 2), .one_way = true});
  ASSERT_EQ(up.steps.size(), 1U);
  EXPECT_EQ(up.steps[0].parts, (Parts{1}));
  EXPECT_EQ(up.interlocked, (std::vector<Parts>{{0, 2}}));
  const Explosion from_below = explode(scene, {.along = Vec3(0, 0, 1), .one_way = true, .base = 2});
  EXPECT_EQ(from_below.steps.size(), 2U);
  test::expect_takes_apart(scene, from_below.steps);
}

TEST(Explode, AMovedAssemblyGivesTheSameStepsMoved) {
  const Placement place{2.5 * test::tilted(), {300, -40, 17}};
  for (const Scene& scene : {bolt_in_plate(), box_with_lid(), carriages()}) {
    Scene other = scene;
    RunContext context;
    for (Part& part : other.parts) {
      TriMesh mesh = part.form->realise({}, context)->proxy().mesh;
      part.form =
          std::make_shared<MeshForm>(test::moved(std::move(mesh), place.linear, place.offset));
    }
    const Explosion a = explode(scene), b = explode(other);
    ASSERT_EQ(a.steps.size(), b.steps.size());
    for (std::size_t i = 0; i < a.steps.size(); ++i) {
      EXPECT_EQ(a.steps[i].parts, b.steps[i].parts);
      EXPECT_NEAR(2.5 * a.steps[i].by, b.steps[i].by, 0.01 * b.steps[i].by);
      EXPECT_LT(glm::distance(place.linear * a.steps[i].along / 2.5, b.steps[i].along), 1e-3);
    }
  }
}

TEST(Explode, AHundredPartsComeApart) {
  const Scene scene = test::stacks(33);
  ASSERT_EQ(scene.parts.size(), 100U);
  const Explosion e = explode(scene);
  EXPECT_TRUE(e.interlocked.empty());
  test::expect_takes_apart(scene, e.steps);
  const auto moves = moves_of(e.steps, scene.parts.size(), 1);
  for (std::size_t i = 1; i < moves.size(); ++i) EXPECT_GT(moves[i].z, 0) << i;
  EXPECT_EQ(trails(scene, e.steps).size(), 33U) << "one a stack";
}

TEST(Explode, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = test::stacks(12);
  const Explosion all = explode(scene);
  const ThreadLimit limit(1);
  const Explosion one = explode(scene);
  ASSERT_EQ(all.steps.size(), one.steps.size());
  for (std::size_t i = 0; i < all.steps.size(); ++i) {
    EXPECT_EQ(all.steps[i].parts, one.steps[i].parts);
    EXPECT_EQ(all.steps[i].along, one.steps[i].along);
    EXPECT_EQ(all.steps[i].by, one.steps[i].by);
  }
}

TEST(Explode, ManyPartsAreTakenApartByTheirBoxes) {
  Scene scene;
  test::add_part(scene, "plate", test::box({-5, -5, -10}, {505, 505, 0}));
  for (int i = 0; i < 2050; ++i) {
    const int line = i / 50;
    const Vec3 at(10.0 * (i % 50), 10.0 * line, 0);
    test::add_part(scene, "cube", test::box(at, at + Vec3(6)));
  }
  Diagnostics reported;
  const Explosion e = explode(scene, {}, &reported);
  ASSERT_EQ(reported.entries().size(), 1U);
  EXPECT_EQ(reported.entries()[0].code, "explode.boxes");
  const auto moves = moves_of(e.steps, scene.parts.size(), 1);
  for (std::size_t i = 1; i < moves.size(); ++i) ASSERT_GT(moves[i].z, 0) << i;
}

TEST(Explode, OnePartOrNoneMovesNothingAndSaysSo) {
  Scene scene;
  test::add_part(scene, "alone", test::box(Vec3(0), Vec3(1)));
  Diagnostics reported;
  EXPECT_TRUE(explode(scene, {}, &reported).steps.empty());
  ASSERT_EQ(reported.entries().size(), 1U);
  EXPECT_EQ(reported.entries()[0].code, "explode.alone");
  RunContext context;
  const ExplodeModel none(scene, {false}, context);
  EXPECT_TRUE(none.find({}, reported, context).steps.empty());
}

TEST(Explode, StopsWhereItIsCancelled) {
  RunContext context;
  const Scene scene = bolt_in_plate();
  const ExplodeModel model(scene, {true, true}, context);
  context.cancel();
  Diagnostics reported;
  EXPECT_THROW(model.find({}, reported, context), Cancelled);
  EXPECT_THROW(ExplodeModel(scene, {true, true}, context), Cancelled);
}

TEST(Trails, RunOnTheAxisFromTheHoleToTheBolt) {
  const Scene scene = bolt_in_plate();
  const std::vector<Curve3> lines = trails(scene, explode(scene).steps);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].points.size(), 2U);
  EXPECT_EQ(lines[0].kind, LineClass::Trail);
  for (const Vec3& p : lines[0].points) EXPECT_LT(glm::length(Vec2(p)), 0.02);
  EXPECT_GT(glm::distance(lines[0].points[0], lines[0].points[1]), 10);
  // A step can do without.
  auto steps = explode(scene).steps;
  steps[0].trail = false;
  EXPECT_TRUE(trails(scene, steps).empty());
}

TEST(Trails, BendWhereTheOtherPartHasMovedAnotherWay) {
  Scene scene;
  test::add_part(scene, "base", test::box({-50, -50, -10}, {50, 50, 0}));
  test::add_part(scene, "block", test::box({-10, -10, 0}, {10, 10, 20}));
  test::add_part(scene, "cap", test::box({-10, -10, 20}, {10, 10, 24}));
  const std::vector<ExplodeStep> steps = {{{}, {2}, {0, 0, 1}, 30},
                                          {{}, {1}, {1, 0, 0}, 100, false}};
  const std::vector<Curve3> lines = trails(scene, steps);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].points.size(), 3U);
  EXPECT_LT(glm::distance(lines[0].points[0], Vec3(0, 0, 50)), 0.1);
  EXPECT_LT(glm::distance(lines[0].points[1], Vec3(0, 0, 20)), 0.1);
  EXPECT_LT(glm::distance(lines[0].points[2], Vec3(100, 0, 20)), 0.1);
}

TEST(Selectors, NameThePartsAndNoOthers) {
  Scene scene = carriages();
  EXPECT_EQ(selectors_of(scene, {1, 2}), (std::vector<std::string>{"/m/left"}));
  EXPECT_EQ(selectors_of(scene, {2}), (std::vector<std::string>{"/m/left/knob"}));
  scene.parts[2].name = "a*b/c";  // no pattern means this one alone
  scene.parts[4].name = "";
  for (const Parts& parts : {Parts{2}, Parts{4}, Parts{0, 2, 4}, Parts{0, 1, 2, 3, 4}}) {
    Parts named;
    for (const std::string& selector : selectors_of(scene, parts)) {
      for (const std::size_t part : select(scene, selector)) named.push_back(part);
    }
    std::ranges::sort(named);
    EXPECT_EQ(named, parts);
  }
}

}  // namespace
}  // namespace burin
