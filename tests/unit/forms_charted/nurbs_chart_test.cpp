#include <burin/base/error.h>
#include <burin/forms/charted/nurbs.h>

#include <burin_test/nurbs_shapes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace burin {
namespace {

using Real = long double;

/// N_{i,p} and its derivatives by the textbook's recursion; slow, and nothing like the code tested.
Real basis(const std::vector<double>& t, int i, int p, double x, int derivative) {
  const auto k = static_cast<std::size_t>(i), q = static_cast<std::size_t>(p);
  if (p == 0) {
    if (derivative > 0) return 0;
    return x >= t[k] && x < t[k + 1] ? 1 : 0;
  }
  const Real a = static_cast<Real>(t[k + q]) - t[k], b = static_cast<Real>(t[k + q + 1]) - t[k + 1];
  Real sum = 0;
  if (derivative > 0) {
    if (a > 0) sum += p / a * basis(t, i, p - 1, x, derivative - 1);
    if (b > 0) sum -= p / b * basis(t, i + 1, p - 1, x, derivative - 1);
    return sum;
  }
  if (a > 0) sum += (x - static_cast<Real>(t[k])) / a * basis(t, i, p - 1, x, 0);
  if (b > 0) sum += (static_cast<Real>(t[k + q + 1]) - x) / b * basis(t, i + 1, p - 1, x, 0);
  return sum;
}

struct Homogeneous {
  Real x = 0, y = 0, z = 0, w = 0;
};

Homogeneous sum(const NurbsData& d, Vec2 uv, int ku, int kv) {
  Homogeneous h;
  for (int i = 0; i < d.count_u; ++i) {
    const Real bu = basis(d.knots_u, i, d.degree_u, uv.x, ku);
    if (bu == 0) continue;
    for (int j = 0; j < d.count_v; ++j) {
      const auto n = static_cast<std::size_t>(i * d.count_v + j);
      const Real f =
          bu * basis(d.knots_v, j, d.degree_v, uv.y, kv) * (d.weights.empty() ? 1 : d.weights[n]);
      h.x += f * d.points[n].x;
      h.y += f * d.points[n].y;
      h.z += f * d.points[n].z;
      h.w += f;
    }
  }
  return h;
}

/// S and partials by the quotient rule in extended precision.
SurfaceDerivatives naive(const NurbsData& d, Vec2 uv) {
  const Homogeneous a = sum(d, uv, 0, 0), u = sum(d, uv, 1, 0), v = sum(d, uv, 0, 1),
                    uu = sum(d, uv, 2, 0), w = sum(d, uv, 1, 1), vv = sum(d, uv, 0, 2);
  SurfaceDerivatives s;
  const auto component = [&](Real Homogeneous::*c, int i) {
    const Real p = a.*c / a.w, pu = (u.*c - u.w * p) / a.w, pv = (v.*c - v.w * p) / a.w;
    s.p[i] = static_cast<double>(p);
    s.u[i] = static_cast<double>(pu);
    s.v[i] = static_cast<double>(pv);
    s.uu[i] = static_cast<double>((uu.*c - 2 * u.w * pu - uu.w * p) / a.w);
    s.uv[i] = static_cast<double>((w.*c - u.w * pv - v.w * pu - w.w * p) / a.w);
    s.vv[i] = static_cast<double>((vv.*c - 2 * v.w * pv - vv.w * p) / a.w);
  };
  component(&Homogeneous::x, 0);
  component(&Homogeneous::y, 1);
  component(&Homogeneous::z, 2);
  return s;
}

double difference(const SurfaceDerivatives& a, const SurfaceDerivatives& b) {
  double worst = 0;
  for (const Vec3 v : {a.p - b.p, a.u - b.u, a.v - b.v, a.uu - b.uu, a.uv - b.uv, a.vv - b.vv}) {
    worst = std::max(worst, glm::length(v));
  }
  return worst;
}

Vec2 random_parameter(const Chart& chart, const Rng& rng, std::uint64_t i) {
  const ParameterBox box = chart.domain();
  return box.min + Vec2(rng.uniform(2 * i), rng.uniform(2 * i + 1)) * box.size();
}

TEST(NurbsChart, AgreesWithTheTextbookForEveryDegree) {
  std::uint64_t seed = 1;
  for (const int du : {1, 2, 3, 4, 7}) {
    for (const int dv : {1, 2, 3, 5}) {
      for (const bool rational : {false, true}) {
        for (const bool clamped : {false, true}) {
          const NurbsData data =
              test::random_nurbs(du, dv, du + 5, dv + 8, rational, clamped, ++seed);
          const auto chart = make_nurbs_chart(data);
          const Rng rng(seed);
          for (std::uint64_t i = 0; i < 12; ++i) {
            const Vec2 uv = random_parameter(*chart, rng, i);
            const SurfaceDerivatives d = chart->derivatives(uv), t = naive(data, uv);
            EXPECT_LT(difference(d, t), 2e-11) << du << " " << dv << " " << rational << clamped;
            EXPECT_LT(glm::distance(d.p, t.p), 1e-13);
            EXPECT_LT(glm::distance(chart->position(uv), t.p), 1e-13);
          }
        }
      }
    }
  }
}

TEST(NurbsChart, HighDegreeKeepsItsDigits) {
  const NurbsData data = test::random_nurbs(25, 12, 26, 14, true, true, 9);
  const auto chart = make_nurbs_chart(data);
  // A Bezier in u: values by de Casteljau's scheme on the control points.
  const Rng rng(5);
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Vec2 uv = random_parameter(*chart, rng, i);
    const double t = (uv.x - chart->domain().min.x) / chart->domain().size().x;
    std::vector<glm::dvec4> p;
    for (int k = 0; k < data.count_u; ++k) {
      glm::dvec4 q(0);
      for (int j = 0; j < data.count_v; ++j) {
        const auto n = static_cast<std::size_t>(k * data.count_v + j);
        const double b = static_cast<double>(basis(data.knots_v, j, data.degree_v, uv.y, 0));
        q += b * data.weights[n] * glm::dvec4(data.points[n], 1);
      }
      p.push_back(q);
    }
    for (std::size_t r = p.size() - 1; r > 0; --r) {
      for (std::size_t k = 0; k < r; ++k) p[k] = (1 - t) * p[k] + t * p[k + 1];
    }
    EXPECT_LT(glm::distance(chart->position(uv), Vec3(p[0]) / p[0].w), 1e-12);
  }
}

