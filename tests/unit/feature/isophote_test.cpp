// Lines of equal light against their formulas.

#include <burin/base/parallel.h>
#include <burin/feature/isophotes.h>

#include "feature_support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace burin::test {
namespace {

constexpr double kBall = 10;

std::vector<Curve3> isophotes(const Looked& s, const Isophotes& of) {
  return trace_isophotes(s.proxies[0], 0, of, s.camera, s.context);
}

TEST(Isophotes, OfASphereAreCirclesAboutTheLight) {
  for (const std::uint32_t around : {24u, 64u, 200u}) {
    const Looked s({ellipsoid(Vec3(kBall), around, around / 2)}, {.direction = {1, -1, 1}});
    const Vec3 light = glm::normalize(Vec3(0.2, -0.4, 1));
    for (const double level : {-0.6, 0.1, 0.5, 0.9}) {
      const auto curves = isophotes(s, {3.0 * light, {level}});
      ASSERT_EQ(curves.size(), 1u) << around << ' ' << level;
      const Curve3& c = curves[0];
      EXPECT_TRUE(c.closed);
      EXPECT_FALSE(c.occluding);
      ASSERT_EQ(c.normals.size(), c.points.size());
      ASSERT_EQ(c.faces.size(), c.segment_count());
      ASSERT_EQ(c.self_hidden.size(), c.segment_count());
      const double sagitta = kBall * (1 - std::cos(kPi / around));
      double farthest = 0;
      for (const Vec3& p : c.points) {
        const double lit = glm::dot(glm::normalize(p), light);
        farthest = std::max(farthest, kBall * std::abs(lit - level));
        EXPECT_NEAR(glm::length(p), kBall, 0.3 * sagitta);
      }
      EXPECT_LT(farthest, 0.1 * sagitta) << around << ' ' << level;
      for (std::size_t i = 0; i < c.segment_count(); ++i) {
        const Vec3 m = 0.5 * (c.points[i] + c.points[c.next(i)]);
        if (std::abs(glm::dot(m, s.camera.direction())) < 0.02 * kBall) continue;
        EXPECT_EQ(c.self_hidden[i] == 0, glm::dot(m, s.camera.direction()) > 0);
      }
    }
  }
}

TEST(Isophotes, OfACylinderAreStraightLinesFromRimToRim) {
  const double radius = 4, height = 30;
  const Looked s({cylinder(radius, height, 48)}, {.direction = {1, -1, 1}});
  const Vec3 light(0.6, -0.8, 0);
  const auto curves = isophotes(s, {light, {0.5}});
  ASSERT_EQ(curves.size(), 2u);
  for (const Curve3& c : curves) {
    EXPECT_FALSE(c.closed);
    EXPECT_NEAR(length(c), height, 1e-3 * height);
    for (const Vec3& p : c.points) {
      EXPECT_NEAR(glm::dot(p, light), 0.5 * radius, 2e-3 * radius);
      EXPECT_NEAR(std::hypot(p.x, p.y), radius, 1e-3 * radius);
    }
  }
}

TEST(Isophotes, OfATorusLieOnTheirFormula) {
  const double major = 3, minor = 1;
  const Looked s({torus(major, minor, 120, 60)}, {.direction = {0.3, -1, 1}});
  const Vec3 light = glm::normalize(Vec3(0.5, -0.3, 0.7));
  const auto curves = isophotes(s, {light, even_levels(5)});
  EXPECT_GE(curves.size(), 4u);
  const auto levels = even_levels(5);
  for (const Curve3& c : curves) {
    EXPECT_TRUE(c.closed);
    for (const Vec3& p : c.points) {
      const double r = std::hypot(p.x, p.y);
      const Vec3 ring = major / r * Vec3(p.x, p.y, 0);
      EXPECT_NEAR(glm::distance(p, ring), minor, 2e-3);
      const double lit = glm::dot(glm::normalize(p - ring), light);
      double off = 1;
      for (const double level : levels) off = std::min(off, std::abs(lit - level));
      EXPECT_LT(off, 3e-3);
    }
  }
}

TEST(Isophotes, OfAnOpenSheetAreThoseOfTheSideThatIsSeen) {
  TriMesh half;  // the far half of a tube, seen from inside
  constexpr std::uint32_t kSteps = 40;
  for (std::uint32_t i = 0; i <= kSteps; ++i) {
    const double u = kPi * i / kSteps;
    for (const double z : {0.0, 10.0})
      half.positions.emplace_back(4 * std::cos(u), 4 * std::sin(u), z);
  }
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    half.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 1});
    half.triangles.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
  }
  const Looked s({std::move(half)}, {.direction = {0, -1, 0}});
  const auto curves = isophotes(s, {{0, -1, 0}, {0.5}});
  int seen = 0;
  for (const Curve3& c : curves) {
    if (all_hidden(c)) continue;
    EXPECT_TRUE(none_hidden(c));
    ++seen;
    for (const Vec3& p : c.points) EXPECT_NEAR(p.y, 0.5 * 4, 0.01);
  }
  EXPECT_EQ(seen, 2);
}

TEST(Isophotes, OfAPlaneAtALevelAreNone) {
  const Looked s({box(Vec3(-1), Vec3(1))}, {.direction = {1, -1, 1}});
  EXPECT_TRUE(isophotes(s, {{0.2, -0.3, 1}, even_levels(5)}).empty());
  // All three faces that are seen have this light.
  const double third = 1 / std::sqrt(3.0);
  EXPECT_TRUE(isophotes(s, {{1, -1, 1}, {third + 1e-4}}).empty());
}

TEST(Isophotes, AreTheSameForAnyNumberOfThreads) {
  const Looked s({torus(3, 1, 120, 60)}, {.direction = {0.3, -1, 1}});
  const Isophotes of{{0.5, -0.3, 0.7}, even_levels(4)};
  const auto many = isophotes(s, of);
  const ThreadLimit one(1);
  EXPECT_EQ(many, isophotes(s, of));
}

TEST(Isophotes, StepsAreEvenInTheLight) {
  const Isophotes five{{0, 0, 2}, even_levels(5)};
  EXPECT_EQ(five.levels.size(), 4u);
  EXPECT_EQ(step_of(five, {0, 0, -1}), 0);
  EXPECT_EQ(step_of(five, {0, 0.6, 0.8}), 3);  // at a level: the darker side
  EXPECT_EQ(step_of(five, {0, 0.5, 0.86}), 4);
  EXPECT_EQ(step_of(five, {0, 0, 1}), 4);
  EXPECT_TRUE(even_levels(1).empty());
}

}  // namespace
}  // namespace burin::test
