#include <burin/base/error.h>

#include "flat/origins.h"
#include "flat_trees.h"

#include <gtest/gtest.h>

#include <cmath>

namespace burin::csg::test {
namespace {

constexpr double kExact = 1e-9, kGridShare = 1e-5;

double area_of_polygon(int n, double r) { return 0.5 * n * r * r * std::sin(2 * M_PI / n); }

TEST(FlatShapes, SquareIsWhereItIsSaidToBe) {
  Evaluated tree("square(size = [3, 2], center = true);");
  EXPECT_TRUE(tree.is_flat());
  const Region region = tree.region();
  ASSERT_EQ(region.outlines.size(), 1u);
  EXPECT_EQ(region.outlines[0].points[0], Vec2(-1.5, -1));
  EXPECT_EQ(area(region), 6);
  EXPECT_EQ(tagged_edges(region), 0u);
}

TEST(FlatShapes, CircleHasTheCornersOfItsFragmentsAndKnowsItsArc) {
  for (const int n : {3, 5, 8, 9, 32, 100}) {
    Evaluated tree("circle($fn = " + std::to_string(n) + ", $fa = 12, $fs = 2, r = 7);");
    const Region region = tree.region();
    EXPECT_NEAR(area(region), area_of_polygon(n, 7), kExact) << n;
    EXPECT_EQ(tagged_edges(region), n >= kFewestRound ? static_cast<std::size_t>(n) : 0u);
    EXPECT_LT(farthest_from_arcs(region), kExact);
  }
}

TEST(FlatShapes, CrossingPathsLeaveWhatIsCoveredAnOddNumberOfTimes) {
  Evaluated nested(
      "polygon(points = [[0,0],[10,0],[10,10],[0,10],[2,2],[8,2],[8,8],[2,8],[4,4],[6,4],[6,6],"
      "[4,6]], paths = [[0,1,2,3],[4,5,6,7],[8,9,10,11]], convexity = 1);");
  EXPECT_NEAR(area(nested.region()), 100 - 36 + 4, kExact);
  // A bow tie: two triangles, one of either winding.
  Evaluated bow("polygon(points = [[0,0],[4,4],[4,0],[0,4]], paths = undef, convexity = 1);");
  EXPECT_NEAR(area(bow.region()), 8, 1e-4);
}

TEST(FlatShapes, CombinationsCutAndKeepArcs) {
  Evaluated tree(
      "difference() { square(size = [20, 20], center = true); circle($fn = 64, r = 5); }");
  const Region region = tree.region();
  EXPECT_NEAR(area(region), 400 - area_of_polygon(64, 5), kExact);
  EXPECT_EQ(tagged_edges(region), 64u);
  EXPECT_LT(farthest_from_arcs(region), kExact);
  Evaluated half(
      "intersection() { circle($fn = 64, r = 5); multmatrix([[1,0,0,0],[0,1,0,-5],[0,0,"
      "1,0],[0,0,0,1]]) { square(size = [10, 10], center = false); } }");
  const Region quarter = half.region();
  EXPECT_NEAR(area(quarter), area_of_polygon(64, 5) / 2, kExact);
  EXPECT_EQ(tagged_edges(quarter), 32u);
}

TEST(FlatShapes, OperandsWithoutAreaCountAsInOpenScad) {
  const std::string none = "group();", circle = "circle($fn = 10, r = 1);";
  EXPECT_TRUE(Evaluated("difference() { " + none + circle + " }").region().empty());
  EXPECT_TRUE(Evaluated("intersection() { " + circle + none + " }").region().empty());
  EXPECT_FALSE(Evaluated("difference() { " + circle + none + " }").region().empty());
  EXPECT_FALSE(Evaluated("union() { " + none + circle + " }").region().empty());
  EXPECT_TRUE(Evaluated("minkowski() { " + circle + none + " }").region().empty());
}

TEST(FlatShapes, MirroredAndTurnedCirclesStayRoundAndScaledOnesDoNot) {
  const std::string circle = "{ circle($fn = 20, r = 2); }";
  const Region mirrored =
      Evaluated("multmatrix([[-1,0,0,3],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) " + circle).region();
  EXPECT_NEAR(area(mirrored), area_of_polygon(20, 2), kExact);
  EXPECT_EQ(tagged_edges(mirrored), 20u);
  EXPECT_LT(farthest_from_arcs(mirrored), kExact);
  const Region scaled =
      Evaluated("multmatrix([[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) " + circle).region();
  EXPECT_NEAR(area(scaled), 2 * area_of_polygon(20, 2), kExact);
  EXPECT_EQ(tagged_edges(scaled), 0u);
}

TEST(FlatShapes, OffsetsHaveTheAreaOfTheirCorners) {
  const std::string square = "{ square(size = [10, 10], center = true); }";
  const Region round = Evaluated("offset(r = 2, $fn = 32, $fa = 12, $fs = 2) " + square).region();
  EXPECT_NEAR(area(round), 100 + 80 + area_of_polygon(32, 2), 1e-3);
  EXPECT_EQ(tagged_edges(round), 32u);
  EXPECT_LT(farthest_from_arcs(round), 2.5 / 65536);
  EXPECT_NEAR(area(Evaluated("offset(delta = 2, chamfer = false) " + square).region()), 196, 1e-3);
  EXPECT_NEAR(area(Evaluated("offset(delta = -2, chamfer = false) " + square).region()), 36, 1e-3);
  EXPECT_TRUE(Evaluated("offset(delta = -5, chamfer = false) " + square).region().empty());
}

TEST(FlatShapes, AnOffsetCircleIsACircle) {
  for (const char* rule : {"r = 3", "r = -3", "delta = 3, chamfer = false"}) {
    const Region region = Evaluated("offset(" + std::string(rule) +
                                    ", $fn = 48, $fa = 12, $fs = 2) { circle($fn = 48, r = 8); }")
                              .region();
    std::size_t edges = 0;
    for (const Outline& o : region.outlines) edges += o.points.size();
    EXPECT_EQ(tagged_edges(region), edges) << rule;
    EXPECT_EQ(region.arcs.size(), 1u) << rule;
    EXPECT_LT(farthest_from_arcs(region), 2.5 / 65536) << rule;
  }
}

TEST(FlatShapes, HullsAndSumsKeepTheArcsOfTheirCorners) {
  const std::string apart =
      "{ circle($fn = 40, r = 2); multmatrix([[1,0,0,10],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { "
      "circle($fn = 40, r = 2); } }";
  const Region hull = Evaluated("hull() " + apart).region();
  EXPECT_NEAR(area(hull), area_of_polygon(40, 2) + 40, 1e-6);
  EXPECT_EQ(tagged_edges(hull), 40u);
  EXPECT_EQ(hull.arcs.size(), 2u);
  EXPECT_LT(farthest_from_arcs(hull), kExact);
  const Region sum = Evaluated(
                         "minkowski(convexity = 0) { square(size = [10, 6], center = false); "
                         "circle($fn = 40, r = 2); }")
                         .region();
  EXPECT_NEAR(area(sum), 60 + 2 * 2 * 16 + area_of_polygon(40, 2), 1e-3);
  EXPECT_EQ(tagged_edges(sum), 40u);
  EXPECT_EQ(sum.arcs.size(), 4u);
}

TEST(FlatShapes, ResizeFollowsTheLargestSizeThatIsAskedFor) {
  const std::string square = "{ square(size = [4, 2], center = false); }";
  EXPECT_NEAR(area(Evaluated("resize(newsize = [8,0,0], auto = [0,0,0]) " + square).region()), 16,
              kExact);
  EXPECT_NEAR(area(Evaluated("resize(newsize = [8,0,0], auto = [0,1,0]) " + square).region()), 32,
              kExact);
}

TEST(FlatShapes, ShadowAndCutOfAnExtrusion) {
  const std::string ring =
      "{ multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,-1],[0,0,0,1]]) { linear_extrude(height = 4, scale "
      "= [0.5, 0.5]) { difference() { circle($fn = 60, r = 6); circle($fn = 60, r = 3); } } } }";
  const double whole = area_of_polygon(60, 6) - area_of_polygon(60, 3);
  const Region cut = Evaluated("projection(cut = true, convexity = 0) " + ring).region();
  EXPECT_NEAR(area(cut), whole * 0.875 * 0.875, whole * kGridShare);
  EXPECT_EQ(tagged_edges(cut), 120u);
  const Region shadow = Evaluated("projection(cut = false, convexity = 0) " + ring).region();
  // The hole narrows upwards: what is seen through is its upper end.
  EXPECT_NEAR(area(shadow), area_of_polygon(60, 6) - area_of_polygon(60, 1.5), whole * kGridShare);
  EXPECT_EQ(tagged_edges(shadow), 120u);
}

TEST(FlatShapes, AFaceInThePlaneBelongsToTheCut) {
  Evaluated tree(
      "projection(cut = true, convexity = 0) { linear_extrude(height = 5) { square(size "
      "= [3, 2], center = false); } }");
  EXPECT_NEAR(area(tree.region()), 6, kExact);
}

}  // namespace
}  // namespace burin::csg::test
