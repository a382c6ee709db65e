#include <burin/field/field.h>

#include <burin_test/fields.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

using test::Probe;

TEST(FixedField, IsTheTangentPartOfItsDirection) {
  const auto s = test::realised(test::ellipsoid({1, 1, 1}, 60, 40), false);
  const Field f = field::fixed({0, 0, 3});
  int steep = 0;
  for (const Probe& p : test::probes(*s)) {
    const auto d = test::direction(f, p.query());
    if (!d) {
      ++steep;
      EXPECT_GT(std::abs(p.frame.normal.z), 0.999);
      continue;
    }
    EXPECT_NEAR(glm::length(*d), 1, 1e-12);
    EXPECT_NEAR(glm::dot(*d, p.frame.normal), 0, 1e-12);
    EXPECT_LT(glm::distance(*d, glm::normalize(reject(Vec3(0, 0, 1), p.frame.normal))), 1e-12);
    const auto second = test::direction(f, p.query(2));
    EXPECT_NEAR(glm::dot(*d, *second), 0, 1e-12);
    EXPECT_NEAR(glm::dot(*second, *test::direction(f, p.query(1, *second * 0.8 + *d * 0.1))), 1,
                1e-12);
    EXPECT_NEAR(glm::dot(*d, *test::direction(f, p.query(1, -*d))), -1, 1e-12);
  }
  EXPECT_LT(steep, 10);
}

TEST(PrincipalField, OnACylinder) {
  const auto s = test::realised(test::cylinder(2, 5, 48));
  const Field f = field::principal();
  int sides = 0, caps = 0;
  for (const Probe& p : test::probes(*s)) {
    const auto d = test::direction(f, p.query());
    if (std::abs(p.frame.normal.z) > 0.5) {
      ++caps;
      EXPECT_FALSE(d) << "a flat cap has no principal directions";
      continue;
    }
    ++sides;
    ASSERT_TRUE(d);
    const Vec3 around = glm::normalize(glm::cross(Vec3(0, 0, 1), p.frame.normal));
    EXPECT_LT(test::line_angle(*d, around), 1e-6);
    EXPECT_LT(test::line_angle(*test::direction(f, p.query(2)), {0, 0, 1}), 1e-6);
    EXPECT_LT(test::direction(f, p.query(1, {0.1, 0, -1}))->z, -0.99);
  }
  EXPECT_GT(sides, 90);
  EXPECT_GT(caps, 90);
}

TEST(PrincipalField, OnATorusFamilyOneRunsAroundTheTube) {
  const auto s = test::realised(test::torus(3, 1, 180, 80));
  const Field f = field::principal();
  const test::ExactSurface exact = test::exact_torus(3, 1);
  for (const Probe& p : test::probes(*s, 3)) {
    const auto d = test::direction(f, p.query());
    ASSERT_TRUE(d);
    const test::ExactFrame e = exact(p.point.position);
    EXPECT_LT(test::line_angle(*d, e.d1), 1);
    EXPECT_NEAR(p.frame.k1, 1, 0.01);
    EXPECT_NEAR(p.frame.k2, e.k2, 0.01);
  }
}

}  // namespace
}  // namespace burin
