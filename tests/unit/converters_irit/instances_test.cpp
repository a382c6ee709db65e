// Objects that stand at other places once more.
#include <burin/forms/mesh/mesh_form.h>

#include "reading.h"

#include <algorithm>

namespace burin {
namespace {

using test::expect_error;
using test::square;

const std::string kUnit = " 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1";

std::string object(const std::string& name, const std::string& inside) {
  return "[OBJECT " + name + "\n" + inside + "]\n";
}

std::string instance(const std::string& of, const std::string& matrix) {
  return "[INSTANCE " + of + " " + matrix + "]";
}

/// A quarter of a cylinder of radius 1, by z up to 1.
std::string quarter(const std::string& name) {
  return object(name,
                "[SURFACE BEZIER 3 2 P3 [1 1 0 0] [0.7071067811865476 0.7071067811865476 "
                "0.7071067811865476 0] [1 0 1 0] [1 1 0 1] [0.7071067811865476 0.7071067811865476 "
                "0.7071067811865476 0.7071067811865476] [1 0 1 1]]");
}

const Chart& patch(const Scene& scene, std::size_t part) {
  return *test::patches_of(scene.parts.at(part)).at(0);
}

template <class Move>
void expect_moved(const std::string& matrix, const Move& move) {
  const Scene scene = test::scene_of(quarter("A") + object("B", instance("A", matrix)));
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(scene.parts[1].name, "B");
  for (double u = 0; u <= 1; u += 0.125) {
    for (double v = 0; v <= 1; v += 0.25) {
      test::expect_near(patch(scene, 1).position({u, v}), move(patch(scene, 0).position({u, v})),
                        1e-14);
    }
  }
}

TEST(IritInstances, PointsAreRowsToTheLeftOfTheMatrix) {
  // x to y, y to 2 z, z to -x, then the last row.
  expect_moved("0 1 0 0  0 0 2 0  -1 0 0 0  5 6 7 1",
               [](Vec3 p) { return Vec3(5 - p.z, 6 + p.x, 7 + 2 * p.y); });
  // The last number scales all.
  expect_moved("1 0 0 0  0 1 0 0  0 0 1 0  2 0 0 4",
               [](Vec3 p) { return Vec3(p.x + 2, p.y, p.z) / 4.0; });
}

TEST(IritInstances, PerspectiveChangesTheWeights) {
  // Apart from the original, for sides that fit would join them.
  expect_moved("1 0 0 0  0 1 0 0  0 0 1 0.5  9 0 0 1",
               [](Vec3 p) { return (p + Vec3(9, 0, 0)) / (1 + 0.5 * p.z); });
}

TEST(IritInstances, PolygonsMove) {
  const Scene scene =
      test::scene_of(object("A", "[POLYGON 3 [0 0 0] [2 0 0] [0 2 0]]") +
                     object("B", instance("A", "1 0 0 0  0 1 0 0  0 0 1 0  0 0 3 1")));
  ASSERT_EQ(scene.parts.size(), 2u);
  for (const Vec3& p : dynamic_cast<const MeshForm&>(*scene.parts[1].form).mesh().positions) {
    EXPECT_EQ(p.z, 3);
  }
}

TEST(IritInstances, OfListsAndOfInstancesBeforeTheyAreThere) {
  const Scene scene =
      test::scene_of(object("C", instance("B", "1 0 0 0  0 1 0 0  0 0 1 0  0 0 1 1")) +
                     object("B", instance("L", "2 0 0 0  0 2 0 0  0 0 2 0  10 0 0 1")) +
                     object("L", object("P", square({0, 0, 0})) + object("Q", square({5, 0, 0}))));
  ASSERT_EQ(scene.parts.size(), 6u);
  EXPECT_EQ(scene.parts[0].assembly, std::vector<std::string>{"C"});
  EXPECT_EQ(scene.parts[0].name, "P");
  EXPECT_EQ(scene.parts[3].assembly, std::vector<std::string>{"B"});
  EXPECT_EQ(scene.parts[3].name, "Q");
  test::expect_near(patch(scene, 1).position({1, 1}), {22, 2, 1}, 1e-14);
  test::expect_near(patch(scene, 3).position({0, 0}), {20, 0, 0}, 1e-14);
}

TEST(IritInstances, ColoursAndInvisibleOriginals) {
  const Scene scene = test::scene_of(
      object("[INVISIBLE 1] A", square({0, 0, 0})) + object("[COLOR 4] RED", square({0, 9, 0})) +
      object("[COLOR 2] B", instance("A", kUnit)) +
      object("[RGB \"0,0,255\"] D", instance("RED", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 9 1")) +
      object("[INVISIBLE 1] E", instance("RED", kUnit)));
  ASSERT_EQ(scene.parts.size(), 3u);
  EXPECT_EQ(scene.parts[1].name, "B");
  EXPECT_EQ(scene.parts[1].color, "#00aa00");
  EXPECT_EQ(scene.parts[2].name, "D");
  EXPECT_EQ(scene.parts[2].color, "#aa0000");
}

TEST(IritInstances, AMatrixBesideObjectsMovesNothing) {
  const Scene scene =
      test::scene_of(object("L", object("VIEW_MAT", "[MATRIX 9 0 0 0 0 9 0 0 0 0 9 0 9 9 9 1]") +
                                     object("A", square({0, 0, 0}))));
  ASSERT_EQ(scene.parts.size(), 1u);
  test::expect_near(patch(scene, 0).position({1, 1}), {1, 1, 0}, 0);
}

TEST(IritInstances, WithoutAnOriginalAreTold) {
  const Scene scene =
      test::scene_of(object("A", square({0, 0, 0})) + object("B", instance("NOBODY", kUnit)));
  ASSERT_EQ(scene.parts.size(), 1u);
  ASSERT_EQ(scene.diagnostics.entries().size(), 1u);
  const Diagnostic& reported = scene.diagnostics.entries()[0];
  EXPECT_EQ(reported.code, "irit.no_original");
  EXPECT_EQ(reported.severity, Severity::Warning);
  EXPECT_EQ(reported.message,
            "INSTANCE of NOBODY was left out: the file has no object of that name; the first on "
            "line 5");
  expect_error(object("B", instance("NOBODY", kUnit)), 2, "only 1 INSTANCE of NOBODY");
}

TEST(IritInstances, OfThemselvesAreRefused) {
  expect_error(object("A", square({0, 0, 0}) + instance("A", kUnit)), 3,
               "column 2: 'A' is an instance of itself");
  expect_error(object("A", instance("B", kUnit)) + object("B", " " + instance("A", kUnit)), 4,
               "column 3: 'A' is an instance of itself");
  expect_error(object("L", object("A", instance("L", kUnit))), 3, "'L' is an instance of itself");
}

TEST(IritInstances, ThatMultiplyAreRefused) {
  std::string text = object("A0", square({0, 0, 0}));
  for (int i = 1; i < 60; ++i) {
    const std::string of = instance(fmt::format("A{}", i - 1), kUnit);
    text += object(fmt::format("A{}", i), object("X", of) + object("Y", of));
  }
  expect_error(text, 60, "make more than 5000000 control points");
  std::string chain = object("A0", square({0, 0, 0}));
  for (int i = 1; i < 100000; ++i) {
    chain += object(fmt::format("A{}", i), instance(fmt::format("A{}", i - 1), kUnit));
  }
  const Scene low =
      test::scene_of(object("A0", square({0, 0, 0})) + object("A1", instance("A0", kUnit)));
  EXPECT_EQ(low.parts.size(), 1u);  // sides fit: one part
  expect_error(chain, 1, "more than 400 deep in each other");
}

TEST(IritInstances, Damaged) {
  const std::string a = object("A", square({0, 0, 0}));
  expect_error(a + object("B", "[INSTANCE A 1 2 3]"), 5, "']' is not a number of the matrix");
  expect_error(a + object("B", "[INSTANCE]"), 5, "']' is not the name of an object");
  expect_error(a + object("B", instance("A", kUnit + " 1")), 5, "after the matrix");
  expect_error(
      a + object("B", instance("A", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 0")), 5,
      "column 2: the instance of 'A' cannot be drawn: its matrix sends points to infinity");
  expect_error(a + object("B", instance("A", "1 0 0 -1 0 1 0 0 0 0 1 0 0 0 0 1")), 5,
               "sends points to infinity");
  expect_error(a + object("B", instance("A", "1e99 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1")), 5,
               "absurdly large");
}

}  // namespace
}  // namespace burin
