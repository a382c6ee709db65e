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

// Where a contour passes close by vertices its segments are of very different lengths, and those
// before and after tell nothing of how a long one bends: the surface does.
TEST(Rounding, TheContourOfACoarseSphereIsACircleFromAnywhere) {
  const RunContext context;
  const ProxyMesh proxy = build_proxy(test::ellipsoid({20, 20, 20}, 32, 16), {}, context);
  const ProxyMesh* proxies[] = {&proxy};
  const double facet = 40 * (1 - std::cos(test::kPi / 32));
  for (int view = 0; view < 100; ++view) {
    const double turn = 2.39996 * view, rise = 0.0137 * view - 0.7;
    const Camera camera = Camera::fit(
        [](const Mat3&) {
          return Box3{Vec3(-20), Vec3(20)};
        },
        {.direction = {std::cos(turn), std::sin(turn), rise}, .scale = 2});
    Diagnostics diagnostics;
    double worst = 0;
    for (const Curve3& c : extract_features(proxies, camera, {}, diagnostics, context)) {
      for (std::size_t i = 0; i < c.points.size(); ++i) {
        const Vec2 middle =
            0.5 * (camera.to_paper(c.points[i]) + camera.to_paper(c.points[c.next(i)]));
        worst = std::max(worst, std::abs(glm::length(middle - camera.to_paper(Vec3(0))) - 40));
      }
    }
    EXPECT_LT(worst, 0.5 * facet) << view;
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

// The edge of a wing's tip, as it is tessellated: fine round its nose, one long segment where it
// bends the other way. The long one's ends do not turn with the nose.
TEST(Rounding, AnEdgeDoesNotSwingOutBesideShortSegments) {
  const std::vector<Vec2> edge{{178.250, 10.105}, {178.879, 10.012}, {180.008, 10.037},
                               {181.751, 10.308}, {183.698, 10.769}, {199.316, 15.093},
                               {207.028, 17.100}, {215.962, 19.292}};
  ProxyDraft draft;
  for (const Vec2& p : edge) draft.mesh.positions.emplace_back(p, 0);
  for (const Vec2& p : edge) draft.mesh.positions.emplace_back(p.x, p.y + 20, 0);
  const auto n = static_cast<std::uint32_t>(edge.size());
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    draft.mesh.triangles.push_back({i, i + 1, n + i});
    draft.mesh.triangles.push_back({i + 1, n + i + 1, n + i});
  }
  const std::size_t half_edges = 3 * draft.mesh.triangles.size();
  draft.corner_normal.assign(half_edges, Vec3(0, 0, 1));
  draft.sharp.assign(half_edges, 0);
  draft.seam.assign(half_edges, 0);
  draft.source_face.assign(draft.mesh.triangles.size(), 0);
  draft.source_edge.assign(half_edges, -1);
  for (std::size_t h = 0; h < half_edges; h += 6) draft.source_edge[h] = 0;
  draft.tolerance = 0.19;
  const RunContext context;
  const ProxyMesh proxy = assemble_proxy(std::move(draft), context);
  const Camera camera = Camera::fit(
      [](const Mat3&) {
        return Box3{Vec3(178, 10, 0), Vec3(216, 40, 0)};
      },
      {.direction = {0, 0, 1}, .up = {0, 1, 0}, .scale = 1});
  const ProxyMesh* proxies[] = {&proxy};
  Diagnostics diagnostics;
  const Vec2 along = glm::normalize(edge[5] - edge[4]);
  double worst = 0;
  std::size_t between = 0;
  for (const Curve3& c : extract_features(proxies, camera, {}, diagnostics, context)) {
    if (c.source.edge != 0) continue;
    for (const Vec3& p : c.points) {
      if (p.x < edge[4].x || p.x > edge[5].x) continue;
      ++between;
      worst = std::max(worst, std::abs(cross2(along, Vec2(p) - edge[4])));
    }
  }
  EXPECT_GT(between, 2u);
  EXPECT_LT(worst, 0.1);
}

}  // namespace
}  // namespace burin
