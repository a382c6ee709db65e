#include "flat/origins.h"
#include "flat_trees.h"

#include <gtest/gtest.h>

#include <cmath>

namespace burin::csg::test {
namespace {

double regular_area(int n, double r) { return 0.5 * n * r * r * std::sin(2 * M_PI / n); }

/// A sound solid of the volume.
void expect_solid(const Solid& solid, double expected, const std::string& of) {
  EXPECT_EQ(flaw(solid), "") << of;
  EXPECT_NEAR(volume(solid), expected, 1e-7 * std::abs(expected)) << of;
}

const std::string kPlate =
    "{ difference() { square(size = [10, 8], center = true); circle($fn = 24, r = 2); } }";

TEST(Extrusions, StraightOnesHaveCylindersForTheirArcs) {
  Evaluated tree(
      "linear_extrude(height = 3, center = true, convexity = 1, scale = [1, 1], $fn = 0, "
      "$fa = 12, $fs = 2) " +
      kPlate);
  const Solid solid = tree.solid();
  expect_solid(solid, 3 * (80 - regular_area(24, 2)), "plate");
  EXPECT_EQ(tagged_triangles(solid), 48u);
  EXPECT_EQ(solid.surfaces.size(), 1u);
  EXPECT_LT(farthest_from_surfaces(solid), 1e-9);
}

TEST(Extrusions, NarrowedOnesHaveConesAboutTheMiddleOnly) {
  const std::string half = "linear_extrude(height = 6, scale = [0.5, 0.5]) ";
  const Solid solid = Evaluated(half + kPlate).solid();
  expect_solid(solid, (80 - regular_area(24, 2)) * 6 * (1 + 0.5 + 0.25) / 3, "plate");
  EXPECT_EQ(tagged_triangles(solid), 48u);
  EXPECT_LT(farthest_from_surfaces(solid), 1e-9);
  const Solid aside = Evaluated(half +
                                "{ multmatrix([[1,0,0,9],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { "
                                "circle($fn = 24, r = 2); } }")
                          .solid();
  expect_solid(aside, regular_area(24, 2) * 6 * 1.75 / 3, "aside");
  // An oblique cone is a smooth surface of its own.
  EXPECT_EQ(tagged_triangles(aside), 48u);
  EXPECT_EQ(aside.surfaces.front().profile, Turned::Profile::Grid);
}

TEST(Extrusions, APointEndsThemClosed) {
  const Solid cone =
      Evaluated("linear_extrude(height = 6, scale = [0, 0]) { circle($fn = 24, r = 2); }").solid();
  expect_solid(cone, regular_area(24, 2) * 2, "cone");
  EXPECT_EQ(tagged_triangles(cone), 24u);
  expect_solid(Evaluated("linear_extrude(height = 6, scale = [0, 0]) " + kPlate).solid(),
               (80 - regular_area(24, 2)) * 2, "plate with a hole");
}

TEST(Extrusions, ARidgeEndsThemClosed) {
  for (const char* scale : {"[0, 1]", "[1, 0]"}) {
    const std::string extrude =
        "linear_extrude(height = 6, slices = 1, scale = " + std::string(scale) + ") ";
    expect_solid(Evaluated(extrude + "{ square(size = [4, 4], center = true); }").solid(), 48,
                 scale);
    for (const std::string& shape :
         {kPlate, std::string("{ circle($fn = 25, r = 4); }"),
          std::string("{ polygon(points = [[0,0],[9,1],[5,3],[8,7],[2,8]], paths = undef, "
                      "convexity = 1); }"),
          std::string(
              "{ difference() { square(size = [2, 2], center = true); square(size = [1, 1], "
              "center = true); } }")}) {
      const Solid solid = Evaluated(extrude + shape).solid();
      EXPECT_EQ(flaw(solid), "") << scale << shape;
      EXPECT_GT(volume(solid), 0) << scale << shape;
    }
  }
}

TEST(Extrusions, TwistedOnesAreClosedAndLieWithinTheirTurn) {
  for (const char* twist : {"90", "-200", "360"}) {
    const Solid solid = Evaluated("linear_extrude(height = 20, twist = " + std::string(twist) +
                                  ", slices = 80, scale = [1, 1]) " + kPlate)
                            .solid();
    EXPECT_EQ(flaw(solid), "") << twist;
    const double straight = 20 * (80 - regular_area(24, 2));
    EXPECT_NEAR(volume(solid), straight, 0.04 * straight) << twist;
    // All walls are smooth surfaces.
    EXPECT_EQ(tagged_triangles(solid), 28u * 80 * 2);
  }
}

TEST(Extrusions, OutlinesThatTouchInAPointBecomeShellsOfTheirOwn) {
  const Solid solid = Evaluated(
                          "linear_extrude(height = 2) { polygon(points = [[0,0],[1,0],[1,1],"
                          "[0,1],[2,1],[2,2],[1,2]], paths = [[0,1,2,3],[2,4,5,6]], "
                          "convexity = 1); }")
                          .solid();
  expect_solid(solid, 4, "two squares");
  EXPECT_EQ(solid.positions.size(), 16u);
}

TEST(Extrusions, TurnedRectanglesAreTubes) {
  const std::string rectangle =
      "{ multmatrix([[1,0,0,3],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { square(size = [2, 5], center = "
      "false); } }";
  const Solid tube =
      Evaluated("rotate_extrude(angle = 360, convexity = 2, $fn = 36) " + rectangle).solid();
  expect_solid(tube, 5 * (regular_area(36, 5) - regular_area(36, 3)), "tube");
  EXPECT_EQ(tagged_triangles(tube), 144u);
  EXPECT_EQ(tube.surfaces.size(), 2u);
  EXPECT_LT(farthest_from_surfaces(tube), 1e-9);
  for (const char* angle : {"90", "-90"}) {
    const Solid part =
        Evaluated("rotate_extrude(angle = " + std::string(angle) + ", $fn = 36) " + rectangle)
            .solid();
    expect_solid(part, 5 * (regular_area(36, 5) - regular_area(36, 3)) / 4, angle);
  }
  // From 90 to 180 degrees.
  const Solid late =
      Evaluated("rotate_extrude(angle = 90, start = 90, $fn = 36) " + rectangle).solid();
  expect_solid(late, 5 * (regular_area(36, 5) - regular_area(36, 3)) / 4, "late");
  for (const Vec3& p : late.positions) EXPECT_TRUE(p.x <= 0 && p.y >= 0) << p.x << ' ' << p.y;
}

TEST(Extrusions, ShapesOnTheOtherSideOfTheAxisTurnToo) {
  for (const char* angle : {"360", "100"}) {
    const Solid solid =
        Evaluated("rotate_extrude(angle = " + std::string(angle) +
                  ", $fn = 36) { multmatrix([[1,0,0,-5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { "
                  "square(size = [2, 5], center = false); } }")
            .solid();
    EXPECT_EQ(flaw(solid), "") << angle;
    EXPECT_NEAR(
        volume(solid),
        5 * (regular_area(36, 5) - regular_area(36, 3)) * (angle[0] == '3' ? 1 : 100.0 / 360), 0.5)
        << angle;
    EXPECT_LT(farthest_from_surfaces(solid), 1e-9);
  }
}

TEST(Extrusions, HalfACircleTurnsIntoASphereAndAWholeOneIntoARing) {
  const Solid sphere = Evaluated(
                           "rotate_extrude(angle = 360, $fn = 40) { intersection() { "
                           "circle($fn = 40, r = 4); multmatrix([[1,0,0,0],[0,1,0,-5],[0,0,1,"
                           "0],[0,0,0,1]]) { square(size = [10, 10], center = false); } } }")
                           .solid();
  EXPECT_EQ(flaw(sphere), "");
  EXPECT_NEAR(volume(sphere), 4.0 / 3 * M_PI * 64, 4);
  ASSERT_EQ(sphere.surfaces.size(), 1u);
  EXPECT_EQ(sphere.surfaces[0].profile, Turned::Profile::Circle);
  EXPECT_EQ(sphere.surfaces[0].middle, Vec2(0));
  EXPECT_EQ(tagged_triangles(sphere), sphere.triangles.size());
  EXPECT_LT(farthest_from_surfaces(sphere), 1e-9);
  const Solid ring = Evaluated(
                         "rotate_extrude(angle = 360, $fn = 40) { multmatrix([[1,0,0,9],[0,1,"
                         "0,1],[0,0,1,0],[0,0,0,1]]) { circle($fn = 40, r = 4); } }")
                         .solid();
  EXPECT_EQ(flaw(ring), "");
  // Pappus, with the sine of the polygon for the circle.
  EXPECT_NEAR(volume(ring), regular_area(40, 4) * 9 * 40 * std::sin(2 * M_PI / 40), 0.5);
  ASSERT_EQ(ring.surfaces.size(), 1u);
  EXPECT_EQ(ring.surfaces[0].middle, Vec2(9, 1));
  EXPECT_LT(farthest_from_surfaces(ring), 1e-9);
}

TEST(Extrusions, PointsOnTheAxisAreOneVertex) {
  const std::string kite =
      "{ polygon(points = [[0,0],[2,2],[0,4]], paths = undef, convexity = 1); }";
  const Solid whole = Evaluated("rotate_extrude(angle = 360, $fn = 12) " + kite).solid();
  expect_solid(whole, regular_area(12, 2) * 4 / 3, "two cones");
  EXPECT_EQ(whole.positions.size(), 14u);
  const Solid part = Evaluated("rotate_extrude(angle = 90, $fn = 12) " + kite).solid();
  expect_solid(part, regular_area(12, 2) / 3, "a quarter");
  EXPECT_EQ(part.positions.size(), 6u);
  // A ring whose hole ends in a point of the axis.
  const std::string pinch =
      "{ polygon(points = [[0,2],[3,0],[3,4]], paths = undef, convexity = 1); }";
  EXPECT_EQ(flaw(Evaluated("rotate_extrude(angle = 360, $fn = 12) " + pinch).solid()), "");
  EXPECT_EQ(flaw(Evaluated("rotate_extrude(angle = 90, $fn = 12) " + pinch).solid()), "");
}

TEST(Extrusions, TooFewFragmentsAreMeantFlat) {
  const Solid solid =
      Evaluated("rotate_extrude(angle = 360, $fn = 8) { square(size = [2, 2], center = false); }")
          .solid();
  EXPECT_EQ(tagged_triangles(solid), 0u);
}

}  // namespace
}  // namespace burin::csg::test
