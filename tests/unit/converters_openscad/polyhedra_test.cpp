// Polyhedra whose faces have corners of their own: what is closed is so by place.

#include "csg_worked.h"
#include "places.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

namespace burin::csg::test {
namespace {

/// A box of 30 x 20 x 12 mm whose faces share no number of a corner. `at` writes corner k of face
/// f.
template <class At>
std::string box_of_own_corners(const At& at, int faces = 6) {
  constexpr std::array<std::array<int, 4>, 6> kCorners{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}}};
  std::string points, lists;
  for (int f = 0; f < faces; ++f) {
    for (int k = 0; k < 4; ++k) {
      const int c = kCorners[static_cast<std::size_t>(f)][static_cast<std::size_t>(k)];
      points += at(Vec3(30 * (c & 1), 10 * (c & 2), 3 * (c & 4)), f);
    }
    lists += fmt::format("[{}, {}, {}, {}], ", 4 * f + 3, 4 * f + 2, 4 * f + 1, 4 * f);
  }
  return "polyhedron(points = [" + points + "], faces = [" + lists + "], convexity = 1);";
}
std::string as_it_is(Vec3 p, int) { return fmt::format("[{}, {}, {}], ", p.x, p.y, p.z); }

const std::string kPin = moved(15, 10, 0, cylinder(60, 4, 4, 48));  // from -30 to 30
constexpr double kBox = 30 * 20 * 12, kDigits = 1e-5;

void expect_drilled(const std::string& box) {
  const Worked alone = work_out(box);
  EXPECT_NEAR(volume(alone.solid), kBox, kDigits * kBox);
  EXPECT_EQ(open_edges(alone.solid), 0U);
  const Worked cut = work_out("difference() { " + box + kPin + "}");
  EXPECT_NEAR(volume(cut.solid), kBox - 12 * polygon_area(4, 48), kDigits * kBox);
  EXPECT_FALSE(cut.reported("openscad.open_solid"));
  const Worked pin = work_out("union() { " + box + kPin + "}");
  EXPECT_NEAR(volume(pin.solid), kBox + 48 * polygon_area(4, 48), kDigits * kBox);
}

TEST(Polyhedra, WhoseFacesHaveCornersOfTheirOwnAreCutAndUnited) {
  expect_drilled(box_of_own_corners(as_it_is));
}

TEST(Polyhedra, RoundingOfSinesDoesNotOpenThem) {
  // Zero as sines leave it, and what OpenSCAD's own grid joins.
  expect_drilled(box_of_own_corners([](Vec3 p, int f) {
    const double noise = f % 2 == 0 ? 1e-16 : -4e-7;
    return fmt::format("[{}, {}, {}], ", p.x + noise, p.y, p.z - noise);
  }));
}

TEST(Polyhedra, TheSixDigitsOfATreeDoNotOpenThem) {
  // 12.00005 has seven digits: one face rounds it up, another one down.
  expect_drilled(box_of_own_corners([](Vec3 p, int f) {
    return fmt::format("[{}, {}, {}], ", p.x == 0 ? 0 : f % 2 == 0 ? 30 : 30.0001, p.y, p.z);
  }));
}

TEST(Polyhedra, WithoutAFaceAreLeftOutOfCutsAndTold) {
  const std::string open = box_of_own_corners(as_it_is, 5);
  const Worked w = work_out("union() { " + open + kPin + "}");
  EXPECT_NEAR(volume(w.solid), 60 * polygon_area(4, 48), 1e-6);
  EXPECT_TRUE(w.reported("openscad.open_solid"));
}

TEST(Polyhedra, CornersThatFallTogetherMakeNoFace) {
  // The top is a ridge: its two faces at the ends have four corners of which two are one point.
  const std::string roof =
      "polyhedron(points = [[0,0,0],[9,0,0],[9,6,0],[0,6,0], [0,0,0],[9,0,0],[9,3,5],[0,3,5], "
      "[9,6,0],[0,6,0],[0,3,5],[9,3,5], [9,0,0],[9,6,0],[9,3,5],[9,3,5], "
      "[0,6,0],[0,0,0],[0,3,5],[0,3,5]], faces = [[0,1,2,3],[7,6,5,4],[11,10,9,8],[15,14,13,12],"
      "[19,18,17,16]], convexity = 1);";
  const Worked w = work_out("difference() { " + roof + moved(4, -1, -1, cube(1, 9, 9)) + "}");
  EXPECT_NEAR(volume(w.solid), 8 * 15, 1e-9);
  EXPECT_EQ(open_edges(w.solid), 0U);
}

TEST(Places, TheFirstOfAPlaceStandsForAllWithinReach) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1e-7, 0}, {0, 0, -9e-7}, {1, 2e-6, 0}};
  EXPECT_EQ(by_place(points, 1e-6), (std::vector<std::uint32_t>{0, 1, 1, 0, 4}));
  const std::array<std::uint32_t, 2> some{0, 3};
  EXPECT_EQ(by_place(points, some, 1e-6), (std::vector<std::uint32_t>{0, 1, 2, 0, 4}));
  // Places that have no cell stay apart.
  const std::vector<Vec3> far{{1e300, 0, 0}, {1e300, 0, 0}};
  EXPECT_EQ(by_place(far, 1e-6), (std::vector<std::uint32_t>{0, 1}));
}

}  // namespace
}  // namespace burin::csg::test
