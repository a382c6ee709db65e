// Splines whose parametrisation breaks at knots of full multiplicity, where the surface is smooth.

#include <burin/forms/charted/refine.h>
#include <burin/forms/patches/parametric_form.h>

#include <burin_test/nurbs_shapes.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

/// A torus of radii 10 and 3 whose quarters run at speeds of 1, 4, 1, 4 round the axis: the same
/// surface as with even knots, but Su jumps at three lines (and at the seam).
std::shared_ptr<const Surface> uneven_torus(double tolerance) {
  NurbsData data = test::torus_nurbs(10, 3);
  data.knots_u = {0, 0, 0, 1, 1, 5, 5, 6, 6, 10, 10, 10};
  RunContext context;
  return ParametricForm({make_nurbs_chart(data)}).realise({.tolerance = tolerance}, context);
}

SurfacePoint at(const Surface& s, Vec2 uv) { return s.lift(s.to_proxy({0, Vec3(uv, 0), Vec3(0)})); }

TEST(BreakLines, TakeNoMoreTrianglesThanTheSurfaceNeeds) {
  RunContext context;
  const auto even = ParametricForm({make_nurbs_chart(test::torus_nurbs(10, 3))})
                        .realise({.tolerance = 0.01}, context);
  const auto uneven = uneven_torus(0.01);
  EXPECT_LE(uneven->proxy().tolerance, 0.021);
  EXPECT_LT(uneven->proxy().mesh.triangles.size(), 2 * even->proxy().mesh.triangles.size());
}

TEST(BreakLines, MarchesPassThemAsIfTheyWereNotThere) {
  const auto s = uneven_torus(0.05);
  const double size = std::sqrt(26 * 26 * 2 + 36.0);
  // Clairaut: on a surface of revolution x dy - y dx keeps its value along a geodesic.
  const auto clairaut = [](Vec3 p, Vec3 d) { return p.x * d.y - p.y * d.x; };
  for (int i = 0; i < 24; ++i) {
    const SurfacePoint p = at(*s, {0.4 * i + 0.07, 0.16 * i + 0.03});
    const Frame f = s->frame(p);
    const Vec3 t = std::cos(0.9 * i) * f.d1 + std::sin(0.9 * i) * f.d2;
    SurfacePoint end = p;
    Vec3 way = t;
    // As strokes go: in short steps. And back again.
    for (int step = 0; step < 100; ++step) {
      const MarchStep m = s->march(end, way, 0.4);
      ASSERT_EQ(m.stop, MarchStop::Completed) << i << " " << step;
      end = m.end;
      way = m.direction;
    }
    EXPECT_NEAR(clairaut(end.position, way), clairaut(p.position, t), 2e-6 * size) << i;
    const double tube = std::hypot(std::hypot(end.position.x, end.position.y) - 10, end.position.z);
    EXPECT_NEAR(tube, 3, 1e-9 * size);
    const MarchStep back = s->march(end, -way, 40);
    ASSERT_EQ(back.stop, MarchStop::Completed) << i;
    EXPECT_LT(glm::distance(back.end.position, p.position), 3e-5 * size) << i;
  }
}

TEST(BreakLines, MarchesAlongThemStayOnThem) {
  const auto s = uneven_torus(0.05);
  for (const double u : {1.0, 5.0, 6.0}) {
    const SurfacePoint p = at(*s, {u, 0.3});
    const MarchStep m = s->march(p, s->frame(p).dv, 3 * std::numbers::pi);
    ASSERT_EQ(m.stop, MarchStop::Completed) << u;
    // Half way round a meridian.
    const double angle = std::atan2(p.position.y, p.position.x);
    EXPECT_NEAR(std::atan2(m.end.position.y, m.end.position.x), angle, 1e-6);
    EXPECT_NEAR(m.end.position.z, -p.position.z, 1e-6);
  }
}

TEST(TriangleBound, GoesWithTheSheetAndEndsSomewhere) {
  // 200 mm of paper at 0.05 mm: 2,500 a cm2 of a square of 100 mm.
  EXPECT_EQ(triangle_bound(200, 0.05), 250'000u);
  EXPECT_EQ(triangle_bound(200e3, 0.05e3), 250'000u);
  EXPECT_EQ(triangle_bound(280, 0.05), 490'000u);
  EXPECT_EQ(triangle_bound(1, 0.05), 100'000u);
  EXPECT_EQ(triangle_bound(200, 1e-9), 600'000u);
}

}  // namespace
}  // namespace burin
