#include "csg_worked.h"

#include <gtest/gtest.h>

#include <set>

namespace burin::csg::test {
namespace {

// Of mm: what doubles and six digits leave.
constexpr double kOnSurface = 1e-9;

TEST(Surfaces, OfADrilledBlockHoldAllTheirCorners) {
  const Worked w = work_out("difference() { " + moved(-5, -5, -5, cube(10, 10, 10)) +
                            cylinder(30, 2, 2, 32) + "}");
  EXPECT_EQ(w.solid.surfaces.size(), 1u);
  EXPECT_EQ(tagged_triangles(w.solid), 64u);
  EXPECT_LT(farthest_from_surfaces(w.solid), kOnSurface);
  // Its triangles look at the axis.
  for (std::size_t t = 0; t < w.solid.triangles.size(); ++t) {
    if (w.solid.surface[t] < 0) continue;
    const auto& c = w.solid.triangles[t];
    const Vec3 a = w.solid.positions[c[0]], b = w.solid.positions[c[1]],
               d = w.solid.positions[c[2]];
    const Vec3 n = glm::cross(b - a, d - a), middle = (a + b + d) / 3.0;
    EXPECT_LT(n.x * middle.x + n.y * middle.y, 0);
  }
}

TEST(Surfaces, FollowTurnsMirrorsAndUniformScales) {
  const std::string parts[] = {turned(33, moved(3, 1, 2, cylinder(4, 1, 2, 20))),
                               scaled(-2, 2, 2, moved(3, 1, 2, sphere(2, 20))),
                               scaled(3, 3, 1, cylinder(4, 1, 1, 20))};
  for (const std::string& part : parts) {
    const Worked w = work_out(part);
    EXPECT_EQ(w.solid.surfaces.size(), 1u) << part;
    EXPECT_GT(tagged_triangles(w.solid), 0u) << part;
    EXPECT_LT(farthest_from_surfaces(w.solid), kOnSurface) << part;
    EXPECT_GT(volume(w.solid), 0) << part;
  }
}

TEST(Surfaces, AreDroppedWhereCirclesDoNotStayCircles) {
  EXPECT_EQ(tagged_triangles(work_out(scaled(1, 2, 1, cylinder(4, 1, 1, 20))).solid), 0u);
  EXPECT_EQ(tagged_triangles(work_out(scaled(1, 1, 2, sphere(1, 20))).solid), 0u);
}

TEST(Surfaces, EightCornersMeanAPrism) {
  EXPECT_EQ(tagged_triangles(work_out(cylinder(4, 1, 1, 8)).solid), 0u);
  EXPECT_EQ(tagged_triangles(work_out(cylinder(4, 1, 1, 9)).solid), 18u);
}

TEST(Surfaces, ReachTheResultOfCutsAndUnions) {
  // A ball with a shaft through it and a flat side.
  const Worked w = work_out("difference() { union() { " + sphere(5, 48) + cylinder(20, 2, 2, 48) +
                            "} " + moved(-10, -10, 3, cube(20, 20, 20)) + "}");
  std::set<Turned::Profile> kinds;
  for (const Turned& t : w.solid.surfaces) kinds.insert(t.profile);
  EXPECT_EQ(kinds.size(), 2u);
  // Corners that a cut makes within a facet lie up to its arrow inside of the surface.
  const double arrow = 5 * (1 - std::cos(M_PI / 48)) * 2;
  EXPECT_LT(farthest_from_surfaces(w.solid), arrow);
  // The flat side, the caps of the shaft and what is cut off: nothing of them is round.
  for (std::size_t t = 0; t < w.solid.triangles.size(); ++t) {
    const auto& c = w.solid.triangles[t];
    const bool flat = w.solid.positions[c[0]].z == 3 && w.solid.positions[c[1]].z == 3 &&
                      w.solid.positions[c[2]].z == 3;
    EXPECT_TRUE(!flat || w.solid.surface[t] == -1);
  }
}

}  // namespace
}  // namespace burin::csg::test
