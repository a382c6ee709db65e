#include <burin/base/error.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/implicit/volume_function.h>

#include "components.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace burin {
namespace {

constexpr std::array<int, 2> kDegrees{2, 3};

VolumeGrid sampled_grid(std::array<std::int32_t, 3> size, Vec3 origin, Mat3 steps,
                        const std::function<double(Vec3)>& f) {
  VolumeGrid g;
  g.size = size;
  g.origin = origin;
  g.steps = steps;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        g.samples.push_back(static_cast<float>(f(origin + steps * Vec3(i, j, k))));
      }
    }
  }
  return g;
}

VolumeGrid noise(std::array<std::int32_t, 3> size, Mat3 steps = Mat3(1)) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 100);
  return sampled_grid(size, Vec3(0), steps, [&](Vec3) { return any(random); });
}

Mat3 skewed_steps() {
  const Mat3 turn(glm::rotate(glm::dmat4(1), 0.7, glm::normalize(Vec3(1, 2, 3))));
  return turn * Mat3(0.5, 0, 0, 0, 0.8, 0, 0, 0, 2);
}

std::vector<Vec3> inner_points(const VolumeGrid& g, std::size_t n) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0.001, 0.999);
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 share(any(random), any(random), any(random));
    out.push_back(g.origin + g.steps * (share * Vec3(g.size[0] - 1, g.size[1] - 1, g.size[2] - 1)));
  }
  return out;
}

// The spline itself, without the planes that close it.
std::shared_ptr<const ImplicitFunction> spline(const VolumeGrid& g, const VolumeOptions& options) {
  auto f = make_volume_function(g, options, RunContext());
  const Vec3 middle =
      g.origin + g.steps * (0.5 * Vec3(g.size[0] - 1, g.size[1] - 1, g.size[2] - 1));
  auto inner = f->restricted({middle, middle});
  return inner ? inner : f;
}

TEST(Volume, InterpolationTakesTheSamples) {
  const VolumeGrid g = noise({17, 9, 24}, skewed_steps());
  for (const int degree : kDegrees) {
    const auto f = spline(g, {.level = 50, .degree = degree, .interpolate = true});
    for (int k = 0; k < 24; k += 1) {
      for (int j = 0; j < 9; j += 2) {
        for (int i = 0; i < 17; i += 4) {
          const double sample = g.samples[static_cast<std::size_t>((k * 9 + j) * 17 + i)];
          EXPECT_NEAR(f->value(g.steps * Vec3(i, j, k)), 50 - sample, 1e-4) << degree;
        }
      }
    }
  }
}

TEST(Volume, SamplesAsCoefficientsSmoothALittle) {
  // One sample of 1 among zeros: the cubic has (4/6)^3 there and (4/6)^2/6 beside it.
  VolumeGrid g = sampled_grid({9, 9, 9}, Vec3(0), Mat3(1), [](Vec3) { return 0.0; });
  g.samples[(4 * 9 + 4) * 9 + 4] = 1;
  const auto cubic = make_volume_function(g, {.level = 0.1}, RunContext());
  EXPECT_NEAR(cubic->value({4, 4, 4}), 0.1 - 8.0 / 27, 1e-12);
  EXPECT_NEAR(cubic->value({5, 4, 4}), 0.1 - 2.0 / 27, 1e-12);
  const auto quadratic = make_volume_function(g, {.level = 0.1, .degree = 2}, RunContext());
  EXPECT_NEAR(quadratic->value({4, 4, 4}), 0.1 - 27.0 / 64, 1e-12);
  EXPECT_NEAR(quadratic->value({4, 5, 4}), 0.1 - 9.0 / 128, 1e-12);
}

TEST(Volume, LinearDataStaysLinear) {
  const Vec3 slope(3, -2, 0.7);
  const Mat3 steps = skewed_steps();
  const VolumeGrid g = sampled_grid({8, 6, 7}, {10, 20, 30}, steps,
                                    [&](Vec3 p) { return glm::dot(slope, p - Vec3(10, 20, 30)); });
  for (const int degree : kDegrees) {
    for (const bool interpolate : {false, true}) {
      const auto f = spline(g, {.level = 0.5, .degree = degree, .interpolate = interpolate});
      for (const Vec3& p : inner_points(g, 50)) {
        const Gradient2 h = f->hessian(p);
        EXPECT_NEAR(h.value, 0.5 - glm::dot(slope, p - g.origin), 1e-5);
        EXPECT_NEAR(glm::distance(h.gradient, -slope), 0, 1e-5);
        EXPECT_NEAR(glm::length(h.hessian_times({1, 1, 1})), 0, 1e-4);
      }
    }
  }
}

