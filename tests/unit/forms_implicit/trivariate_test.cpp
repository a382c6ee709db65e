#include <burin/base/error.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/implicit/volume_function.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace burin {
namespace {

// Uneven knots, one of them double, full at the ends.
TrivariateSpline random_spline(std::array<std::int32_t, 3> order) {
  TrivariateSpline s;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1, 1);
  s.order = order;
  const std::vector<double> inner{1, 1.5, 2.5, 2.5, 4};
  std::size_t n = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto p = static_cast<std::size_t>(order[a]);
    s.knots[a].assign(p, 0);
    s.knots[a].insert(s.knots[a].end(), inner.begin(), inner.end());
    s.knots[a].insert(s.knots[a].end(), p, 5 + static_cast<double>(a));
    s.size[a] = order[a] + 5;
    n *= static_cast<std::size_t>(s.size[a]);
  }
  for (std::size_t i = 0; i < n; ++i) s.coefficients.push_back(any(random));
  return s;
}

// Coefficients at Greville's places: linear data is reproduced.
TrivariateSpline linear_spline(std::array<std::int32_t, 3> order, Vec3 slope) {
  TrivariateSpline s = random_spline(order);
  const auto greville = [&](std::size_t a, std::int32_t i) {
    double sum = 0;
    for (int k = 1; k < s.order[a]; ++k) sum += s.knots[a][static_cast<std::size_t>(i + k)];
    return sum / (s.order[a] - 1);
  };
  std::size_t n = 0;
  for (int k = 0; k < s.size[2]; ++k) {
    for (int j = 0; j < s.size[1]; ++j) {
      for (int i = 0; i < s.size[0]; ++i) {
        s.coefficients[n++] = glm::dot(slope, Vec3(greville(0, i), greville(1, j), greville(2, k)));
      }
    }
  }
  return s;
}

// The spline without the planes that close it.
std::shared_ptr<const ImplicitFunction> open(const TrivariateSpline& s, double level) {
  auto f = make_trivariate_function(s, level);
  auto inner = f->restricted({Vec3(2), Vec3(2)});
  return inner ? inner : f;
}

std::vector<Vec3> points(std::size_t n);

TEST(Trivariate, SlopesHoldTheDerivatives) {
  for (const std::array<std::int32_t, 3> order : {std::array{4, 4, 4}, std::array{3, 5, 4}}) {
    const auto f = open(random_spline(order), 0.1);
    for (const Vec3& center : points(60)) {
      const Vec3 direction = glm::normalize(center - Vec3(2.1, 2.2, 1.9));
      const double half = 0.02 * (1 + center.x);
      const Box3 box{glm::max(center - half, Vec3(0)), glm::min(center + half, Vec3(5, 6, 7))};
      const Interval slope = f->slope(box, direction);
      EXPECT_LT(slope.max - slope.min, 200);
      for (const Vec3& share : points(40)) {
        const Vec3 p = box.min + share / Vec3(5, 6, 7) * box.size();
        const double s = glm::dot(f->gradient(p).gradient, direction);
        EXPECT_GE(s, slope.min - 1e-9);
        EXPECT_LE(s, slope.max + 1e-9);
      }
    }
  }
}

std::vector<Vec3> points(std::size_t n) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(0.01, 4.99);
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < n; ++i) out.emplace_back(any(random), any(random), any(random));
  return out;
}

TEST(Trivariate, LinearDataStaysLinear) {
  const Vec3 slope(1, -2, 3);
  for (const std::int32_t order : {2, 3, 4, 7, 10}) {
    const auto f = open(linear_spline({order, 4, 3}, slope), 0.25);
    for (const Vec3& p : points(30)) {
      const Gradient2 h = f->hessian(p);
      EXPECT_NEAR(h.value, glm::dot(slope, p) - 0.25, 1e-12);
      EXPECT_NEAR(glm::distance(h.gradient, slope), 0, 1e-11);
      EXPECT_NEAR(glm::length(h.hessian_times({1, 2, 3})), 0, 1e-9);
    }
    EXPECT_NEAR(f->value({0, 0, 0}), -0.25, 1e-12);
    EXPECT_NEAR(f->value({5, 6, 7}), 14 - 0.25, 1e-12);
  }
}

TEST(Trivariate, DerivativesAreThoseOfTheValues) {
  const double d = 1e-6;
  for (const auto& order : {std::array{4, 4, 4}, std::array{3, 5, 6}, std::array{2, 4, 9}}) {
    const auto f = open(random_spline({order[0], order[1], order[2]}), 0);
    for (const Vec3& p : points(40)) {
      const Gradient2 h = f->hessian(p);
      EXPECT_EQ(h.value, f->value(p));
      for (int a = 0; a < 3; ++a) {
        Vec3 e(0);
        e[a] = d;
        EXPECT_NEAR((f->value(p + e) - f->value(p - e)) / (2 * d), h.gradient[a], 1e-6);
        const Vec3 column = (f->gradient(p + e).gradient - f->gradient(p - e).gradient) / (2 * d);
        EXPECT_NEAR(glm::distance(column, h.hessian_times(e / d)), 0, 1e-4);
      }
    }
  }
}

TEST(Trivariate, RangeHoldsAllValues) {
  const auto f = open(random_spline({4, 3, 5}), 0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0, 1);
  for (const Vec3& p : points(60)) {
    const Box3 box{p, glm::min(p + Vec3(any(random), any(random), any(random)), Vec3(5))};
    const Interval r = f->range(box);
    EXPECT_LT(r.max - r.min, 2);
    for (int k = 0; k < 50; ++k) {
      EXPECT_TRUE(
          r.contains(f->value(box.min + box.size() * Vec3(any(random), any(random), any(random)))));
    }
  }
}

TEST(Trivariate, ClosedAtItsSides) {
  // The half space x < 2 in a box of 5 x 6 x 7.
  RunContext context;
  const ImplicitForm form(make_trivariate_function(linear_spline({4, 4, 4}, {1, 0, 0}), 2),
                          std::nullopt, context);
  const auto surface = form.realise({.tolerance = 0.01}, context);
  const TriMesh& mesh = surface->proxy().mesh;
  double volume = 0;
  for (const Triangle& t : mesh.triangles) {
    volume +=
        glm::dot(mesh.positions[t[0]], glm::cross(mesh.positions[t[1]], mesh.positions[t[2]])) / 6;
  }
  EXPECT_NEAR(volume, 2 * 6 * 7, 1e-6);
  EXPECT_EQ(surface->proxy().region_count, 6);
}

TEST(Trivariate, RefusesWhatDoesNotFit) {
  const TrivariateSpline good = random_spline({4, 4, 4});
  EXPECT_NO_THROW(make_trivariate_function(good, 0));
  EXPECT_THROW(make_trivariate_function(good, 2), GeometryError);
  TrivariateSpline bad = good;
  bad.knots[1].pop_back();
  EXPECT_THROW(make_trivariate_function(bad, 0), UsageError);
  bad = good;
  std::swap(bad.knots[2].front(), bad.knots[2].back());
  EXPECT_THROW(make_trivariate_function(bad, 0), UsageError);
  bad = good;
  bad.coefficients.pop_back();
  EXPECT_THROW(make_trivariate_function(bad, 0), UsageError);
  bad = good;
  bad.coefficients.front() = std::nan("");
  EXPECT_THROW(make_trivariate_function(bad, 0), UsageError);
  bad = good;
  bad.order[0] = 11;
  EXPECT_THROW(make_trivariate_function(bad, 0), UsageError);
}

}  // namespace
}  // namespace burin
