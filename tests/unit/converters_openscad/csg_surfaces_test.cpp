#include "csg_worked.h"
#include "evaluated_part.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

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

// Cuts of rounded corners leave triangles without area. What takes their place stands for what is
// beside it.
TEST(Surfaces, AreThoseOfAllTriangles) {
  const std::string cone = cylinder(62.5, 12.5, 6.25, 12);
  const std::string across =
      "multmatrix([[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]]) { " + cone + " }";
  const Worked w = work_out("difference() { " + sphere(25, 12) + cone + across + "}");
  Diagnostics diagnostics;
  RunContext context;
  const auto form =
      burin::detail::form_of(w.solid, burin::detail::Facets::Known, "", diagnostics, context);
  const auto surface = form->realise({.tolerance = 0.01}, context);
  for (std::uint32_t t = 0; t < surface->proxy().mesh.triangles.size(); ++t) {
    const FaceKind kind = surface->frame(surface->lift({t, Vec3(1.0 / 3)})).kind;
    EXPECT_TRUE(kind == FaceKind::Sphere || kind == FaceKind::Cone) << t;
  }
}

std::size_t grids(const Solid& solid) {
  return static_cast<std::size_t>(std::ranges::count(solid.surfaces, Turned::Profile::Grid,
                                                     [](const Turned& t) { return t.profile; }));
}

const std::string kStar =
    "{ polygon(points = [[20, 0], [7.3, 5.3], [6.2, 19], [-2.8, 8.6], [-16.2, 11.8], [-9, 0], "
    "[-16.2, "
    "-11.8], [-2.8, -8.6], [6.2, -19], [7.3, -5.3]], paths = undef); }";

TEST(Surfaces, TwistedWallsAreSmooth) {
  const Worked w = work_out("linear_extrude(height = 10, twist = 40, slices = 20) " + kStar);
  EXPECT_EQ(grids(w.solid), 10u);
  EXPECT_EQ(tagged_triangles(w.solid), 400u);
  // What is cut off keeps them.
  const Worked half =
      work_out("difference() { linear_extrude(height = 10, twist = 40, slices = 20) " + kStar +
               moved(-50, -50, 5, cube(100, 100, 100)) + "}");
  EXPECT_EQ(grids(half.solid), 10u);
  // One that ends in a point is smooth up to its last slice.
  EXPECT_EQ(grids(work_out("linear_extrude(height = 10, twist = 40, slices = 20, scale = [0, 0]) " +
                           kStar)
                      .solid),
            10u);
  // Steps of more than facets may have are meant.
  EXPECT_EQ(grids(work_out("linear_extrude(height = 10, twist = 180, slices = 3) " + kStar).solid),
            0u);
}

TEST(Surfaces, OfStretchedOutlinesAreSmoothWalls) {
  const std::string ellipse =
      "multmatrix([[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { circle(r = 5, $fn = "
      "48); }";
  const Worked w = work_out("linear_extrude(height = 4) {" + ellipse + "}");
  EXPECT_EQ(grids(w.solid), 1u);
  EXPECT_EQ(tagged_triangles(w.solid), 96u);
  // Circles and rectangles are told as what they are.
  EXPECT_EQ(grids(work_out("linear_extrude(height = 4) { circle(r = 5, $fn = 48); }").solid), 0u);
  EXPECT_EQ(grids(work_out("linear_extrude(height = 4) { square(size = [3, 2]); }").solid), 0u);
}

/// A bar of `sides` bent in a quarter of a circle, as loops in programs write it.
std::string bent_bar(int sides, int rings) {
  std::string points, faces;
  for (int j = 0; j < rings; ++j) {
    const double a = M_PI / 2 * j / (rings - 1);
    for (int i = 0; i < sides; ++i) {
      const double b = 2 * M_PI * i / sides, r = 20 + 3 * std::cos(b);
      points += fmt::format("[{}, {}, {}],", r * std::cos(a), r * std::sin(a), 3 * std::sin(b));
      if (j + 1 == rings) continue;
      const int p = j * sides + i, q = j * sides + (i + 1) % sides;
      faces += fmt::format("[{}, {}, {}], [{}, {}, {}],", p, q, p + sides, q, q + sides, p + sides);
    }
  }
  std::string low, high;
  for (int i = 0; i < sides; ++i) {
    low += fmt::format("{},", sides - 1 - i);
    high += fmt::format("{},", (rings - 1) * sides + i);
  }
  return fmt::format("polyhedron(points = [{}], faces = [{} [{}], [{}]]);", points, faces, low,
                     high);
}

TEST(Surfaces, OfRowsOfPointsAreSmooth) {
  const Worked round = work_out(bent_bar(24, 12));
  EXPECT_EQ(grids(round.solid), 1u);
  EXPECT_EQ(tagged_triangles(round.solid), 24u * 11 * 2);
  // Six sides are meant; each is smooth along, but the two that are planes.
  EXPECT_EQ(grids(work_out(bent_bar(6, 12)).solid), 4u);
}

/// As turns of a thread do that are wider than its pitch.
TEST(Surfaces, ThatLieOnEachOtherKeepTheirFacets) {
  const std::string bar = bent_bar(24, 12);
  EXPECT_EQ(grids(work_out("union() {" + bar + turned(3, bar) + "}").solid), 0u);
  EXPECT_EQ(grids(work_out("difference() {" + bar + turned(3, bar) + "}").solid), 0u);
  // Across each other they cut each other.
  const Worked crossed =
      work_out("union() {" + bar + moved(0, 0, 2, turned(30, cylinder(0.1, 30, 30, 4))) +
               moved(14, 14, -8, cylinder(16, 2, 2, 24)) + "}");
  EXPECT_EQ(grids(crossed.solid), 1u);
}

}  // namespace
}  // namespace burin::csg::test
