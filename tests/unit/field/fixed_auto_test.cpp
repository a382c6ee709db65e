/// The direction that a part's surface nowhere stands on.
#include <burin/field/field.h>
#include <burin/forms/mesh/mesh_form.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace burin {
namespace {

// The direction, from its tangent parts on two planes at a right angle to each other.
Vec3 direction_for(TriMesh mesh, Vec3 usual = {0, 0, 1}) {
  RunContext context;
  const MeshForm form(std::move(mesh));
  const auto surface = form.realise({}, context);
  const Field field = field::fixed_auto({surface.get()}, usual, context);
  const auto part = [&](Vec3 normal) {
    const SurfacePoint point;
    Frame frame;
    frame.normal = normal;
    const auto cross = field.cross({0, point, frame});
    return cross ? cross->first : Vec3(0);
  };
  const Vec3 a = part({0, 0, 1}), b = part({1, 0, 0});  // in the planes z = 0 and x = 0
  if (a == Vec3(0)) return {0, 0, 1};
  if (b == Vec3(0)) return {1, 0, 0};
  // a ~ (x, y, 0), b ~ (0, y, z): the signs of both are those of the direction.
  if (std::abs(a.y) < 1e-9) return glm::normalize(Vec3(a.x, 0, std::abs(b.z) > 0.5 ? b.z : 0));
  return glm::normalize(Vec3(a.x / a.y, 1, b.z / b.y));
}

TEST(FixedAuto, ABoxGetsADiagonal) {
  const Vec3 d = direction_for(test::box({0, 0, 0}, {10, 10, 10}));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(std::abs(d[k]), 1 / std::sqrt(3.0), 0.01);
}

TEST(FixedAuto, ATubeGetsItsAxisAndAClosedOneADirectionBetween) {
  // Normals in all directions across z, and along z: 45 degrees from both.
  const Vec3 d = direction_for(test::cylinder(5, 20, 96));
  EXPECT_GT(std::abs(d.z), 0.4);
  EXPECT_LT(std::abs(d.z), 0.9);
  TriMesh tube = test::cylinder(5, 20, 96);
  std::erase_if(tube.triangles, [&](const Triangle& t) {
    const double z = tube.positions[t[0]].z;
    return tube.positions[t[1]].z == z && tube.positions[t[2]].z == z;
  });
  EXPECT_NEAR(std::abs(direction_for(tube).z), 1, 1e-3);
}

TEST(FixedAuto, WhereAllAreAlikeItIsTheUsualOne) {
  const Vec3 usual = glm::normalize(Vec3(1, 2, 3));
  TriMesh flat;
  flat.positions = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  flat.triangles = {{0, 1, 2}};
  // The plane x = 0 is as far from the usual one, 74 degrees from its normal, as it takes.
  EXPECT_LT(glm::distance(direction_for(flat, usual), usual), 0.01);
}

// A turned part gets the turned direction, as far as there is one that is best.
TEST(FixedAuto, TurnsWithThePart) {
  const Mat3 turn(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6);
  TriMesh prism = test::box({0, 0, 0}, {10, 14, 30});
  TriMesh turned = prism;
  for (Vec3& p : turned.positions) p = turn * p;
  const Vec3 a = glm::abs(direction_for(prism)),
             b = glm::abs(glm::transpose(turn) * direction_for(turned));
  EXPECT_LT(glm::distance(a, b), 0.01);
}

}  // namespace
}  // namespace burin
