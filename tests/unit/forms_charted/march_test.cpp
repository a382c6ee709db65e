// Geodesics of charted surfaces against their truths.

#include <burin_test/charts.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace burin {
namespace {

using test::grid_surface;
using test::kPi;

/// The point at (u,v), found from triangle 0.
SurfacePoint place_at(const Surface& s, Vec2 uv) {
  return s.lift(s.to_proxy({0, Vec3(uv, 0), Vec3(0)}));
}

TEST(ChartedMarch, GreatCirclesOfASphereCrossTheSeamAndClose) {
  const auto s = grid_surface(test::ellipsoid_chart(Vec3(2)), 40, 20);
  for (int i = 0; i < 40; ++i) {
    const SurfacePoint p = place_at(*s, {0.15 * i + 0.01, -1.2 + 0.06 * i});
    const Frame f = s->frame(p);
    EXPECT_NEAR(glm::length(p.position), 2, 1e-12);
    const double a = 0.31 + 0.7 * i;
    const Vec3 t = std::cos(a) * f.d1 + std::sin(a) * f.d2;
    for (const double length : {0.3, 2.0, 4 * kPi}) {
      const MarchStep m = s->march(p, t, length);
      ASSERT_EQ(m.stop, MarchStop::Completed) << i;
      EXPECT_EQ(m.length, length);
      const double w = length / 2;
      const Vec3 truth = std::cos(w) * p.position + 2 * std::sin(w) * t;
      EXPECT_LT(glm::distance(m.end.position, truth), 1e-7) << i << " " << length;
      const Vec3 way = std::cos(w) * t - std::sin(w) * p.position / 2.0;
      EXPECT_LT(glm::distance(m.direction, way), 1e-7);
    }
  }
}

/// A rectangle of a plane; its second triangle has three corners on one line, but for rounding.
std::shared_ptr<const Surface> surface_with_a_flat_triangle() {
  const auto plane = test::plane_chart(Vec2(0), Vec2(9));
  PlacedAtlas atlas{std::make_shared<test::PlainAtlas>(std::vector{plane}), {}, 1};
  const Vec2 a(7.1, 7.83), b(7.7, 7.97), on_line = a + 0.37 * (b - a);
  const std::array<Vec2, 5> corners{
      a, b, {on_line.x, std::nextafter(on_line.y, 0.0)}, {7, 9}, {8, 7}};
  ChartMesh m;
  m.triangles = {{0, 1, 3}, {1, 0, 2}, {2, 0, 4}, {1, 2, 4}};
  for (const Vec2& c : corners) m.positions.push_back({c, 0});
  for (const Triangle& t : m.triangles) {
    for (const std::uint32_t v : t) m.uv.push_back(corners[v]);
  }
  m.face.assign(m.triangles.size(), 0);
  m.border.assign(m.uv.size(), -1);
  m.normal.assign(m.uv.size(), Vec3(0, 0, 1));
  m.on_contour.assign(m.uv.size(), 0);
  return make_charted_surface(std::move(atlas), std::move(m), RunContext());
}

TEST(ChartedSurface, APlaceOnATriangleWithoutAreaIsFoundInIt) {
  const auto s = surface_with_a_flat_triangle();
  for (int i = 1; i < 20; ++i) {
    for (int k = 1; i + k < 20; ++k) {
      EXPECT_EQ(s->to_proxy(s->lift({1, Vec3(i, k, 20 - i - k) / 20.0})).face, 1u);
    }
  }
  // And one that is not on it where it is.
  EXPECT_EQ(s->to_proxy({0, Vec3(7.2, 8.3, 0), Vec3(7.2, 8.3, 0), 1}).face, 0u);
}

TEST(ChartedMarch, AShortStepIsExactTo1e9OfTheSize) {
  const auto s = grid_surface(test::ellipsoid_chart(Vec3(2)), 40, 20);
  for (int i = 0; i < 100; ++i) {
    const SurfacePoint p = place_at(*s, {0.062 * i, -1.4 + 0.028 * i});
    const Frame f = s->frame(p);
    const Vec3 t = std::cos(1.7 * i) * f.d1 + std::sin(1.7 * i) * f.d2;
    const MarchStep m = s->march(p, t, 0.05);
    ASSERT_EQ(m.stop, MarchStop::Completed);
    const Vec3 truth = std::cos(0.025) * p.position + 2 * std::sin(0.025) * t;
    EXPECT_LT(glm::distance(m.end.position, truth), 1e-9 * 7);
  }
}

TEST(ChartedMarch, PathsThatPassNearAPoleSurvive) {
  const auto s = grid_surface(test::ellipsoid_chart(Vec3(1)), 30, 15);
  for (const double miss : {0.1, 1e-2, 1e-3, 1e-4, 1e-6}) {
    // Along a great circle whose nearest place to the pole is `miss` away.
    const SurfacePoint p = place_at(*s, {0.4, 0.9});
    const Vec3 pole(0, 0, 1), side = glm::normalize(glm::cross(pole, p.position));
    const Vec3 target = std::cos(miss) * pole + std::sin(miss) * side;
    const Vec3 t = glm::normalize(reject(target, p.position));
    const MarchStep m = s->march(p, t, 1.5);
    ASSERT_EQ(m.stop, MarchStop::Completed) << miss;
    const Vec3 truth = std::cos(1.5) * p.position + std::sin(1.5) * t;
    EXPECT_LT(glm::distance(m.end.position, truth), 1e-7) << miss;
  }
}

TEST(ChartedMarch, APathIntoAPoleSaysSo) {
  const auto s = grid_surface(test::ellipsoid_chart(Vec3(1)), 30, 15);
  const SurfacePoint p = place_at(*s, {0.4, 0.9});
  const Frame f = s->frame(p);
  const MarchStep m = s->march(p, f.dv, 2);
  EXPECT_EQ(m.stop, MarchStop::Singular);
  EXPECT_NEAR(m.length, kPi / 2 - 0.9, 1e-6);
  EXPECT_LT(glm::distance(m.end.position, Vec3(0, 0, 1)), 1e-6);
}

TEST(ChartedMarch, TorusWrapsBothWaysAndKeepsClairautsConstant) {
  const auto s = grid_surface(test::torus_chart(3, 1), 48, 24);
  // The outer equator closes.
  const SurfacePoint e = place_at(*s, {1.0, 0.0});
  const MarchStep round = s->march(e, Vec3(-std::sin(1.0), std::cos(1.0), 0), 8 * kPi);
  ASSERT_EQ(round.stop, MarchStop::Completed);
  EXPECT_LT(glm::distance(round.end.position, e.position), 1e-7);
  // A meridian closes.
  const MarchStep tube = s->march(e, Vec3(0, 0, 1), 2 * kPi);
  ASSERT_EQ(tube.stop, MarchStop::Completed);
  EXPECT_LT(glm::distance(tube.end.position, e.position), 1e-7);
  // r cos(angle to the parallel) is constant along any geodesic.
  for (int i = 0; i < 20; ++i) {
    const SurfacePoint p = place_at(*s, {0.3 * i, 0.31 * i});
    const Frame f = s->frame(p);
    const Vec3 t = std::cos(0.9 * i) * f.d1 + std::sin(0.9 * i) * f.d2;
    const auto clairaut = [](Vec3 q, Vec3 d) { return q.x * d.y - q.y * d.x; };
    const MarchStep m = s->march(p, t, 30);
    ASSERT_EQ(m.stop, MarchStop::Completed);
    EXPECT_NEAR(clairaut(m.end.position, m.direction), clairaut(p.position, t), 1e-6);
    EXPECT_NEAR(glm::length(m.direction), 1, 1e-9);
  }
}

TEST(ChartedMarch, SeamsThatArePathsThemselvesAreNoObstacle) {
  const auto s = grid_surface(test::torus_chart(3, 1), 48, 24);
  for (const Vec2 uv : {Vec2(1.0, 0.0), Vec2(0.0, 0.7), Vec2(0.0, 0.0), Vec2(0.0, kPi)}) {
    const Frame f = s->frame(place_at(*s, uv));
    for (const Vec3 t : {f.du, f.dv, -f.du, -f.dv}) {
      if (uv.y == 0.7 && std::abs(glm::dot(t, f.du)) > 1) continue;  // no geodesic
      const double turn = std::abs(glm::dot(glm::normalize(t), glm::normalize(f.du))) > 0.5
                              ? 2 * kPi * glm::length(f.du)
                              : 2 * kPi;
      const MarchStep m = s->march(place_at(*s, uv), t, turn);
      ASSERT_EQ(m.stop, MarchStop::Completed);
      EXPECT_LT(glm::distance(m.end.position, f.position), 1e-6);
    }
  }
}

TEST(ChartedMarch, BoundariesStopExactly) {
  const auto s = grid_surface(test::cylinder_chart(2, 5), 24, 6);
  for (int i = 0; i < 30; ++i) {
    const SurfacePoint p = place_at(*s, {0.2 * i, 1 + 0.1 * i});
    const double a = 0.4 + 0.08 * i;  // a helix that climbs
    const Vec3 t = std::cos(a) * glm::normalize(s->frame(p).du) + std::sin(a) * Vec3(0, 0, 1);
    const MarchStep m = s->march(p, t, 100);
    ASSERT_EQ(m.stop, MarchStop::Boundary);
    EXPECT_NEAR(m.end.position.z, 5, 1e-12);
    EXPECT_NEAR(m.length, (5 - p.position.z) / std::sin(a), 1e-8);
    EXPECT_NEAR(m.direction.z, std::sin(a), 1e-8);
    // On from there: no step outwards, and the way back is open.
    EXPECT_EQ(s->march(m.end, m.direction, 1).stop, MarchStop::Boundary);
    EXPECT_NEAR(s->march(m.end, m.direction, 1).length, 0, 1e-9);
    const MarchStep back = s->march(m.end, -m.direction, m.length);
    EXPECT_EQ(back.stop, MarchStop::Completed);
    EXPECT_LT(glm::distance(back.end.position, p.position), 1e-7);
  }
}

TEST(ChartedMarch, PlanesAreCrossedInOneStepWhateverTheirSize) {
  for (const double size : {1e-3, 1.0, 1e4}) {
    const auto s = grid_surface(test::plane_chart(Vec2(0), Vec2(size, 2 * size)), 20, 30);
    SurfacePoint p{0, Vec3(0.11 * size, 0.13 * size, 0), Vec3(0)};
    p.triangle = s->to_proxy(p).face;
    const Vec3 t = glm::normalize(Vec3(1, 1.7, 0.4));
    const Vec3 flat = glm::normalize(Vec3(1, 1.7, 0));
    const MarchStep m = s->march(p, t, 0.7 * size);
    EXPECT_EQ(m.stop, MarchStop::Completed);
    EXPECT_LT(glm::distance(m.end.position, Vec3(0.11, 0.13, 0) * size + 0.7 * size * flat),
              1e-12 * size);
    const MarchStep end = s->march(p, t, 10 * size);
    EXPECT_EQ(end.stop, MarchStop::Boundary);
    EXPECT_NEAR(end.end.position.x, size, 1e-12 * size);
  }
}

TEST(ChartedMarch, APlacementThatMirrorsAndScalesKeepsThePath) {
  Placement place;
  place.linear = Mat3(3, 0, 0, 0, -3, 0, 0, 0, 3);
  place.offset = {1e4, -2e4, 5};
  const auto a = grid_surface(test::torus_chart(3, 1), 48, 24);
  const auto b = grid_surface(test::torus_chart(3, 1), 48, 24, place);
  for (int i = 0; i < 20; ++i) {
    const SurfacePoint p = place_at(*a, {0.3 * i, 0.31 * i}), q = place_at(*b, {0.3 * i, 0.31 * i});
    const Frame f = a->frame(p), g = b->frame(q);
    EXPECT_LT(glm::distance(g.normal, Vec3(f.normal.x, -f.normal.y, f.normal.z)), 1e-12);
    const Vec3 t = std::cos(0.9 * i) * f.d1 + std::sin(0.9 * i) * f.d2;
    const MarchStep m = a->march(p, t, 6), n = b->march(q, place.vector(t), 18);
    ASSERT_EQ(n.stop, MarchStop::Completed);
    EXPECT_LT(glm::distance(n.end.position, place.point(m.end.position)), 1e-6);
  }
}

}  // namespace
}  // namespace burin