TEST(Volume, QuadraticsAreReproducedInside) {
  const VolumeGrid g = sampled_grid({40, 40, 40}, Vec3(-20), Mat3(1), [](Vec3 p) {
    return 0.02 * (p.x * p.x + 2 * p.y * p.y - p.x * p.z) + p.z;
  });
  for (const int degree : kDegrees) {
    const auto f = spline(g, {.level = 1, .degree = degree, .interpolate = true});
    const Vec3 p(0.3, -1.2, 1.7);
    const Gradient2 h = f->hessian(p);
    EXPECT_NEAR(h.value, 1 - 0.02 * (p.x * p.x + 2 * p.y * p.y - p.x * p.z) - p.z, 1e-5);
    EXPECT_NEAR(h.xx, -0.04, 1e-5);
    EXPECT_NEAR(h.yy, -0.08, 1e-5);
    EXPECT_NEAR(h.xz, 0.02, 1e-5);
    EXPECT_NEAR(h.xy, 0, 1e-5);
  }
}

// Gradient and Hessian against central differences, in model coordinates.
TEST(Volume, DerivativesAreThoseOfTheValues) {
  const VolumeGrid g = noise({12, 10, 9}, skewed_steps());
  const double d = 1e-5;
  for (const int degree : kDegrees) {
    const auto f = spline(g, {.level = 50, .degree = degree, .interpolate = true});
    for (const Vec3& p : inner_points(g, 40)) {
      const Gradient2 h = f->hessian(p);
      EXPECT_DOUBLE_EQ(h.value, f->value(p));
      EXPECT_EQ(h.gradient, f->gradient(p).gradient);
      for (int a = 0; a < 3; ++a) {
        Vec3 e(0);
        e[a] = d;
        EXPECT_NEAR((f->value(p + e) - f->value(p - e)) / (2 * d), h.gradient[a], 1e-4);
        const Vec3 column = (f->gradient(p + e).gradient - f->gradient(p - e).gradient) / (2 * d);
        EXPECT_NEAR(glm::distance(column, h.hessian_times(e / d)), 0, degree == 2 ? 0.1 : 0.05);
      }
    }
  }
}

// What a spline goes on as outside, for the planes that cut it, has its own derivatives.
TEST(Volume, DerivativesBeyondTheSides) {
  const VolumeGrid g = noise({9, 9, 9}, Mat3(0.5));
  const auto f = spline(g, {.level = 50});
  const double d = 1e-6;
  for (const Vec3& p : {Vec3(-0.3, 2.1, 1.7), Vec3(1.2, 4.4, -0.2), Vec3(4.3, -0.6, 4.1)}) {
    const Gradient2 h = f->hessian(p);
    EXPECT_DOUBLE_EQ(h.value, f->value(p));
    EXPECT_EQ(h.gradient, f->gradient(p).gradient);
    for (int a = 0; a < 3; ++a) {
      Vec3 e(0);
      e[a] = d;
      EXPECT_NEAR((f->value(p + e) - f->value(p - e)) / (2 * d), h.gradient[a], 1e-4);
    }
  }
}

TEST(Volume, DerivativesAreContinuous) {
  const VolumeGrid g = noise({9, 9, 9});
  const auto cubic = spline(g, {.level = 50}), quadratic = spline(g, {.level = 50, .degree = 2});
  const double d = 1e-7;
  for (int i = 1; i < 8; ++i) {
    // Cells of the cubic meet at samples, those of the quadratic halfway between.
    const Vec3 p(i, 3.3, 4.6), q(i + 0.5, 3.3, 4.6), e(d, 0, 0);
    const Gradient2 a = cubic->hessian(p - e), b = cubic->hessian(p + e);
    EXPECT_NEAR(a.xx, b.xx, 1e-3);
    EXPECT_NEAR(a.xy, b.xy, 1e-3);
    EXPECT_NEAR(
        glm::distance(quadratic->gradient(q - e).gradient, quadratic->gradient(q + e).gradient), 0,
        1e-3);
  }
}

