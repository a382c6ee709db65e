#include <burin/base/error.h>
#include <burin/forms/charted/nurbs.h>

#include <burin_test/exact.h>
#include <burin_test/nurbs_shapes.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

Vec3 normal_at(const Chart& chart, Vec2 uv) {
  return chart_normal(chart.derivatives(uv), false, uv, chart.domain().center());
}

TEST(ChartNormal, PolesOfASphere) {
  const auto chart = make_nurbs_chart(test::sphere_nurbs(5));
  for (const double u : {0.0, 0.3, 1.0, 2.7, 4.0}) {
    EXPECT_LT(glm::distance(normal_at(*chart, {u, 0}), Vec3(0, 0, -1)), 1e-14);
    EXPECT_LT(glm::distance(normal_at(*chart, {u, 2}), Vec3(0, 0, 1)), 1e-14);
    for (const double e : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
      const Vec3 p = chart->position({u, e});
      EXPECT_LT(glm::distance(normal_at(*chart, {u, e}), p / 5.0), 2e-8) << e;
    }
  }
}

TEST(ChartNormal, TipOfAConeIsThatOfEachRuling) {
  const auto chart = make_nurbs_chart(test::cone_nurbs(2, 0, 2), FaceKind::Cone);
  for (const double u : {0.0, 0.4, 1.7, 3.1}) {
    EXPECT_LT(glm::distance(normal_at(*chart, {u, 1}), normal_at(*chart, {u, 0.5})), 1e-14);
  }
}

/// z = x y over patches whose corner is degenerate: the normal at the origin is (0, 0, 1).
TEST(ChartNormal, DegenerateCorners) {
  const auto saddle = [](double x, double y) { return Vec3(x, y, x * y); };
  struct Case {
    const char* name;
    std::function<Vec3(Vec2)> position;
    double sign;
  };
  const std::vector<Case> cases = {
      {"side collapsed in u", [&](Vec2 t) { return saddle(t.y * t.x, t.y * (1 - t.x)); }, 1},
      {"side collapsed in v", [&](Vec2 t) { return saddle(t.x * t.y, t.x * (1 - t.y)); }, -1},
      {"Su = 0 in a corner", [&](Vec2 t) { return saddle(t.x * t.x + t.x * t.y, t.y); }, 1},
      {"both partials vanish",
       [&](Vec2 t) { return saddle(t.x * t.x + t.x * t.y, t.y * t.y + t.x * t.y); }, 1},
      {"parallel partials", [&](Vec2 t) { return saddle(t.x - t.y, (t.x + t.y) * (t.x + t.y)); },
       1},
  };
  for (const Case& c : cases) {
    const auto chart = make_function_chart(c.position, {.domain = {Vec2(0), Vec2(1)}});
    const SurfaceDerivatives d = chart->derivatives({0, 0});
    const Vec3 n = chart_normal(d, false, {0, 0}, {0.5, 0.5});
    EXPECT_LT(glm::distance(n, Vec3(0, 0, c.sign)), 1e-6) << c.name;
    EXPECT_LT(glm::distance(chart_normal(d, true, {0, 0}, {0.5, 0.5}), -n), 1e-15) << c.name;
  }
}

TEST(ChartNormal, NoneWhereThereIsNone) {
  SurfaceDerivatives d;
  EXPECT_EQ(chart_normal(d, false, {0, 0}, {1, 1}), Vec3(0));
  d.v = Vec3(1, 0, 0);
  d.uv = Vec3(2, 0, 0);
  EXPECT_EQ(chart_normal(d, false, {0, 0}, {1, 1}), Vec3(0));
  const Frame f = chart_frame(d, Vec3(0), FaceKind::Freeform, 1);
  EXPECT_TRUE(f.umbilic);
  EXPECT_EQ(f.confidence, 0);
  EXPECT_NEAR(glm::length(f.d1), 1, 1e-15);
}

TEST(ChartFrame, EllipsoidAgreesWithItsImplicitForm) {
  const Vec3 half(5, 3, 2);
  NurbsData data = test::sphere_nurbs(1);
  for (Vec3& p : data.points) p *= half;
  const auto chart = make_nurbs_chart(data);
  const auto exact = test::exact_ellipsoid(half);
  const Rng rng(1);
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Vec2 uv(4 * rng.uniform(2 * i), 0.01 + 1.98 * rng.uniform(2 * i + 1));
    const SurfaceDerivatives d = chart->derivatives(uv);
    const Frame f = chart_frame(d, normal_at(*chart, uv), FaceKind::Freeform, 10);
    const test::ExactFrame e = exact(d.p);
    EXPECT_LT(glm::distance(f.normal, e.normal), 1e-11);
    EXPECT_NEAR(f.k1, e.k1, 1e-9);
    EXPECT_NEAR(f.k2, e.k2, 1e-9);
    if (f.confidence > 0.01) {
      EXPECT_NEAR(std::abs(glm::dot(f.d1, e.d1)), 1, 1e-9);
    }
    EXPECT_NEAR(glm::length(f.d1), 1, 1e-14);
    EXPECT_NEAR(glm::dot(f.d1, f.normal), 0, 1e-14);
  }
}

