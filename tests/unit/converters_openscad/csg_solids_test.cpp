#include <burin/base/error.h>

#include "csg_worked.h"

#include <gtest/gtest.h>

#include <cmath>

namespace burin::csg::test {
namespace {

constexpr double kRelative = 1e-12;

void expect_volume(const std::string& text, double expected) {
  const Worked w = work_out(text);
  EXPECT_NEAR(volume(w.solid), expected, kRelative * (1 + std::abs(expected))) << text;
  EXPECT_EQ(open_edges(w.solid), 0u) << text;
}

TEST(Primitives, HaveTheVolumesOfTheirPolygons) {
  expect_volume(cube(2, 3, 4), 24);
  expect_volume(cylinder(7, 3, 3, 30), 7 * polygon_area(3, 30));
  expect_volume(cylinder(6, 3, 0, 12), 2 * polygon_area(3, 12));
  expect_volume(cylinder(6, 0, 3, 12), 2 * polygon_area(3, 12));
  expect_volume(cylinder(3, 2, 1, 5), polygon_area(1, 5) * (4 + 2 + 1));
  expect_volume(sphere(5, 24), sphere_volume(5, 24));
  expect_volume(sphere(5, 5), sphere_volume(5, 5));
}

TEST(Primitives, OfNoSizeAreNothing) {
  for (const char* text :
       {"cube(size = [0, 1, 1], center = false);", "cube(size = [-1, 1, 1], center = false);",
        "cube(size = [inf, 1, 1], center = false);", "sphere($fn = 0, $fa = 12, $fs = 2, r = 0);",
        "cylinder($fn = 9, $fa = 12, $fs = 2, h = 0, r1 = 1, r2 = 1, center = false);",
        "cylinder($fn = 9, $fa = 12, $fs = 2, h = 1, r1 = 0, r2 = 0, center = false);",
        "hull() { }", "difference() { }", "minkowski(convexity = 0) { }", "intersection();",
        "polyhedron(points = undef, faces = [[0, 1, 2]], convexity = 1);"}) {
    EXPECT_TRUE(work_out(text).solid.empty()) << text;
  }
}

TEST(Cuts, OfSimpleSolidsAreExact) {
  expect_volume(
      "difference() { " + moved(-5, -5, -5, cube(10, 10, 10)) + cylinder(30, 2, 2, 32) + "}",
      1000 - 10 * polygon_area(2, 32));
  expect_volume(cube(10, 10, 10) + moved(5, 5, 5, cube(10, 10, 10)), 2000 - 125);
  expect_volume("intersection() { " + cube(10, 10, 10) + moved(5, 5, 5, cube(10, 10, 10)) + "}",
                125);
  // Three bars crossing in the middle of a cube leave eight corners, or a frame.
  const std::string bars = moved(-9, 2, 2, cube(30, 6, 6)) + moved(2, -9, 2, cube(6, 30, 6)) +
                           moved(2, 2, -9, cube(6, 6, 30));
  expect_volume("difference() { " + cube(10, 10, 10) + bars + "}", 1000 - 3 * 360 + 2 * 216);
  expect_volume("intersection() { " + cube(10, 10, 10) + "union() { " + bars + "} }",
                3 * 360 - 2 * 216);
}

TEST(Cuts, OfWhatLiesWithinAnotherSolidAreExact) {
  const std::string outer = moved(-5, -5, -5, cube(10, 10, 10));
  const std::string ball = sphere(4, 128), second = moved(0.5, 0, 0, cube(2, 2, 2));
  // Whole solids within one: strictly, on its surface, and the same one twice at other places of
  // the text, in a union and in what is cut off.
  expect_volume(outer + ball + second + moved(3, -5, -5, cube(2, 10, 10)), 1000);
  expect_volume("union() { " + moved(-5, -5, -5, "union() { " + cube(10, 10, 10) + "}") +
                    moved(-6, -5, -5, moved(1, 0, 0, cube(10, 10, 10))) + "}",
                1000);
  expect_volume(
      "difference() { " + moved(-9, -9, -9, cube(18, 18, 18)) + outer + ball + second + "}",
      18 * 18 * 18 - 1000);
  // What is solid within what is cut off comes to nothing; what is cut out of the first alone
  // stays.
  expect_volume(
      "difference() { union() { " + moved(-9, -9, -9, cube(18, 18, 18)) + ball + "}" + outer + "}",
      18 * 18 * 18 - 1000);
  expect_volume("difference() { " + outer + ball + "}" + second, 1000 - sphere_volume(4, 128) + 8);
  expect_volume("intersection() { " + outer + ball + "}", sphere_volume(4, 128));
}

TEST(Cuts, OfWhatLiesWithinASolidThatIsNotConvexAreExact) {
  // A star seen whole from its middle, and an L that is seen whole from its corner alone.
  // Only cuts of many facets are looked at for what lies within: a ball makes them many.
  const std::string ball = moved(0, 0, 2, sphere(1, 128));
  const std::string star =
      "linear_extrude(height = 4, center = false, convexity = 1, scale = [1, 1]) { polygon(points "
      "= [[9, 0], [2, 2], [0, 9], [-2, 2], [-9, 0], [-2, -2], [0, -9], [2, -2]], paths = undef, "
      "convexity = 1); }";
  const double area = 4 * 2 * 9;
  expect_volume(star + ball + moved(-1, -1, 1, cube(2, 2, 2)), 4 * area);
  expect_volume(star + ball + moved(3, 3, 1, cube(2, 2, 2)), 4 * area + 8);
  expect_volume(star + ball + moved(-1, -1, 1, cube(2, 2, 4)), 4 * area + 4);
  const std::string ell =
      "linear_extrude(height = 4, center = false, convexity = 1, scale = [1, 1]) { polygon(points "
      "= [[0, 0], [9, 0], [9, 3], [3, 3], [3, 9], [0, 9]], paths = undef, convexity = 1); }";
  expect_volume(ell + moved(1.5, 1.5, 0, ball) + moved(1, 1, 1, cube(1, 1, 1)), 4 * 45);
  expect_volume(ell + moved(1.5, 1.5, 0, ball) + moved(1, 1, 1, cube(7, 1, 1)), 4 * 45);
  expect_volume(ell + moved(1.5, 1.5, 0, ball) + moved(1, 1, 1, cube(7, 7, 1)), 4 * 45 + 25);
}

TEST(Cuts, OfManyHullsAlongALineAgreeWithTheTube) {
  // Rods that follow each other on one line, each within the next ones for the most part.
  std::string rods;
  for (int i = 0; i < 40; ++i) rods += moved(0, 0, 0.5 * i, cylinder(6, 3, 3, 120));
  expect_volume(rods, (6 + 0.5 * 39) * polygon_area(3, 120));
  expect_volume("difference() { " + moved(-9, -9, 1, cube(18, 18, 18)) + rods + "}",
                18 * 18 * 18 - 18 * polygon_area(3, 120));
}

TEST(Cuts, ThatTouchAreOneWhereverTheyStand) {
  // Corners of both are rounded on their own: by one bit apart where it is moved by 4.01.
  for (const double z : {4.01, 8.01, 0.1, 1.7}) {
    const Worked w = work_out(moved(0, 0, z, cube(6, 6, 12) + moved(0, 0, 12, cube(6, 6, 4))));
    EXPECT_EQ(w.cuts, 1u) << z;
    EXPECT_EQ(w.solid.triangles.size(), 12u) << z;
  }
}

TEST(Cuts, MayStandWithinEachOther) {
  // A - (B - (C - D)), boxes in boxes.
  const auto box = [](double inset) {
    return moved(inset, inset, inset, cube(20 - 2 * inset, 20 - 2 * inset, 20 - 2 * inset));
  };
  expect_volume("difference() { " + box(0) + "difference() { " + box(1) + "difference() { " +
                    box(3) + box(6) + "} } }",
                8000 - (5832 - (2744 - 512)));
  std::string deep = box(0);
  for (int i = 0; i < 1000; ++i)
    deep = "difference() { " + deep + moved(i % 20, 0, 0, cube(0.25, 1, 1)) + "}";
  expect_volume(deep, 8000 - 20 * 0.25);
}

struct Contact {
  const char* name;
  std::string text;
  double volume;
  /// Edges with more than two triangles.
  std::size_t shared = 0;
};

class Contacts : public ::testing::TestWithParam<Contact> {};

TEST_P(Contacts, AreClosedAndOfTheRightVolume) {
  const Worked w = work_out(GetParam().text);
  EXPECT_NEAR(volume(w.solid), GetParam().volume, 1e-11 * (1 + GetParam().volume));
  EXPECT_EQ(open_edges(w.solid), 0u);
  EXPECT_EQ(shared_edges(w.solid), GetParam().shared);
  EXPECT_TRUE(w.diagnostics.empty());
}

std::string turned_pair() { return turned(31, cube(1, 1, 1) + moved(1, 0, 0, cube(1, 1, 1))); }

const Contact kContacts[] = {
    {"cubes_on_a_face", cube(1, 1, 1) + moved(1, 0, 0, cube(1, 1, 1)), 2},
    {"cubes_on_part_of_a_face", cube(1, 1, 1) + moved(1, 0.25, 0.25, cube(1, 0.5, 0.5)), 1.25},
    {"cubes_on_a_face_turned", turned_pair(), 2},
    {"cubes_on_an_edge", cube(1, 1, 1) + moved(1, 1, 0, cube(1, 1, 1)), 2, 1},
    {"cubes_on_a_corner", cube(1, 1, 1) + moved(1, 1, 1, cube(1, 1, 1)), 2},
    {"intersection_of_touching_cubes",
     "intersection() { " + cube(1, 1, 1) + moved(1, 0, 0, cube(1, 1, 1)) + "}", 0},
    {"less_itself", "difference() { " + cube(1, 1, 1) + cube(1, 1, 1) + "}", 0},
    {"sphere_less_itself", "difference() { " + sphere(3, 24) + sphere(3, 24) + "}", 0},
    {"sphere_and_itself", sphere(3, 24) + sphere(3, 24), sphere_volume(3, 24)},
    {"flush_bottoms", "difference() { " + cube(4, 4, 4) + moved(1, 1, 0, cube(2, 2, 2)) + "}", 56},
    {"two_bars_left_on_an_edge",
     "difference() { " + cube(2, 2, 5) + moved(1, 1, 0, cube(1, 1, 5)) + cube(1, 1, 5) + "}", 10,
     1},
    {"cylinders_tangent_along_an_edge",
     cylinder(2, 1, 1, 32) + moved(2, 0, 0, cylinder(2, 1, 1, 32)), 4 * polygon_area(1, 32), 1},
    {"hole_tangent_to_four_walls",
     "difference() { " + moved(-1, -1, -1, cube(2, 2, 2)) + cylinder(2, 1, 1, 32) + "}",
     8 - 2 * polygon_area(1, 32), 4},
    {"decimals_that_meet", moved(0.1, 0, 0, cube(0.2, 1, 1)) + moved(0.3, 0, 0, cube(0.1, 1, 1)),
     0.3},
};

INSTANTIATE_TEST_SUITE_P(Csg, Contacts, ::testing::ValuesIn(kContacts),
                         [](const auto& i) { return std::string(i.param.name); });

TEST(Contacts, FacesThatGoOnBecomeOne) {
  EXPECT_EQ(work_out(cube(1, 1, 1) + moved(1, 0, 0, cube(1, 1, 1))).solid.triangles.size(), 12u);
  EXPECT_EQ(work_out(turned_pair()).solid.triangles.size(), 12u);
  EXPECT_EQ(work_out(moved(0.1, 0, 0, cube(0.2, 1, 1)) + moved(0.3, 0, 0, cube(0.1, 1, 1)))
                .solid.triangles.size(),
            12u);
}

TEST(Trees, BackgroundIsLeftOutBelowAndEvaluatedWhenAskedFor) {
  const std::string text = "union() { " + cube(1, 1, 1) + "%" + moved(0, 0, 5, cube(2, 2, 2)) + "}";
  EXPECT_NEAR(volume(work_out(text).solid), 1, kRelative);
  EXPECT_NEAR(volume(work_out(text, 3).solid), 8, kRelative);
}

TEST(Trees, EmptyFirstOperandsLeaveNothingEmptyOthersDoNotCount) {
  EXPECT_TRUE(work_out("difference() { group(); " + cube(1, 1, 1) + "}").solid.empty());
  EXPECT_TRUE(work_out("intersection() { " + cube(1, 1, 1) + "group(); }").solid.empty());
  expect_volume("difference() { " + cube(1, 1, 1) + "group(); }", 1);
  expect_volume("union() { group(); " + cube(1, 1, 1) + "}", 1);
}

TEST(Trees, HullsAndSums) {
  expect_volume("hull() { " + cube(1, 1, 1) + moved(4, 0, 0, cube(1, 1, 1)) + "}", 5);
  EXPECT_TRUE(work_out("hull() { polyhedron(points = [[0,0,0],[1,0,0],[0,1,0]], faces = [[0,1,2]], "
                       "convexity = 1); }")
                  .solid.empty());
  expect_volume("minkowski(convexity = 0) { " + cube(3, 2, 1) + cube(1, 1, 1) + "}", 4 * 3 * 2);
  // A plate with a hole, grown by a cube: the hole shrinks by as much.
  const std::string plate =
      "difference() { " + cube(10, 10, 1) + moved(3, 3, -1, cube(4, 4, 3)) + "}";
  expect_volume("minkowski(convexity = 0) { " + plate + cube(1, 1, 1) + "}", (121 - 9) * 2);
}

// Where corners lie in one plane or line, an algorithm may take any triangles of them.
TEST(Trees, HullsAreTheSameWhateverTheOrderOfTheirCorners) {
  const std::vector<std::string> parts = {
      cube(9, 9, 9), moved(3, 3, 0, cube(3, 3, 9)), moved(20, 0, 0, cube(9, 9, 9)),
      moved(8, 0, 2, cube(4, 9, 7)), moved(14, 4, 4, sphere(4, 24))};
  std::string forth, back;
  for (const std::string& part : parts) {
    forth += part;
    back = part + back;
  }
  const Solid one = work_out("hull() { " + forth + "}").solid;
  const Solid other = work_out("hull() { " + back + "}").solid;
  EXPECT_EQ(one.positions, other.positions);
  EXPECT_EQ(one.triangles, other.triangles);
  EXPECT_EQ(one.positions.size(), 8u);
  EXPECT_EQ(one.triangles.size(), 12u);
}

TEST(Trees, SumsOfHollowSolidsStayHollow) {
  const auto middle = [](double a) { return moved(-a / 2, -a / 2, -a / 2, cube(a, a, a)); };
  const std::string hollow = "difference() { " + middle(19) + middle(11) + "}";
  expect_volume("minkowski(convexity = 0) { " + hollow + middle(1) + "}", 8000 - 1000);
  // What comes to nothing does not count.
  const std::string nothing =
      "intersection() { " + cube(1, 1, 1) + moved(5, 0, 0, cube(1, 1, 1)) + "}";
  expect_volume("minkowski(convexity = 0) { " + nothing + cube(2, 1, 1) + "}", 2);
}

TEST(Trees, FlatChildrenOfCutsCountAsNothing) {
  const std::string flat = "square(size = [1, 1], center = false);";
  EXPECT_TRUE(work_out("intersection() { " + cube(1, 1, 1) + flat + "}").solid.empty());
  const Worked w = work_out("difference() { " + cube(1, 1, 1) + flat + "}");
  EXPECT_NEAR(volume(w.solid), 1, kRelative);
  EXPECT_TRUE(w.reported("openscad.mixed_dimensions"));
}

TEST(Trees, ResizedAsOpenScadDoes) {
  expect_volume(
      "resize(newsize = [20,0,0], auto = [0,0,0], convexity = 0) { " + cube(10, 2, 2) + "}", 80);
  expect_volume(
      "resize(newsize = [20,0,0], auto = [1,1,1], convexity = 0) { " + cube(10, 2, 2) + "}", 320);
}

TEST(Trees, MirrorsTurnTrianglesOver) {
  expect_volume(scaled(-1, 1, 1, "difference() { " + cube(4, 4, 4) + cylinder(20, 1, 1, 16) + "}"),
                64 - 4 * polygon_area(1, 16) / 4);
  EXPECT_TRUE(work_out(scaled(0, 1, 1, cube(1, 1, 1))).solid.empty());
}

TEST(Trees, WhatIsNoSolidIsLeftOutAndTold) {
  const std::string open =
      "polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1]], convexity "
      "= 1);";
  const Worked w = work_out("union() { " + moved(-1, -1, -1, cube(3, 3, 3)) + open + "}");
  EXPECT_NEAR(volume(w.solid), 27, 1e-10);
  EXPECT_TRUE(w.reported("openscad.open_solid"));
  const Worked n =
      work_out(cube(1, 1, 1) + "multmatrix([[nan,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { " +
               cube(1, 1, 1) + "}");
  EXPECT_NEAR(volume(n.solid), 1, kRelative);
  EXPECT_TRUE(n.reported("openscad.not_finite"));
}

TEST(Trees, PolyhedraThatCutThemselvesAreCutThere) {
  // Two cubes in one polyhedron, overlapping: what an odd number of skins holds.
  std::string points, faces;
  for (int c = 0; c < 2; ++c) {
    for (int i = 0; i < 8; ++i) {
      const double s = c * 0.5;
      points += "[" + std::to_string((i & 1) + s) + "," + std::to_string((i >> 1 & 1) + s) + "," +
                std::to_string((i >> 2 & 1) + s) + "],";
    }
    const int quads[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                             {1, 5, 7, 3}, {3, 7, 6, 2}, {2, 6, 4, 0}};
    for (const auto& q : quads) {
      faces += "[";
      for (const int v : q) faces += std::to_string(v + 8 * c) + ",";
      faces.back() = ']';
      faces += ",";
    }
  }
  points.pop_back();
  faces.pop_back();
  const std::string both =
      "polyhedron(points = [" + points + "], faces = [" + faces + "], convexity = 2);";
  expect_volume("union() { " + both + moved(1.25, 1.25, 1.25, cube(0.5, 0.5, 0.5)) + "}",
                2 - 2 * 0.125 + 0.125 - 0.25 * 0.25 * 0.25);
}

TEST(Cuts, OfManyBoxesTurnedOnOneFloorStayCheap) {
  // All their walls meet the floor of all others: without joining them that is millions of pairs.
  std::string text;
  for (int i = 0; i < 40; ++i) text += turned(i * 90.0 / 40, moved(-5, -5, 0, cube(10, 10, 2)));
  const Worked w = work_out(text);
  EXPECT_EQ(open_edges(w.solid), 0u);
  // Nearly the cylinder through the corners; at least the one that touches all sides.
  EXPECT_GT(volume(w.solid), M_PI * 25 * 2);
  EXPECT_LT(volume(w.solid), polygon_area(5 * std::sqrt(2.0), 160) * 2);
}

TEST(Trees, SameTextGivesTheSameBytes) {
  const std::string text = "difference() { " + sphere(5, 30) + cylinder(20, 2, 2, 24) +
                           moved(1, 1, 0, turned(17, cube(9, 9, 9))) + "}";
  const Solid a = work_out(text).solid, b = work_out(text).solid;
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.surface, b.surface);
}

TEST(Trees, CirclesOfABillionCornersAreRefusedByLine) {
  try {
    work_out(cube(1, 1, 1) + "\n" + "sphere($fn = 1e9, $fa = 12, $fs = 2, r = 1);");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(e.file(), "test.csg");
    EXPECT_EQ(e.line(), 3);
  }
}

}  // namespace
}  // namespace burin::csg::test