TEST(Volume, RangeHoldsAllValues) {
  const VolumeGrid g = noise({40, 33, 70}, skewed_steps());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0, 1);
  for (const bool interpolate : {false, true}) {
    const auto f =
        spline(g, {.level = 50, .degree = interpolate ? 3 : 2, .interpolate = interpolate});
    for (const Vec3& p : inner_points(g, 30)) {
      for (const double size : {0.01, 1.0, 20.0}) {
        const Box3 box{p, p + size * Vec3(any(random), any(random), any(random))};
        const Interval r = f->range(box);
        EXPECT_GT(r.max, r.min);
        for (int k = 0; k < 100; ++k) {
          const Vec3 q = box.min + box.size() * Vec3(any(random), any(random), any(random));
          const Vec3 u = glm::inverse(g.steps) * q;
          if (u.x < 0 || u.y < 0 || u.z < 0 || u.x > 39 || u.y > 32 || u.z > 69) continue;
          EXPECT_TRUE(r.contains(f->value(q)));
        }
      }
    }
  }
}

TEST(Volume, RangeIsNarrow) {
  const VolumeGrid g = sampled_grid({100, 100, 100}, Vec3(0), Mat3(1), [](Vec3 p) { return p.x; });
  const auto f = spline(g, {.level = 50});
  const Interval small = f->range({Vec3(30.2), Vec3(30.4)}), large = f->range({Vec3(30), Vec3(60)});
  EXPECT_NEAR(small.max - small.min, 3, 1e-6);
  EXPECT_LE(large.max - large.min, 40);
}

TEST(Volume, SmoothingIsAGaussian) {
  // A Gaussian of width 2 smoothed by 1.5 is one of width 2.5, its peak (2/2.5)^3 as high.
  const VolumeGrid g = sampled_grid({41, 41, 41}, Vec3(-20), Mat3(1),
                                    [](Vec3 p) { return std::exp(-glm::dot(p, p) / 8); });
  const auto f =
      make_volume_function(g, {.level = 0.2, .interpolate = true, .smoothing = 1.5}, RunContext());
  for (const Vec3& p : {Vec3(0), Vec3(1, 2, 0.5), Vec3(3, -1, 2)}) {
    EXPECT_NEAR(f->value(p), 0.2 - 0.512 * std::exp(-glm::dot(p, p) / 12.5), 3e-4);
  }
}

TEST(Volume, BoundsHoldTheInside) {
  const VolumeGrid g = sampled_grid({60, 60, 60}, Vec3(-30), Mat3(1),
                                    [](Vec3 p) { return 10 - glm::length(p - Vec3(4, 0, 0)); });
  const auto f = make_volume_function(g, {.interpolate = true}, RunContext());
  EXPECT_FALSE(f->has_pieces());
  const Box3 b = f->bounds();
  EXPECT_LE(b.min.x, -6);
  EXPECT_GE(b.min.x, -9);
  EXPECT_GE(b.max.x, 14);
  EXPECT_LE(b.max.x, 17);
  EXPECT_GT(f->value({100, 0, 0}), 0);
  EXPECT_GT(f->value({-31, -31, 40}), 0);
}