TEST(ChartFrame, DirectionsDoNotDependOnTheParameters) {
  // A cylinder in skewed parameters: rulings and circles come out all the same.
  const auto chart = make_function_chart(
      [](Vec2 t) {
        const double a = t.x + 3 * t.y;
        return Vec3(2 * std::cos(a), 2 * std::sin(a), t.y - 0.2 * t.x);
      },
      {.domain = {Vec2(0), Vec2(1)}});
  for (const Vec2 uv : {Vec2(0.5), Vec2(0.1, 0.9), Vec2(0), Vec2(1, 0.001)}) {
    const SurfaceDerivatives d = chart->derivatives(uv);
    const Vec3 outward = glm::normalize(Vec3(d.p.x, d.p.y, 0));
    const Frame f = chart_frame(d, outward, FaceKind::Cylinder, 4);
    EXPECT_NEAR(f.k1, 0.5, 1e-6);
    EXPECT_EQ(f.k2, 0);
    EXPECT_NEAR(std::abs(f.d2.z), 1, 1e-9);
    EXPECT_EQ(f.confidence, 1);
  }
}

TEST(ChartFrame, SpheresAndPlanesAreUmbilic) {
  const auto sphere = make_nurbs_chart(test::sphere_nurbs(4));
  const Rng rng(2);
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Vec2 uv(4 * rng.uniform(2 * i), 0.01 + 1.98 * rng.uniform(2 * i + 1));
    const Frame f =
        chart_frame(sphere->derivatives(uv), normal_at(*sphere, uv), FaceKind::Freeform, 8);
    EXPECT_TRUE(f.umbilic);
    EXPECT_EQ(f.confidence, 0);
    EXPECT_NEAR(f.k1, 0.25, 1e-9);
  }
  const auto bent = make_function_chart([](Vec2 t) { return Vec3(t.x, t.y, 1e-4 * t.x * t.x); },
                                        {.domain = {Vec2(0), Vec2(1)}});
  const Frame f = chart_frame(bent->derivatives(Vec2(0.5)), Vec3(0, 0, 1), FaceKind::Freeform, 1);
  EXPECT_TRUE(f.umbilic);
  EXPECT_EQ(f.k2, 0);
}

TEST(TangentComponents, GiveTheTangentBack) {
  const auto chart = make_nurbs_chart(test::random_nurbs(3, 3, 8, 8, true, true, 6));
  const ParameterBox box = chart->domain();
  const Rng rng(4);
  for (std::uint64_t i = 0; i < 500; ++i) {
    const SurfaceDerivatives d =
        chart->derivatives(box.min + Vec2(rng.uniform(4 * i), rng.uniform(4 * i + 1)) * box.size());
    const Vec2 truth(rng.uniform(4 * i + 2) - 0.5, rng.uniform(4 * i + 3) - 0.5);
    Vec2 c;
    ASSERT_TRUE(tangent_components(d, truth.x * d.u + truth.y * d.v, c));
    EXPECT_LT(glm::distance(c, truth), 1e-11);
  }
  SurfaceDerivatives flat;
  flat.u = flat.v = Vec3(1, 2, 3);
  Vec2 c;
  EXPECT_FALSE(tangent_components(flat, Vec3(1, 2, 3), c));
  EXPECT_FALSE(tangent_components({}, Vec3(1, 2, 3), c));
}

SurfaceDerivatives helicoid(Vec2 t) {
  const double c = std::cos(t.x), s = std::sin(t.x), r = t.y;
  return {{r * c, r * s, 0.3 * t.x}, {-r * s, r * c, 0.3}, {c, s, 0},
          {-r * c, -r * s, 0},       {-s, c, 0},           {0, 0, 0}};
}

TEST(FunctionChart, DifferencesAgreeWithDerivatives) {
  const FunctionChartOptions options{.domain = {Vec2(0, -1), Vec2(6, 2)}};
  const auto exact = make_function_chart(helicoid, options);
  const auto chart = make_function_chart([](Vec2 t) { return helicoid(t).p; }, options);
  const Rng rng(8);
  for (std::uint64_t i = 0; i < 300; ++i) {
    Vec2 uv(6 * rng.uniform(2 * i), -1 + 3 * rng.uniform(2 * i + 1));
    if (i % 5 == 0) uv.x = i % 2 == 0 ? 0 : 6;
    if (i % 7 == 0) uv.y = i % 2 == 0 ? -1 : 2 - 0.003;
    const SurfaceDerivatives a = chart->derivatives(uv), b = exact->derivatives(uv);
    EXPECT_EQ(a.p, b.p);
    EXPECT_LT(glm::distance(a.u, b.u), 1e-11);
    EXPECT_LT(glm::distance(a.v, b.v), 1e-11);
    EXPECT_LT(glm::distance(a.uu, b.uu), 2e-9);
    EXPECT_LT(glm::distance(a.uv, b.uv), 2e-9);
    EXPECT_LT(glm::distance(a.vv, b.vv), 2e-9);
  }
}

TEST(FunctionChart, NeverLeavesItsDomain) {
  const auto chart = make_function_chart(
      [](Vec2 t) {
        EXPECT_TRUE(t.x >= 0 && t.x <= 1 && t.y >= 2 && t.y <= 3) << t.x << " " << t.y;
        return Vec3(t.x, t.y, std::sqrt(t.x * (3 - t.y)));
      },
      {.domain = {Vec2(0, 2), Vec2(1, 3)}, .period = Vec2(1, 0)});
  for (const Vec2 uv : {Vec2(0, 2), Vec2(1, 3), Vec2(0.001, 2.9999), Vec2(7, -4)}) {
    chart->derivatives(uv);
    chart->position(uv);
  }
  EXPECT_THROW(make_function_chart(helicoid, {.domain = {Vec2(1), Vec2(1)}}), GeometryError);
}

}  // namespace
}  // namespace burin
