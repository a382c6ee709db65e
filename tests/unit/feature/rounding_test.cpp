// Contours of coarse meshes lie on the smooth surface, not on its facets.
#include <burin/feature/feature.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

TEST(Rounding, TheContourOfACoarseSphereIsACircle) {
  const RunContext context;
  for (const std::uint32_t n : {16u, 24u, 48u}) {
    const ProxyMesh proxy = build_proxy(test::ellipsoid({20, 20, 20}, 2 * n, n), {}, context);
    const Camera camera = Camera::fit(
        [](const Mat3&) {
          return Box3{Vec3(-20), Vec3(20)};
        },
        {.direction = {1, -2, 0.7}, .scale = 2});
    const ProxyMesh* proxies[] = {&proxy};
    Diagnostics diagnostics;
    const auto curves = extract_features(proxies, camera, {}, diagnostics, context);
    ASSERT_EQ(curves.size(), 1u);
    const Curve3& c = curves[0];
    EXPECT_TRUE(c.closed);
    EXPECT_EQ(c.faces.size(), c.points.size());
    EXPECT_EQ(c.normals.size(), c.points.size());
    EXPECT_EQ(c.self_hidden.size(), c.points.size());
    double worst = 0, turn = 0;
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      const Vec2 at = camera.to_paper(c.points[i]), next = camera.to_paper(c.points[c.next(i)]);
      worst = std::max(worst, std::abs(glm::length(at - camera.to_paper(Vec3(0))) - 40));
      turn = std::max(turn, glm::length(next - at));
    }
    // The facets themselves lie up to 40 (1 - cos(pi / 2n)) mm inside the circle: 0.19 mm for 16
    // rings.
    const double facet = 40 * (1 - std::cos(test::kPi / (2 * n)));
    EXPECT_LT(worst, 0.25 * facet) << n;
    EXPECT_LT(turn, 2.0)
        << n;  // and no chord of it shows: a chord of 2 mm has a sagitta of 0.0125 mm
  }
}

TEST(Rounding, ContoursThatEndOnCreasesKeepTheirEndPoints) {
  const RunContext context;
  const ProxyMesh proxy = build_proxy(test::cylinder(10, 30, 48), {}, context);
  const Camera camera = Camera::fit(
      [](const Mat3&) {
        return Box3{Vec3(-15), Vec3(15)};
      },
      {.scale = 2});
  const ProxyMesh* proxies[] = {&proxy};
  Diagnostics diagnostics;
  for (const Curve3& c : extract_features(proxies, camera, {}, diagnostics, context)) {
    if (c.kind != LineClass::Contour || c.source.edge >= 0) continue;
    // The contour of a cylinder is straight: nothing to round off, all of it on the facets.
    for (const Vec3& p : c.points) {
      EXPECT_LT(glm::length(glm::cross(p - c.points.front(), Vec3(0, 0, 1))), 1e-6);
    }
  }
}

}  // namespace
}  // namespace burin