TEST(Volume, RefusesWhatItCannotDo) {
  const VolumeGrid g = noise({4, 4, 4});
  const auto message = [&](const VolumeOptions& options) {
    try {
      make_volume_function(g, options, RunContext());
    } catch (const GeometryError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(message({.level = 1000}).find("outside the range of the data"), std::string::npos);
  EXPECT_EQ(message({.level = 50}), "");
  EXPECT_THROW(make_volume_function(g, {.level = 50, .degree = 4}, RunContext()), UsageError);
  EXPECT_THROW(make_volume_function(g, {.level = 50, .smoothing = -1}, RunContext()), UsageError);
  VolumeGrid bad = g;
  bad.samples.pop_back();
  EXPECT_THROW(make_volume_function(bad, {.level = 50}, RunContext()), UsageError);
  bad = g;
  bad.steps[2] = bad.steps[0] + bad.steps[1];
  EXPECT_THROW(make_volume_function(bad, {.level = 50}, RunContext()), UsageError);
  bad = g;
  bad.size = {64, 1, 1};
  EXPECT_THROW(make_volume_function(bad, {.level = 50}, RunContext()), UsageError);
  RunContext cancelled;
  cancelled.cancel();
  EXPECT_THROW(make_volume_function(g, {.level = 50, .interpolate = true}, cancelled), Cancelled);
}

// A ball sampled on a turned, stretched grid: radius, curvature and closedness of the surface.
TEST(Volume, ABallIsABall) {
  const Mat3 steps = skewed_steps();
  const Vec3 middle = steps * (0.5 * Vec3(63, 47, 23));
  const VolumeGrid g =
      sampled_grid({64, 48, 24}, Vec3(0), steps, [&](Vec3 p) { return glm::distance(p, middle); });
  RunContext context;
  auto f =
      make_volume_function(g, {.level = 12, .inside_above = false, .interpolate = true}, context);
  const ImplicitForm form(f, std::nullopt, context);
  const auto surface = form.realise({.tolerance = 0.01}, context);
  const ProxyMesh& proxy = surface->proxy();
  EXPECT_EQ(proxy.topology.component_closed.size(), 1u);
  double off = 0, bend = 0;
  for (const SurfacePoint& p : surface->cover({.count = 300}, context)) {
    off = std::max(off, std::abs(glm::distance(p.position, middle) - 12));
    const Frame frame = surface->frame(p);
    bend = std::max({bend, std::abs(frame.k1 * 12 - 1), std::abs(frame.k2 * 12 - 1)});
    EXPECT_GT(glm::dot(frame.normal, p.position - middle), 11.9);
  }
  EXPECT_LT(off, 2e-3);
  EXPECT_LT(bend, 0.05);
}

// A torus in ten specks of noise: the form is the torus alone, its contour that of the torus.
TEST(Volume, SpecksAreLeftOut) {
  std::mt19937 random(1);
  std::uniform_int_distribution<std::size_t> any(2, 57);
  VolumeGrid g = sampled_grid({60, 60, 60}, Vec3(-29.5), Mat3(1), [&](Vec3 p) {
    const Vec2 q(std::hypot(p.x, p.y) - 15, p.z);
    return std::max(-5.0, 5 - glm::length(q));
  });
  for (int i = 0; i < 10; ++i) {
    g.samples[(any(random) * 60 + any(random)) * 60 + static_cast<std::size_t>(i % 2)] = 60;
  }
  RunContext context;
  auto f = make_volume_function(g, {}, context);
  Diagnostics diagnostics;
  RealiseOptions options;
  options.tolerance = 0.02;
  options.diagnostics = &diagnostics;
  const auto all = ImplicitForm(f, std::nullopt, context).realise(options, context);
  EXPECT_GT(all->proxy().topology.component_closed.size(), 5u);
  EXPECT_FALSE(test::says(diagnostics, "implicit.specks"));
  diagnostics = {};
  const ImplicitForm form(f, std::nullopt, context, 0.2);
  EXPECT_NEAR(form.bounds(Mat3(1)).min.x, -20, 0.2);
  const auto torus = form.realise(options, context);
  EXPECT_EQ(torus->proxy().topology.component_closed.size(), 1u);
  ASSERT_EQ(diagnostics.entries().size(), 1u);
  EXPECT_EQ(diagnostics.entries()[0].code, "implicit.specks");
}

// Noise has all the sign patterns there are: its triangles are a closed manifold all the same.
TEST(Volume, NoiseIsAManifold) {
  RunContext context;
  const ImplicitForm form(make_volume_function(noise({24, 20, 22}), {.level = 50}, context),
                          std::nullopt, context);
  const auto surface = form.realise({.tolerance = 0.05}, context);
  for (const auto closed : surface->proxy().topology.component_closed) EXPECT_TRUE(closed);
  EXPECT_GT(surface->proxy().mesh.triangles.size(), 50'000u);
}

// A level set that leaves the data is closed by the planes of the turned box.
TEST(Volume, ClosedAtTheSidesOfTheData) {
  const Mat3 turn(glm::rotate(glm::dmat4(1), 0.7, glm::normalize(Vec3(1, 2, 3))));
  const Vec3 axis = turn[0];
  const VolumeGrid g = sampled_grid({31, 25, 25}, turn * Vec3(-15, -12, -12), turn, [&](Vec3 p) {
    return 6 - glm::length(p - glm::dot(p, axis) * axis);
  });
  RunContext context;
  auto f = make_volume_function(g, {.interpolate = true}, context);
  EXPECT_TRUE(f->has_pieces());
  const ImplicitForm form(f, std::nullopt, context);
  const auto surface = form.realise({.tolerance = 0.01}, context);
  const TriMesh& mesh = surface->proxy().mesh;
  // A cylinder of radius 6 and length 30.
  double volume = 0, along = 0;
  for (const Triangle& t : mesh.triangles) {
    volume +=
        glm::dot(mesh.positions[t[0]], glm::cross(mesh.positions[t[1]], mesh.positions[t[2]])) / 6;
  }
  for (const Vec3& p : mesh.positions) along = std::max(along, std::abs(glm::dot(p, axis)));
  EXPECT_NEAR(volume, M_PI * 36 * 30, 5);
  EXPECT_NEAR(along, 15, 1e-9);
  EXPECT_EQ(surface->proxy().region_count, 3);
}

}  // namespace
}  // namespace burin