TEST(NurbsChart, TorusIsATorus) {
  const auto chart = make_nurbs_chart(test::torus_nurbs(10, 3), FaceKind::Torus);
  EXPECT_EQ(chart->kind(), FaceKind::Torus);
  EXPECT_EQ(chart->period(), Vec2(4, 4));
  const Rng rng(3);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Vec2 uv = random_parameter(*chart, rng, i);
    const SurfaceDerivatives d = chart->derivatives(uv);
    const double ring = std::hypot(d.p.x, d.p.y);
    EXPECT_NEAR(std::hypot(ring - 10, d.p.z), 3, 1e-13);
    const Vec3 outward = (d.p - Vec3(d.p.x, d.p.y, 0) * (10 / ring)) / 3.0;
    const Vec3 n = chart_normal(d, false, uv, chart->domain().center());
    EXPECT_LT(glm::distance(n, outward), 1e-13);
    const Frame f = chart_frame(d, n, chart->kind(), 26);
    EXPECT_NEAR(f.k1, 1.0 / 3, 1e-12);
    EXPECT_NEAR(f.k2, (ring - 10) / 3 / ring, 1e-12);
    EXPECT_NEAR(std::abs(glm::dot(f.d2, Vec3(-d.p.y, d.p.x, 0) / ring)), 1, 1e-12);
    EXPECT_LT(glm::distance(glm::cross(f.normal, f.d1), f.d2), 1e-14);
    EXPECT_FALSE(f.umbilic);
    EXPECT_NEAR(f.confidence, (f.k1 - f.k2) / (f.k1 + std::abs(f.k2)), 1e-14);
    // Reversed: the same lines, curvatures with the other sign and order.
    const Frame r = chart_frame(d, -n, chart->kind(), 26);
    EXPECT_NEAR(r.k1, -f.k2, 1e-14);
    EXPECT_NEAR(r.k2, -f.k1, 1e-14);
    EXPECT_NEAR(std::abs(glm::dot(r.d1, f.d2)), 1, 1e-12);
  }
}

