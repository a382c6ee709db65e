// MODEL: trimmed surfaces whose loops share their curves.
#include "reading.h"

#include <cmath>
#include <numbers>

namespace burin {
namespace {

using std::numbers::pi;
using test::expect_error;

PartInfo info_of(const std::string& bytes) {
  const test::TempFile file("a.itd", bytes);
  RunContext context;
  const FileInfo info = inspect_irit(file.path(), context);
  EXPECT_EQ(info.parts.size(), 1u);
  return info.parts.at(0);
}

/// Corners of the circle of nine points: a weight, the middle plus `r` times the corner.
template <class Write>
std::string nine(const Write& write) {
  std::string text;
  for (int i = 0; i <= 8; ++i) {
    const double w = i % 2 == 0 ? 1 : std::sqrt(0.5), a = i * pi / 4;
    text += write(w, std::cos(a), std::sin(a));
  }
  return text;
}

const std::string kKnots = "[KV 0 0 0 1 1 2 2 3 3 4 4 4]";

std::string cap(double z) {
  return fmt::format("[SURFACE BEZIER 2 2 E3 [-2 -2 {0}] [2 -2 {0}] [-2 2 {0}] [2 2 {0}]]", z);
}

std::string wall() {
  std::string text = "[SURFACE BSPLINE 9 2 3 2 P3 " + kKnots + " [KV 0 0 1 1]";
  for (const int z : {0, 1}) {
    text += nine([&](double w, double x, double y) {
      return fmt::format(" [{} {} {} {}]", w, x, y, w * z);
    });
  }
  return text + "]";
}

/// The circle on a cap, and the side of the wall that it goes along.
std::string border(int on_cap, int v, double radius) {
  std::string text = fmt::format("[MDLTSEG 7 {} 2\n[CURVE BSPLINE 9 3 P2 ", on_cap) + kKnots;
  text += nine([radius](double w, double x, double y) {
    return fmt::format(" [{} {} {}]", w, 0.5 * w + 0.25 * radius * x, 0.5 * w + 0.25 * radius * y);
  });
  return text + fmt::format(
                    "]\n[CURVE BSPLINE 5 2 E2 [KV 0 0 1 2 3 4 4] [0 {0}] [1 {0}] [2 {0}] [3 "
                    "{0}] [4 {0}]]\n[CURVE BEZIER 2 E3 [0 0 0] [1 1 1]]]\n",
                    v);
}

/// A cylinder of radius 1 and height 1: floor, wall, lid, borders 1 and 2, the seam 3.
std::string cylinder(const std::string& wall_loop = "1 3 -2 -3", const std::string& lid_loop = "2",
                     double radius = 1) {
  return "[OBJECT CAN [MODEL 3 3\n[MDLTSRF 1 " + cap(0) + " [MDLLOOP -1]]\n[MDLTSRF 1 " + wall() +
         "\n[MDLLOOP " + wall_loop + "]]\n[MDLTSRF 1 " + cap(1) + "\n[MDLLOOP " + lid_loop +
         "]]\n" + border(1, 0, radius) + border(3, 1, radius) +
         "[MDLTSEG 3 2 2 [CURVE BEZIER 2 E2 [4 0] [4 1]] [CURVE BEZIER 2 E2 [0 0] [0 1]]]\n]]\n";
}

TEST(IritModel, FacesShareTheirBorders) {
  const PartInfo info = info_of(cylinder());
  EXPECT_EQ(info.name, "CAN");
  EXPECT_EQ(info.faces, 3);
  EXPECT_EQ(info.edges, 3);
  EXPECT_EQ(info.boundary_edges, 0);
  EXPECT_NEAR(info.area / (4 * pi), 1, 1e-6);
  EXPECT_NEAR(info.volume / pi, 1, 1e-6);
}

TEST(IritModel, BordersThatRunApartAreOneEdge) {
  // Circles on floor and lid within a thousandth of the size of the wall's ends, and beyond.
  EXPECT_EQ(info_of(cylinder("1 3 -2 -3", "2", 0.9985)).boundary_edges, 0);
  EXPECT_EQ(info_of(cylinder("1 3 -2 -3", "2", 0.99)).boundary_edges, 4);
}

TEST(IritModel, InstancesMove) {
  const test::TempFile file(
      "a.itd", cylinder() + "[OBJECT B [INSTANCE CAN 2 0 0 0 0 2 0 0 0 0 2 0 50 0 0 1]]");
  RunContext context;
  const FileInfo info = inspect_irit(file.path(), context);
  ASSERT_EQ(info.parts.size(), 2u);
  EXPECT_NEAR(info.parts[1].area / (16 * pi), 1, 1e-6);
  EXPECT_NEAR(info.parts[1].bounds.min.x, 48, 1e-3);
}

TEST(IritModel, Errors) {
  expect_error(cylinder("1 3 -2 -4"), 4,
               "column 2: this loop names segment -4, the model has 1 to 3");
  expect_error(cylinder("1 3 -2 0"), 4, "names segment 0");
  expect_error(cylinder("1 3 -2 -3", "1"), 6, "names segment 1, which has no curve on surface 3");
  expect_error(cylinder("1 3 -2"), 4, "it does not close");
  expect_error(cylinder("1 3 x"), 4, "column 14: 'x' is not the number of a segment");
  expect_error("[OBJECT A [MODEL 2 0 [MDLTSRF 0 " + cap(0) + "]]]", 1, "is not the [MDLTSRF");
  expect_error("[OBJECT A [MODEL 1 -1 [MDLTSRF 0 " + cap(0) + "]]]", 1, "segments is negative");
  expect_error("[OBJECT A [MODEL 1 1 [MDLTSRF 0 " + cap(0) + "] [MDLTSEG 8 1 0]]]", 1,
               "is a number from 1 to 7");
  std::string many;
  for (int i = 0; i < 600'000; ++i) many += " 1";
  expect_error(cylinder("1 3 -2 -3", "2" + many), 6, "which has no curve");
  std::string turns;
  for (int i = 0; i < 600'000; ++i) turns += " 2";
  expect_error(cylinder("1 3 -2 -3", "2" + turns), 6, "more than 5000000 points");
}

}  // namespace
}  // namespace burin
