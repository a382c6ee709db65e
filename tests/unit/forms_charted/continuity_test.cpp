// Whether surfaces bend alike where they meet.

#include <burin/forms/charted/continuity.h>

#include <gtest/gtest.h>

namespace burin {
namespace {

/// At the origin, normal z, curvature k along a direction turned by `angle` and none across it.
SurfaceDerivatives ruled(double k, double angle, double speed = 1) {
  const double c = std::cos(angle), s = std::sin(angle);
  SurfaceDerivatives d;
  d.u = speed * Vec3(c, s, 0);
  d.v = {-s, c, 0};
  d.uu = speed * speed * Vec3(0, 0, -k);
  return d;
}

constexpr double kSize = 10;
const Vec3 kUp(0, 0, 1);

TEST(BendsAlike, WhateverTheParameters) {
  EXPECT_TRUE(bends_alike(ruled(0.2, 0), kUp, ruled(0.2, 0, 7), kUp, kSize));
  EXPECT_TRUE(bends_alike(ruled(0.2, 0.5), kUp, ruled(0.2, 0.5), kUp, kSize));
  EXPECT_TRUE(bends_alike(ruled(0, 0), kUp, ruled(0, 1), kUp, kSize));  // coplanar
}

TEST(BendsAlike, NotAPlaneAndAFillet) {
  EXPECT_FALSE(bends_alike(ruled(0.2, 0), kUp, ruled(0, 0), kUp, kSize));
  EXPECT_FALSE(bends_alike(ruled(0.2, 0), kUp, ruled(0.21, 0), kUp, kSize));
  EXPECT_FALSE(bends_alike(ruled(0.2, 0), kUp, ruled(0.2, 0.3), kUp, kSize));
}

TEST(BendsAlike, OneAndTheSameAtAnyScale) {
  for (const double scale : {1e-3, 1.0, 1e4}) {
    EXPECT_TRUE(
        bends_alike(ruled(0.2 / scale, 0), kUp, ruled(0.2005 / scale, 0), kUp, kSize * scale));
    EXPECT_FALSE(
        bends_alike(ruled(0.2 / scale, 0), kUp, ruled(0.21 / scale, 0), kUp, kSize * scale));
  }
}

TEST(BendsAlike, PlacesWithoutANormalSayYes) {
  EXPECT_TRUE(bends_alike(ruled(0.2, 0), Vec3(0), ruled(0, 0), kUp, kSize));
}

}  // namespace
}  // namespace burin