TEST(NurbsChart, WrapsPeriodsAndClampsBorders) {
  const auto torus = make_nurbs_chart(test::torus_nurbs(10, 3));
  const auto cone = make_nurbs_chart(test::cone_nurbs(2, 1, 5));
  EXPECT_LT(glm::distance(torus->position({0.3, 3.9}), torus->position({4.3, -0.1})), 1e-13);
  EXPECT_LT(glm::distance(torus->position({0.3, 3.9}), torus->position({-39.7, 39.9})), 1e-12);
  EXPECT_LT(glm::distance(torus->position({0, 1}), torus->position({4, 1})), 1e-13);
  EXPECT_EQ(cone->position({1.5, -7}), cone->position({1.5, 0}));
  EXPECT_EQ(cone->position({5.5, 9}), cone->position({1.5, 1}));
  EXPECT_EQ(cone->period(), Vec2(4, 0));
  EXPECT_TRUE(std::isfinite(torus->position({NAN, 1}).x));
}

TEST(NurbsChart, KnowsWhereItIsNotSmooth) {
  const auto torus = make_nurbs_chart(test::torus_nurbs(10, 3));
  EXPECT_EQ(torus->breaks(0, 2), (std::vector<double>{1, 2, 3}));
  NurbsData data = test::random_nurbs(3, 3, 8, 8, false, true, 4);
  data.knots_u = {0, 0, 0, 0, 1, 2, 2, 3, 4, 4, 4, 4};
  data.knots_v = {0, 0, 0, 0, 1, 2, 2 + 1e-14, 3, 4, 4, 4, 4};
  const auto chart = make_nurbs_chart(data);
  EXPECT_EQ(chart->breaks(0, 2), (std::vector<double>{2}));
  EXPECT_EQ(chart->breaks(1, 2), (std::vector<double>{2}));
  EXPECT_LT(glm::length(chart->derivatives({2, 2}).vv), 100);
  EXPECT_EQ(nurbs_data(*chart)->knots_u, data.knots_u);
}

TEST(NurbsChart, UnclampedPeriodicKnots) {
  // A closed cubic ring of 8 control points, the first three repeated, swept along z.
  NurbsData data;
  data.degree_u = 3;
  data.degree_v = 1;
  data.count_u = 11;
  data.count_v = 2;
  data.periodic_u = true;
  for (int i = 0; i < 15; ++i) data.knots_u.push_back(i);
  data.knots_v = {0, 0, 1, 1};
  for (int i = 0; i < 11; ++i) {
    const double angle = 2 * std::numbers::pi * i / 8;
    for (int j = 0; j < 2; ++j) data.points.emplace_back(std::cos(angle), std::sin(angle), j);
  }
  const auto chart = make_nurbs_chart(data);
  EXPECT_EQ(chart->domain().min, Vec2(3, 0));
  EXPECT_EQ(chart->domain().max, Vec2(11, 1));
  EXPECT_EQ(chart->period(), Vec2(8, 0));
  const SurfaceDerivatives a = chart->derivatives({3, 0.5}), b = chart->derivatives({11, 0.5});
  EXPECT_LT(difference(a, b), 1e-14);
  // At knots a uniform cubic passes through (1, 4, 1) / 6.
  const Vec3 expected = (data.points[2] + 4.0 * data.points[4] + data.points[6]) / 6.0;
  EXPECT_LT(glm::distance(chart->position({4, 0}), expected), 1e-15);
  EXPECT_TRUE(chart->breaks(0, 2).empty());
}

