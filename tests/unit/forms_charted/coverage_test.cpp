#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/forms/charted/coverage.h>
#include <burin/forms/charted/nurbs.h>

#include <burin_test/horn.h>
#include <burin_test/nurbs_shapes.h>
#include <burin_test/shapes.h>
#include <burin_test/uniformity.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace burin {
namespace {

using test::kPi;

double area_at(const Chart& chart, Vec2 uv) {
  const SurfaceDerivatives d = chart.derivatives(uv);
  return glm::length(glm::cross(d.u, d.v));
}

/// The largest R of many samples in every span (where R jumps at knots, on both sides), the best of
/// them climbed.
double densely_sampled(const Chart& chart) {
  const auto ends = [](std::vector<double> knots, int degree, int count) {
    knots = std::vector<double>(knots.begin() + degree, knots.begin() + count + 1);
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    return knots;
  };
  const NurbsData& data = *nurbs_data(chart);
  const std::vector<double> us = ends(data.knots_u, data.degree_u, data.count_u);
  const std::vector<double> vs = ends(data.knots_v, data.degree_v, data.count_v);
  constexpr int kSide = 40;
  const double inside = 1 - 1e-9;
  double best = 0;
  for (std::size_t a = 1; a < us.size(); ++a) {
    for (std::size_t b = 1; b < vs.size(); ++b) {
      const Vec2 low(us[a - 1], vs[b - 1]), size = Vec2(us[a], vs[b]) - low;
      Vec2 top(0);
      double here = 0;
      const auto look = [&](Vec2 t) {
        t = glm::clamp(t, Vec2(0), Vec2(inside));
        const double r = area_at(chart, low + t * size);
        if (r > here) here = r, top = t;
      };
      for (int i = 0; i <= kSide; ++i) {
        for (int j = 0; j <= kSide; ++j) look(Vec2(i, j) / double(kSide));
      }
      for (double step = 0.5 / kSide; step > 1e-6; step /= 2) {
        const Vec2 center = top;
        for (const Vec2 d : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
          look(center + step * d);
        }
      }
      best = std::max(best, here);
    }
  }
  return best;
}

void expect_tight_bound(const NurbsData& data, const char* name) {
  const RunContext context;
  const auto chart = make_nurbs_chart(data);
  const double truth = densely_sampled(*chart);
  const AreaBound plain = area_bound(*chart, context, std::numeric_limits<double>::infinity());
  const AreaBound tight = area_bound(*chart, context, 0.01);
  EXPECT_TRUE(plain.proved && tight.proved) << name;
  EXPECT_EQ(plain.subdivisions, 0u) << name;
  EXPECT_GE(plain.value, truth) << name;
  EXPECT_GE(tight.value, truth) << name;
  EXPECT_LE(tight.value, plain.value) << name;
  EXPECT_LE(tight.attained, truth * (1 + 1e-6)) << name;
  EXPECT_LE(tight.value, 1.0101 * tight.attained) << name;
}

TEST(AreaBound, IsNeverExceededAndTight) {
  expect_tight_bound(test::torus_nurbs(10, 3), "torus");
  expect_tight_bound(test::sphere_nurbs(2), "sphere");
  expect_tight_bound(test::cone_nurbs(3, 0, 2), "cone");
  expect_tight_bound(test::horn_nurbs(), "horn");
  std::uint64_t seed = 10;
  for (const int degree : {1, 2, 3, 4}) {
    for (const bool rational : {false, true}) {
      expect_tight_bound(test::random_nurbs(degree, 5 - degree, 6, 7, rational, true, ++seed),
                         rational ? "random rational" : "random polynomial");
    }
  }
}

TEST(AreaBound, MeetsKnownValues) {
  const RunContext context;
  const auto flat =
      make_nurbs_chart(bezier_patch(1, 1, {Vec3(0), Vec3(0, 1, 0), Vec3(2, 0, 0), Vec3(2, 3, 0)}));
  const AreaBound b = area_bound(*flat, context);
  EXPECT_NEAR(b.attained, 6, 1e-12);
  EXPECT_NEAR(b.value, 6, 1e-7);
  const auto torus = make_function_chart(
      [](Vec2 t) {
        const double ring = 5 + 2 * std::cos(t.y);
        return Vec3(ring * std::cos(t.x), ring * std::sin(t.x), 2 * std::sin(t.y));
      },
      {.domain = {Vec2(0), Vec2(2 * kPi)}, .period = Vec2(2 * kPi)});
  const AreaBound sampled = area_bound(*torus, context);
  EXPECT_FALSE(sampled.proved);
  EXPECT_NEAR(sampled.attained, 14, 1e-6);
  EXPECT_NEAR(sampled.value, 14.7, 1e-5);
}

TEST(AreaBound, ScalesAndMoves) {
  const RunContext context;
  const double one = area_bound(*make_nurbs_chart(test::horn_nurbs()), context).value;
  for (const double scale : {1e-3, 1.0, 1e4}) {
    NurbsData data = test::horn_nurbs();
    for (Vec3& p : data.points) p = p * scale + Vec3(1e5, -1e5, 1e5) * scale;
    EXPECT_NEAR(area_bound(*make_nurbs_chart(data), context).value / (scale * scale), one,
                1e-6 * one);
  }
}

CoverageOptions options_of(std::size_t count, std::uint64_t seed) {
  CoverageOptions o;
  o.count = count;
  o.seed = seed;
  o.measure = false;
  return o;
}

TEST(Coverage, IsUniformByAreaOnATorus) {
  const RunContext context;
  const auto chart = make_nurbs_chart(test::torus_nurbs(3, 2));
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Coverage c = cover_chart(*chart, options_of(100'000, seed), context);
    ASSERT_EQ(c.points.size(), 100'000u);
    std::vector<Vec2> shares;
    for (const CoveragePoint& p : c.points) shares.push_back(test::torus_shares(p.position, 3, 2));
    EXPECT_LT(std::abs(test::chi_square(shares, 20)), 3.5);
    // The expected number of candidates: the bound over the mean of R.
    const double mean = 4 * kPi * kPi * 3 * 2 / 16;
    EXPECT_NEAR(static_cast<double>(c.candidates) / 100'000, c.bound.value / mean, 0.02);
  }
  // The test can fail: uniform in (u,v) is not uniform by area.
  CoverageOptions o = options_of(100'000, 1);
  o.norm = CoverageNorm::Parameters;
  std::vector<Vec2> shares;
  for (const CoveragePoint& p : cover_chart(*chart, o, context).points) {
    shares.push_back(test::torus_shares(p.position, 3, 2));
  }
  EXPECT_GT(test::chi_square(shares, 20), 100);
}

TEST(Coverage, IsUniformInParameters) {
  const RunContext context;
  const auto chart = make_nurbs_chart(test::horn_nurbs());
  CoverageOptions o = options_of(50'000, 7);
  o.norm = CoverageNorm::Parameters;
  const Coverage c = cover_chart(*chart, o, context);
  EXPECT_EQ(c.candidates, c.points.size());
  std::vector<Vec2> shares;
  for (const CoveragePoint& p : c.points) {
    shares.push_back((p.uv - chart->domain().min) / chart->domain().size());
  }
  EXPECT_LT(std::abs(test::chi_square(shares, 16)), 3.5);
}

Camera camera_of(Vec3 direction, std::optional<double> perspective, double radius) {
  ViewOptions view;
  view.direction = direction;
  view.perspective = perspective;
  const auto sphere = [&](const Mat3& axes) {
    Box3 box;
    for (glm::length_t i = 0; i < 3; ++i) {
      const double half = radius * glm::length(glm::transpose(axes)[i]);
      box.min[i] = -half;
      box.max[i] = half;
    }
    return box;
  };
  return Camera::fit(sphere, view);
}

TEST(Coverage, IsUniformInThePicture) {
  // A disc of a sphere's picture: shares of radius squared and angle are uniform. In perspective
  // the picture of a sphere in the middle of the sheet is a disc, too.
  const RunContext context;
  const auto chart = make_nurbs_chart(test::sphere_nurbs(1));
  for (const bool perspective : {false, true}) {
    const Camera camera =
        camera_of(Vec3(1, 2, 0.5), perspective ? std::optional(40.0) : std::nullopt, 1);
    CoverageOptions o = options_of(60'000, 5);
    o.norm = CoverageNorm::Picture;
    o.camera = &camera;
    std::vector<Vec2> shares;
    const double d = perspective ? glm::length(camera.eye()) : 0;
    const double edge = perspective ? camera.scale() * d / std::sqrt(d * d - 1) : camera.scale();
    for (const CoveragePoint& p : cover_chart(*chart, o, context).points) {
      if (glm::dot(p.normal, camera.to_viewer(p.position)) < 0) continue;
      const Vec2 q = (camera.to_paper(p.position) - camera.offset()) / edge;
      shares.emplace_back(glm::dot(q, q), test::turns(q.y, q.x));
    }
    EXPECT_GT(shares.size(), 20'000u);
    EXPECT_LT(std::abs(test::chi_square(shares, 14)), 3.5) << perspective;
  }
  CoverageOptions o = options_of(10, 1);
  o.norm = CoverageNorm::Picture;
  EXPECT_THROW(cover_chart(*chart, o, context), GeometryError);
}

TEST(Coverage, FollowsADensity) {
  // Density z^2 on a sphere of radius 1: by Archimedes z is uniform by area, so z^3 becomes
  // uniform.
  const RunContext context;
  const auto chart = make_nurbs_chart(test::sphere_nurbs(1));
  CoverageOptions o = options_of(60'000, 11);
  o.density = [](const CoveragePoint& p) { return p.normal.z * p.normal.z; };
  std::vector<Vec2> shares;
  for (const CoveragePoint& p : cover_chart(*chart, o, context).points) {
    shares.emplace_back(0.5 + 0.5 * std::pow(p.position.z, 3),
                        test::turns(p.position.y, p.position.x));
  }
  ASSERT_EQ(shares.size(), 60'000u);
  EXPECT_LT(std::abs(test::chi_square(shares, 14)), 3.5);
  o.density = [](const CoveragePoint&) { return 0.0; };
  o.count = 10;
  EXPECT_TRUE(cover_chart(*chart, o, context).points.empty());
}

TEST(Coverage, HornTakesFewerThanThreeCandidatesAPoint) {
  const RunContext context;
  const auto chart = make_nurbs_chart(test::horn_nurbs());
  const Coverage c = cover_chart(*chart, options_of(10'000, 1), context);
  ASSERT_EQ(c.points.size(), 10'000u);
  EXPECT_TRUE(c.bound.proved);
  EXPECT_LT(static_cast<double>(c.candidates), 3.0 * 10'000);
  EXPECT_GT(static_cast<double>(c.candidates), 1.5 * 10'000);
  for (const CoveragePoint& p : c.points) {
    EXPECT_EQ(p.position, chart->position(p.uv));
    EXPECT_NEAR(glm::length(p.normal), 1, 1e-12);
  }
}

TEST(Coverage, IsUniformByAreaOnTheHorn) {
  // 12 x 16 cells of (u,v), a span or four spans each; their areas by the midpoint rule.
  const RunContext context;
  const auto chart = make_nurbs_chart(test::horn_nurbs());
  std::vector<double> area(12 * 16, 0.0), count(12 * 16, 0.0);
  constexpr int kFine = 24;
  double total = 0;
  for (int i = 0; i < 12 * kFine; ++i) {
    for (int j = 0; j < 16 * kFine; ++j) {
      const double r = area_at(*chart, (Vec2(i, 4 * j) + Vec2(0.5, 2)) / double(kFine));
      area[static_cast<std::size_t>(i / kFine * 16 + j / kFine)] += r;
      total += r;
    }
  }
  const Coverage c = cover_chart(*chart, options_of(100'000, 21), context);
  for (const CoveragePoint& p : c.points) {
    ++count[static_cast<std::size_t>(p.uv.x) * 16 + static_cast<std::size_t>(p.uv.y / 4)];
  }
  double chi2 = 0;
  for (std::size_t k = 0; k < area.size(); ++k) {
    const double expected = 100'000 * area[k] / total;
    chi2 += (count[k] - expected) * (count[k] - expected) / expected;
  }
  const double freedom = 12 * 16 - 1;
  EXPECT_LT(std::abs(chi2 - freedom) / std::sqrt(2 * freedom), 3.5);
}

TEST(Horn, HasCircularSections) {
  const test::HornShape shape;
  const auto chart = make_nurbs_chart(test::horn_nurbs(shape));
  EXPECT_EQ(chart->period(), Vec2(12, 0));
  EXPECT_EQ(chart->domain().max, Vec2(12, 64));
  for (const double v : {0.0, 7.0, 32.0, 50.0, 64.0}) {
    const test::HornSection s = test::horn_section(shape, v / 64);
    for (double u = 0; u < 12; u += 0.37) {
      const Vec3 p = chart->position({u, v}) - s.center;
      EXPECT_NEAR(glm::length(p), s.radius, 1e-3 * s.radius);
      const SurfaceDerivatives d = chart->derivatives({u, v});
      EXPECT_GT(glm::dot(glm::normalize(glm::cross(d.u, d.v)), glm::normalize(p)), 0.8);
    }
  }
}

TEST(Coverage, MeasuresItsRadius) {
  // n random points leave gaps of about sqrt(A log n / (pi n)).
  const RunContext context;
  const auto chart = make_nurbs_chart(test::torus_nurbs(3, 1));
  CoverageOptions o = options_of(5000, 3);
  o.measure = true;
  const Coverage c = cover_chart(*chart, o, context);
  const double area = 4 * kPi * kPi * 3, expected = std::sqrt(area * std::log(5000) / kPi / 5000);
  EXPECT_EQ(c.measured_at, 40'000u);
  EXPECT_GT(c.covering_radius, 0.9 * expected);
  EXPECT_LT(c.covering_radius, 1.5 * expected);
  // By brute force at places of our own it is never much larger.
  const Rng rng(99);
  double far = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const Vec3 p = chart->position(4.0 * Vec2(rng.uniform(2 * i), rng.uniform(2 * i + 1)));
    double best = 1e9;
    for (const CoveragePoint& q : c.points) best = std::min(best, glm::distance(p, q.position));
    far = std::max(far, best);
  }
  EXPECT_LT(far, 1.1 * c.covering_radius);
}

TEST(Coverage, DiscsKeepTheirDistance) {
  const RunContext context;
  const auto chart = make_nurbs_chart(test::torus_nurbs(3, 1));
  CoverageOptions o = options_of(1'000'000, 3);
  o.spacing = 0.25;
  o.measure = true;
  const Coverage c = cover_chart(*chart, o, context);
  double nearest = 1e9;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      nearest = std::min(nearest, glm::distance(c.points[i].position, c.points[k].position));
    }
  }
  EXPECT_GE(nearest, 0.25);
  EXPECT_LT(nearest, 0.26);
  EXPECT_LT(c.covering_radius, 1.25 * 0.25);
  // Discs of random darts fill 0.67 to 0.70 of the area with neighbours counted by half spacing.
  const double area = 4 * kPi * kPi * 3;
  EXPECT_GT(static_cast<double>(c.points.size()), 0.62 * area / (0.25 * 0.25));
  o.count = 100;
  EXPECT_EQ(cover_chart(*chart, o, context).points.size(), 100u);
}

TEST(Coverage, DiscsOnPaperKeepTheirDistanceASheet) {
  const RunContext context;
  const auto chart = make_nurbs_chart(test::sphere_nurbs(1));
  const Camera camera = camera_of(Vec3(1, -1, 1), std::nullopt, 1);
  CoverageOptions o = options_of(1'000'000, 3);
  o.norm = CoverageNorm::Picture;
  o.camera = &camera;
  o.spacing = 3;
  o.measure = true;
  const Coverage c = cover_chart(*chart, o, context);
  std::size_t front = 0;
  double nearest = 1e9;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const bool fi = glm::dot(c.points[i].normal, camera.direction()) >= 0;
    front += fi;
    for (std::size_t k = 0; k < i; ++k) {
      if (fi != (glm::dot(c.points[k].normal, camera.direction()) >= 0)) continue;
      nearest = std::min(nearest, glm::distance(camera.to_paper(c.points[i].position),
                                                camera.to_paper(c.points[k].position)));
    }
  }
  EXPECT_GE(nearest, 3);
  EXPECT_LT(c.covering_radius, 1.3 * 3);
  const double disc = kPi * camera.scale() * camera.scale();
  EXPECT_NEAR(static_cast<double>(front) * 9 / disc, 0.67, 0.05);
  EXPECT_NEAR(static_cast<double>(c.points.size() - front) * 9 / disc, 0.67, 0.05);
}

TEST(Coverage, DiscsGrowWhereTheDensityFalls) {
  const RunContext context;
  const auto chart = make_nurbs_chart(test::sphere_nurbs(1));
  CoverageOptions o = options_of(1'000'000, 3);
  o.spacing = 0.05;
  o.density = [](const CoveragePoint& p) { return p.position.z > 0 ? 1.0 : 0.25; };
  const Coverage c = cover_chart(*chart, o, context);
  const auto upper = std::count_if(c.points.begin(), c.points.end(),
                                   [](const CoveragePoint& p) { return p.position.z > 0; });
  const double ratio = static_cast<double>(upper) /
                       (static_cast<double>(c.points.size()) - static_cast<double>(upper));
  EXPECT_NEAR(ratio, 4, 0.4);
}

TEST(Coverage, FunctionChartsRaiseABoundThatWasTooSmall) {
  // A needle of a bump between the samples: R is large only within 1e-5 of the domain.
  const RunContext context;
  const auto chart = make_function_chart(
      [](Vec2 t) {
        const Vec2 c = (t - Vec2(0.5078)) / 0.0015;
        SurfaceDerivatives d;
        const double e = 0.05 * std::exp(-glm::dot(c, c));
        d.p = Vec3(t, e);
        d.u = Vec3(1, 0, -2 * c.x / 0.0015 * e);
        d.v = Vec3(0, 1, -2 * c.y / 0.0015 * e);
        return d;
      },
      {.domain = {Vec2(0), Vec2(1)}});
  const AreaBound first = area_bound(*chart, context);
  const Coverage c = cover_chart(*chart, options_of(200'000, 1), context);
  EXPECT_FALSE(first.proved);
  EXPECT_GT(c.bound.value, first.value);
  EXPECT_FALSE(c.bound.proved);
  EXPECT_EQ(c.points.size(), 200'000u);
  for (const CoveragePoint& p : c.points) EXPECT_LE(area_at(*chart, p.uv), c.bound.value);
}

TEST(Coverage, IsTheSameForAnyNumberOfThreads) {
  const RunContext context;
  const auto chart = make_nurbs_chart(test::horn_nurbs());
  CoverageOptions o = options_of(3000, 3);
  o.measure = true;
  for (const double spacing : {0.0, 1.5}) {
    o.spacing = spacing;
    Coverage one;
    {
      const ThreadLimit limit(1);
      one = cover_chart(*chart, o, context);
    }
    const Coverage many = cover_chart(*chart, o, context);
    ASSERT_EQ(one.points.size(), many.points.size());
    EXPECT_EQ(one.candidates, many.candidates);
    EXPECT_EQ(one.covering_radius, many.covering_radius);
    for (std::size_t i = 0; i < one.points.size(); ++i) {
      ASSERT_EQ(one.points[i].position, many.points[i].position);
    }
  }
  CoverageOptions other = o;
  other.face = 1;
  EXPECT_NE(cover_chart(*chart, o, context).points[0].uv,
            cover_chart(*chart, other, context).points[0].uv);
}

TEST(Coverage, PlacesAndTurnsNormals) {
  const RunContext context;
  const auto chart = make_nurbs_chart(test::sphere_nurbs(1));
  CoverageOptions o = options_of(200, 3);
  o.placement.linear = Mat3(-2, 0, 0, 0, 0, 2, 0, 2, 0);  // mirrors twice: a rotation, scaled
  o.placement.offset = Vec3(5, 6, 7);
  for (const bool mirror : {false, true}) {
    if (mirror) o.placement.linear[0] = -o.placement.linear[0];
    for (const CoveragePoint& p : cover_chart(*chart, o, context).points) {
      EXPECT_LT(glm::distance(p.position - o.placement.offset, 2.0 * p.normal), 1e-12);
    }
  }
  const Mat3 far = o.placement.linear;
  o.reversed = true;
  o.placement.linear = far;
  for (const CoveragePoint& p : cover_chart(*chart, o, context).points) {
    EXPECT_LT(glm::distance(p.position - o.placement.offset, -2.0 * p.normal), 1e-12);
  }
}

TEST(Coverage, CanBeCancelled) {
  RunContext context;
  context.cancel();
  const auto chart = make_nurbs_chart(test::horn_nurbs());
  EXPECT_THROW(cover_chart(*chart, options_of(1000, 1), context), Cancelled);
}

TEST(Coverage, OfNothingIsEmpty) {
  const RunContext context;
  const auto line =
      make_nurbs_chart(bezier_patch(1, 1, {Vec3(0), Vec3(0), Vec3(1, 1, 1), Vec3(1, 1, 1)}));
  const Coverage c = cover_chart(*line, options_of(100, 1), context);
  EXPECT_TRUE(c.points.empty());
  EXPECT_EQ(c.bound.value, 0);
}

}  // namespace
}  // namespace burin
