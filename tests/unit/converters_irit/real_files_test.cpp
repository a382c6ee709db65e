// Patch models that others made.
#include <burin/base/box.h>
#include <burin/base/rng.h>

#include "reading.h"

#include <burin_test/shapes.h>

#include <array>

namespace burin {
namespace {

Scene real(const std::string& name) {
  const RunContext context;
  return read_irit(test::data(name), context);
}

bool absent(const std::string& name) { return !std::filesystem::exists(test::data(name)); }

/// Directions that the hull of points is looked at from: a point of the hull lies, in each, no
/// farther than the farthest of them.
std::vector<Vec3> directions() {
  const Rng rng(5);
  std::vector<Vec3> all = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Vec3 d(rng.uniform(3 * i) - 0.5, rng.uniform(3 * i + 1) - 0.5,
                 rng.uniform(3 * i + 2) - 0.5);
    all.push_back(glm::normalize(d));
  }
  return all;
}

/// Patches of positive weights lie in the hull of their points.
void expect_in_hull(const Chart& chart) {
  const NurbsData* data = nurbs_data(chart);
  ASSERT_NE(data, nullptr);
  Box3 box;
  for (const Vec3& p : data->points) box.add(p);
  const double tolerance = 1e-14 * (box.diagonal() + glm::length(box.center()));
  for (const Vec3& d : directions()) {
    double low = 1e300, high = -1e300;
    for (const Vec3& p : data->points) {
      low = std::min(low, glm::dot(p, d));
      high = std::max(high, glm::dot(p, d));
    }
    for (int i = 0; i <= 10; ++i) {
      for (int j = 0; j <= 10; ++j) {
        const double x = glm::dot(chart.position({i / 10.0, j / 10.0}), d);
        EXPECT_GE(x, low - tolerance);
        EXPECT_LE(x, high + tolerance);
      }
    }
  }
}

TEST(RealPatches, GeomviewTeapot) {
  const std::string name = "nurbs/geomview/teapot.bez";
  if (absent(name)) GTEST_SKIP() << "no " << name;
  const Scene scene = real(name);
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "teapot");
  EXPECT_EQ(test::patches_of(scene.parts[0]).size(), 28u);
  for (const auto& patch : test::patches_of(scene.parts[0])) expect_in_hull(*patch);
}

TEST(RealPatches, GeomviewTorusIsExact) {
  const std::string name = "nurbs/geomview/torus.bez";
  if (absent(name)) GTEST_SKIP() << "no " << name;
  const Scene scene = real(name);
  // Four patches of half by half a turn, with points at infinity: each is split into four.
  const auto& patches = test::patches_of(scene.parts[0]);
  EXPECT_EQ(patches.size(), 16u);
  for (const auto& patch : patches) {
    expect_in_hull(*patch);
    for (double u = 0; u <= 1; u += 0.25) {
      for (double v = 0; v <= 1; v += 0.25) {
        const Vec3 p = patch->position({u, v});
        // About y: the circle of radius 0.5 at 1 from the axis, by the file's own points.
        EXPECT_NEAR(std::hypot(std::hypot(p.x, p.z) - 1, p.y), 0.5, 1e-14);
      }
    }
  }
}

TEST(RealPatches, GeomviewOctantIsASphere) {
  const std::string name = "nurbs/geomview/octant.bez";
  if (absent(name)) GTEST_SKIP() << "no " << name;
  const Scene scene = real(name);
  const auto& patches = test::patches_of(scene.parts[0]);
  ASSERT_EQ(patches.size(), 1u);
  expect_in_hull(*patches[0]);
  for (double u = 0; u <= 1; u += 0.125) {
    EXPECT_NEAR(glm::length(patches[0]->position({u, 0.3})), 1, 1e-14);
  }
}

TEST(RealPatches, TeapotOfNewell) {
  const std::string name = "nurbs/teapot/teapot_newell.txt";
  if (absent(name)) GTEST_SKIP() << "no " << name;
  const Scene scene = real(name);
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "teapot_newell");
  const auto& patches = test::patches_of(scene.parts[0]);
  EXPECT_EQ(patches.size(), 28u);
  for (const auto& patch : patches) expect_in_hull(*patch);
  // The rim: a quarter of a turn, by the first row of points.
  const Vec3 a = patches[0]->position({0, 0}), b = patches[0]->position({0, 1});
  EXPECT_NEAR(std::hypot(a.x, a.z), std::hypot(b.x, b.z), 1e-12);
  EXPECT_NEAR(glm::dot(a, b), a.y * b.y, 1e-12);
}

}  // namespace
}  // namespace burin