TEST(NurbsChart, StaysExactFarFromTheOrigin) {
  NurbsData data = test::sphere_nurbs(1);
  for (Vec3& p : data.points) p += Vec3(1e5, -1e5, 1e5);
  const auto chart = make_nurbs_chart(data, FaceKind::Sphere);
  const SurfaceDerivatives pole = chart->derivatives({0.7, 2});
  EXPECT_LT(glm::length(pole.u), 1e-10);
  const Vec3 n = chart_normal(pole, false, {0.7, 2}, chart->domain().center());
  EXPECT_LT(glm::distance(n, Vec3(0, 0, 1)), 1e-9);
}

TEST(NurbsChart, BezierPatchInterpolatesItsCorners) {
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i) points.emplace_back(i / 4, i % 4, i * i % 7);
  const auto chart = make_nurbs_chart(bezier_patch(2, 3, points));
  EXPECT_EQ(chart->position({0, 0}), points[0]);
  EXPECT_LT(glm::distance(chart->position({1, 1}), points[11]), 1e-14);
  EXPECT_LT(glm::distance(chart->derivatives({0, 0}).u, 2.0 * (points[4] - points[0])), 1e-14);
  EXPECT_LT(glm::distance(chart->derivatives({0, 0}).v, 3.0 * (points[1] - points[0])), 1e-14);
}

TEST(NurbsChart, RefusesBrokenData) {
  const NurbsData good = test::random_nurbs(3, 2, 6, 6, true, true, 2);
  const auto message = [&](const std::function<void(NurbsData&)>& spoil) -> std::string {
    NurbsData bad = good;
    spoil(bad);
    try {
      make_nurbs_chart(bad);
    } catch (const GeometryError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message([](NurbsData&) {}), "");
  EXPECT_NE(message([](NurbsData& d) { d.degree_u = 0; }).find("degree 0 in u"), std::string::npos);
  EXPECT_NE(message([](NurbsData& d) { d.knots_v.pop_back(); }).find("8 knots in v: 9"),
            std::string::npos);
  EXPECT_NE(
      message([](NurbsData& d) { std::swap(d.knots_u[4], d.knots_u[5]); }).find("knot 5 in u"),
      std::string::npos);
  EXPECT_NE(message([](NurbsData& d) { d.points.pop_back(); }).find("35 control points: 6 x 6"),
            std::string::npos);
  EXPECT_NE(message([](NurbsData& d) { d.weights[7] = 0; }).find("control point 7"),
            std::string::npos);
  EXPECT_NE(message([](NurbsData& d) { d.weights.pop_back(); }).find("35 weights"),
            std::string::npos);
  EXPECT_NE(message([](NurbsData& d) { d.points[3].y = NAN; }).find("point 3 is not finite"),
            std::string::npos);
  EXPECT_NE(message([](NurbsData& d) { d.knots_u.assign(10, 1.0); }).find("no domain"),
            std::string::npos);
  EXPECT_NE(message([](NurbsData& d) { d.periodic_v = true; }).find("does not close"),
            std::string::npos);
}

TEST(NurbsChart, RefusesPointsAndWeightsABillionTimesFartherOutThanTheOthers) {
  const NurbsData good = test::random_nurbs(3, 2, 6, 6, true, true, 2);
  NurbsData far = good;
  far.points[9].z = 1e30;
  EXPECT_THROW(make_nurbs_chart(far), GeometryError);
  NurbsData heavy = good;
  heavy.weights[9] = 4294967295.0 * heavy.weights[8];
  EXPECT_THROW(make_nurbs_chart(heavy), GeometryError);
  // A surface of any size is good, and so is one with most of its points in one place.
  NurbsData large = good;
  for (Vec3& p : large.points) p *= 1e30;
  EXPECT_NO_THROW(make_nurbs_chart(large));
  NurbsData gathered = good;
  for (std::size_t i = 0; i + 6 < gathered.points.size(); ++i) gathered.points[i] = Vec3(1);
  EXPECT_NO_THROW(make_nurbs_chart(gathered));
}

}  // namespace
}  // namespace burin
