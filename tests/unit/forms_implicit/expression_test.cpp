/// Formulas: values, exact derivatives, intervals, bounds and pieces.

#include <burin/base/error.h>
#include <burin/base/rng.h>
#include <burin/forms/implicit/expression.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace burin {
namespace {

using namespace implicit;

const Expression kX = Expression::x(), kY = Expression::y(), kZ = Expression::z();

Vec3 random_point(std::uint64_t i, double size) {
  const Rng rng(7);
  return size * Vec3(2 * rng.uniform(3 * i) - 1, 2 * rng.uniform(3 * i + 1) - 1,
                     2 * rng.uniform(3 * i + 2) - 1);
}

struct Named {
  const char* name;
  Expression f;
};

/// Every operation and every solid at least once, smooth at random points of a cube of 2.
std::vector<Named> formulas() {
  const Expression p = kX * kY - kZ / (kX * kX + 2.0);
  return {
      {"polynomial", kX * kX * kY - 3.0 * kY * kZ + pow(kZ, 3.0) - 1.0},
      {"quotient", (kX + kY) / (kZ * kZ + 1.0) - 1.0 / (kX + 5.0)},
      {"powers", pow(kX + 4.0, 1.7) + pow(kY + 5.0, -2.0) + pow(kZ + 3.0, kX)},
      {"exponentials", exp(0.3 * p) + log(kX + 4.0) - implicit::sqrt(kY + 5.0)},
      {"trigonometry", sin(p) * cos(kY) + tan(0.3 * kZ) - atan(kX * kZ)},
      {"inverse", asin(0.3 * kX) + acos(0.25 * kY * kZ)},
      {"angle", atan2(kY + 0.5 * kZ, kX * kX + 0.3) + atan2(kX, 5.0) - atan2(3.0, kZ)},
      {"choices", min(kX, kY * kZ) + max(abs(kY), kX * kX) - round(kX)},
      {"sphere", sphere(1.3)},
      {"box", box(1, 2, 3)},
      {"round_box", round_box(1, 2, 3, 0.3)},
      {"cylinder", cylinder(1, 2)},
      {"cone", cone(1, 0.4, 2)},
      {"torus", torus(1.2, 0.5)},
      {"capsule", capsule(0.5, 1)},
      {"plane", plane(1, 2, 2, 0.5)},
      {"gyroid", gyroid(2, 0.3)},
      {"superquadric", superquadric(1, 1.5, 2, 0.7, 0.4)},
      {"blob", 1.0 - blob(0.8) - translate(blob(1), {1, 0.2, 0})},
      {"csg", subtract(unite(box(2, 2, 2), sphere(1.2)), rotate(cylinder(0.4, 5), {90, 20, 0}))},
      {"blend", smooth_subtract(smooth_unite(sphere(1), translate(sphere(1), {1, 1, 0}), 0.4),
                                smooth_intersect(box(1, 1, 9), cylinder(0.6, 8), 0.2), 0.3)},
      {"moved", mirror(scale(twist(box(1, 2, 3), 20), 1.3), {1, 1, 0.5})},
      {"repeated", offset(shell(repeat(sphere(0.4), {1.3, 0, 1.1}), 0.1), 0.02)},
  };
}

TEST(Expression, DerivativesAreThoseOfDifferences) {
  for (const auto& [name, e] : formulas()) {
    const auto f = make_function(e);
    int compared = 0;
    for (std::uint64_t i = 0; i < 200; ++i) {
      const Vec3 p = random_point(i, 2);
      constexpr double kStep = 1e-5;
      const Gradient2 at = f->hessian(p);
      if (!std::isfinite(at.value)) continue;
      bool smooth = true;  // differences across an edge of pieces say nothing
      Vec3 difference(0);
      Mat3 second(0);
      for (int a = 0; a < 3; ++a) {
        Vec3 step(0);
        step[a] = kStep;
        smooth = smooth && f->piece(p + step) == f->piece(p) && f->piece(p - step) == f->piece(p);
        const Gradient1 up = f->gradient(p + step), down = f->gradient(p - step);
        difference[a] = (up.value - down.value) / (2 * kStep);
        second[a] = (up.gradient - down.gradient) / (2 * kStep);
      }
      if (!smooth) continue;
      ++compared;
      const double size = 1 + glm::length(at.gradient) + glm::length(second[0]) +
                          glm::length(second[1]) + glm::length(second[2]);
      EXPECT_LT(glm::distance(difference, at.gradient), 1e-7 * size * size) << name;
      for (int a = 0; a < 3; ++a) {
        Vec3 unit(0);
        unit[a] = 1;
        EXPECT_LT(glm::distance(at.hessian_times(unit), second[a]), 1e-6 * size * size)
            << name << " at " << p.x << ' ' << p.y << ' ' << p.z;
      }
    }
    EXPECT_GT(compared, 150) << name;
  }
}

TEST(Expression, BatchesOfAnySizeAgreeToTheBit) {
  for (const auto& [name, e] : formulas()) {
    const auto f = make_function(e);
    std::vector<Vec3> points;
    for (std::uint64_t i = 0; i < 300; ++i) points.push_back(random_point(i, 2));
    std::vector<double> values(points.size());
    std::vector<Gradient1> gradients(points.size());
    std::vector<Gradient2> hessians(points.size());
    f->values(points, values);
    f->gradients(points, gradients);
    f->hessians(points, hessians);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (std::isnan(values[i])) continue;
      EXPECT_EQ(values[i], f->value(points[i])) << name;
      EXPECT_EQ(values[i], gradients[i].value) << name;
      EXPECT_EQ(values[i], hessians[i].value) << name;
      EXPECT_EQ(gradients[i].gradient, hessians[i].gradient) << name;
      const Gradient2 alone = f->hessian(points[i]);
      EXPECT_EQ(alone.gradient, hessians[i].gradient) << name;
      EXPECT_EQ(alone.xy, hessians[i].xy) << name;
      EXPECT_EQ(alone.zz, hessians[i].zz) << name;
    }
  }
}

TEST(Expression, ShortenedFunctionsAgreeToTheBit) {
  // Neighbouring blocks of a grid see a corner by different ones and have to find the same sign.
  int shortened = 0;
  for (const auto& [name, e] : formulas()) {
    const auto f = make_function(e);
    for (std::uint64_t i = 0; i < 100; ++i) {
      const Vec3 center = random_point(i, 1.5);
      const auto part = f->restricted({center - 0.2, center + 0.2});
      if (!part) continue;
      ++shortened;
      for (std::uint64_t j = 0; j < 5; ++j) {
        const Vec3 p = center + random_point(1000 + j, 0.2);
        const double v = f->value(p);
        if (std::isnan(v)) continue;
        EXPECT_EQ(v, part->value(p)) << name;
        EXPECT_LT(glm::distance(f->gradient(p).gradient, part->gradient(p).gradient), 1e-12);
      }
    }
  }
  EXPECT_GT(shortened, 300);
}

TEST(Expression, WhatChangesNothingIsLeftOut) {
  // The rotation by right angles multiplies by 0, 1 and -1.
  const Expression f = rotate(translate(sphere(1), {0, 0, 0.5}), {90, 0, 90});
  const auto g = make_function(f);
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Vec3 p = random_point(i, 2);
    EXPECT_NEAR(g->value(p), glm::distance(p, Vec3(0.5, 0, 0)) - 1, 1e-15);
  }
  // What is not defined stays so.
  EXPECT_TRUE(std::isnan(make_function(0.0 * implicit::sqrt(kX))->value({-1, 0, 0})));
}

TEST(Expression, IntervalsHoldTheValues) {
  for (const auto& [name, e] : formulas()) {
    const auto f = make_function(e);
    for (std::uint64_t i = 0; i < 60; ++i) {
      const Vec3 center = random_point(i, 2);
      const double half = 0.02 + 0.02 * static_cast<double>(i);
      const Box3 box{center - half, center + half};
      const Interval range = f->range(box);
      const auto part = f->restricted(box);
      for (std::uint64_t k = 0; k < 30; ++k) {
        const Vec3 p = center + random_point(1000 + k, half);
        const double v = f->value(p);
        if (std::isnan(v)) continue;
        EXPECT_GE(v, range.min - 1e-12 * (1 + std::abs(v))) << name;
        EXPECT_LE(v, range.max + 1e-12 * (1 + std::abs(v))) << name;
        if (part) {
          EXPECT_EQ(part->value(p), v) << name;
        }
      }
    }
  }
}

TEST(Expression, SlopesHoldTheDerivatives) {
  for (const auto& [name, e] : formulas()) {
    const auto f = make_function(e);
    int bounded = 0, boxes = 0;
    for (std::uint64_t i = 0; i < 60; ++i) {
      const Vec3 center = random_point(i, 2), direction = random_point(2000 + i, 1);
      const double half = 0.002 + 0.01 * static_cast<double>(i);
      const Interval slope = f->slope({center - half, center + half}, direction);
      boxes += half < 0.1;
      bounded += half < 0.1 && slope.max - slope.min < 1e3;
      for (std::uint64_t k = 0; k < 30; ++k) {
        const Vec3 p = center + random_point(1000 + k, half);
        const double s = glm::dot(f->gradient(p).gradient, direction);
        if (std::isnan(s)) continue;
        EXPECT_GE(s, slope.min - 1e-9 * (1 + std::abs(s))) << name;
        EXPECT_LE(s, slope.max + 1e-9 * (1 + std::abs(s))) << name;
      }
    }
    EXPECT_GE(2 * bounded, boxes) << name;
  }
}

TEST(Expression, SlopesAreTightInSmallBoxes) {
  for (const auto& [name, e] : formulas()) {
    const auto f = make_function(e);
    int close = 0, smooth = 0;
    for (std::uint64_t i = 0; i < 60; ++i) {
      const Vec3 p = random_point(i, 2), direction = random_point(2000 + i, 1);
      constexpr double kHalf = 1e-4;
      const Gradient2 g = f->hessian(p);
      const double bend = std::abs(g.xx) + std::abs(g.yy) + std::abs(g.zz) + std::abs(g.xy) +
                          std::abs(g.xz) + std::abs(g.yz);
      if (!std::isfinite(g.value + bend) || f->piece(p - kHalf) != f->piece(p + kHalf)) continue;
      ++smooth;
      const Interval s = f->slope({p - kHalf, p + kHalf}, direction);
      close += s.max - s.min < 100 * kHalf * (1 + bend + glm::length(g.gradient));
    }
    EXPECT_GE(10 * close, 9 * smooth) << name;
    EXPECT_GT(smooth, 30) << name;
  }
}

// Where they are no numbers, or jump, nothing is said.
TEST(Expression, SlopesTellNothingWhereTheFunctionBreaksOff) {
  const Box3 box{Vec3(-1), Vec3(1)};
  for (const Expression& e : {implicit::sqrt(kX), log(kX), asin(1.5 * kX), 1.0 / kX, tan(2 * kX),
                              round(kX), atan2(kX, kY), pow(kX, -0.5)}) {
    const Interval s = make_function(e)->slope(box, {1, 0, 0});
    EXPECT_EQ(s.min, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(s.max, std::numeric_limits<double>::infinity());
  }
}

TEST(Expression, SolidsAreDistancesAlongTheirNormals) {
  // A millimetre beside a face the value is a millimetre, inside and outside.
  const auto check = [](const Expression& e, Vec3 on, Vec3 normal) {
    const auto f = make_function(e);
    for (const double d : {-0.2, -0.01, 0.0, 0.01, 0.7}) {
      EXPECT_NEAR(f->value(on + d * normal), d, 1e-12);
    }
  };
  check(sphere(2), {2, 0, 0}, {1, 0, 0});
  check(box(1, 2, 3), {0.1, 0.2, -1.5}, {0, 0, -1});
  check(round_box(4, 4, 4, 1), Vec3(1 + 1 / std::sqrt(3.0)), Vec3(1 / std::sqrt(3.0)));
  check(cylinder(2, 5), {0, -2, 1}, {0, -1, 0});
  check(cone(3, 1, 2), {2, 0, 0}, Vec3(1, 0, 1) / std::sqrt(2.0));
  check(torus(3, 1), {0, 3, 1}, {0, 0, 1});
  check(capsule(1, 4), {0, 0, 3}, {0, 0, 1});
  check(plane(0, 0, 2, 1), {5, 5, 1}, {0, 0, 1});
  check(rotate(cylinder(2, 9), {90, 0, 0}), {2, 3, 0}, {1, 0, 0});
  check(scale(sphere(1), 3), {0, 3, 0}, {0, 1, 0});
  check(translate(sphere(1), {5, 6, 7}), {5, 6, 8}, {0, 0, 1});
}

TEST(Expression, RotatesInTheOrderOfOpenScad) {
  // About x, then y, then z: the z axis goes to -y, stays there, and then turns to x.
  const auto f = make_function(rotate(translate(sphere(0.5), {0, 0, 3}), {90, 0, 90}));
  EXPECT_NEAR(f->value({3, 0, 0}), -0.5, 1e-15);
}

TEST(Expression, SmoothUnionsHaveFilletsOfTheirRadius) {
  // Two walls at a right angle: the fillet is the quarter of a circle of the radius.
  const auto f = make_function(smooth_unite(plane(1, 0, 0, 0), plane(0, 1, 0, 0), 2));
  for (const double a : {0.1, 0.5, 1.0, 1.4}) {
    const Vec3 on(2 - 2 * std::cos(a), 2 - 2 * std::sin(a), 0.3);
    const Gradient2 g = f->hessian(on);
    EXPECT_NEAR(g.value, 0, 1e-14);
    EXPECT_NEAR(glm::distance(g.gradient, Vec3(std::cos(a), std::sin(a), 0)), 0, 1e-14);
    EXPECT_NEAR(g.xx + g.yy, -0.5, 1e-13);  // twice the mean curvature
  }
  EXPECT_EQ(f->value({0, 7, 0}), 0);
}

TEST(Expression, HessianOfATorusGivesItsCurvatures) {
  const auto f = make_function(torus(3, 1));
  for (const double a : {0.0, 0.4, 2.0, 3.0}) {
    const Gradient2 g = f->hessian({3 + std::cos(a), 0, std::sin(a)});
    EXPECT_NEAR(g.yy, std::cos(a) / (3 + std::cos(a)), 1e-12);  // along the big circle
    EXPECT_NEAR(g.xx + g.yy + g.zz, 1 + std::cos(a) / (3 + std::cos(a)), 1e-12);
  }
}

TEST(Expression, BoundsHoldTheInside) {
  for (const auto& [name, e] : formulas()) {
    const Box3 b = e.bounds();
    const auto f = make_function(e);
    for (std::uint64_t i = 0; i < 4000; ++i) {
      const Vec3 p = random_point(i, 8);
      if (!(f->value(p) <= 0)) continue;
      for (int a = 0; a < 3; ++a) {
        EXPECT_GE(p[a], b.min[a]) << name;
        EXPECT_LE(p[a], b.max[a]) << name;
      }
    }
  }
}

TEST(Expression, BoundsOfFormulasAreFoundByIntervals) {
  const Expression ellipsoid = kX * kX / 9.0 + kY * kY / 4.0 + square(kZ - 5.0) - 1.0;
  const Box3 b = ellipsoid.bounds();
  EXPECT_LT(glm::distance(b.min, Vec3(-3, -2, 4)), 1e-9);
  EXPECT_LT(glm::distance(b.max, Vec3(3, 2, 6)), 1e-9);
  EXPECT_EQ(plane(0, 0, 1, 0).bounds().max.x, std::numeric_limits<double>::infinity());
  EXPECT_NEAR(plane(0, 0, 1, 4).bounds().max.z, 4, 1e-9);
  EXPECT_NEAR(intersect(gyroid(2, 0.2), box(4, 4, 4)).bounds().max.x, 2, 0);
}

TEST(Expression, PiecesAreSmoothAndAgreeWhereTheyAreActive) {
  const auto f = make_function(subtract(box(2, 2, 2), sphere(1.2)));
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Vec3 p = random_point(i, 1.5), q = random_point(i + 9000, 1.5);
    const ImplicitFunction& piece = f->piece_function(p);
    EXPECT_FALSE(piece.has_pieces());
    EXPECT_EQ(piece.value(p), f->value(p));
    if (f->piece(p) == f->piece(q)) {
      EXPECT_EQ(&piece, &f->piece_function(q));
    }
  }
  // On the top and in the ball's hollow.
  EXPECT_NE(f->piece({0.9, 0.8, 1}), f->piece({0.1, 0.1, 0.9}));
  EXPECT_NEAR(f->piece_function({0.9, 0.8, 1}).value({5, 5, 3}), 2, 1e-15);
}

TEST(Expression, SquareRootsOfNothingHaveNoDerivative) {
  const Gradient2 g = make_function(sphere(1))->hessian(Vec3(0));
  EXPECT_EQ(g.value, -1);
  EXPECT_EQ(g.gradient, Vec3(0));
  EXPECT_EQ(g.xx, 0);
}

TEST(Expression, RefusesWhatMakesNoSense) {
  EXPECT_THROW(sphere(0), UsageError);
  EXPECT_THROW(sphere(std::nan("")), UsageError);
  EXPECT_THROW(box(1, -1, 1), UsageError);
  EXPECT_THROW(round_box(1, 2, 3, 0.6), UsageError);
  EXPECT_THROW(cone(0, 0, 1), UsageError);
  EXPECT_THROW(plane(0, 0, 0, 1), UsageError);
  EXPECT_THROW(scale(sphere(1), 0), UsageError);
  EXPECT_THROW(repeat(sphere(1), {-1, 0, 0}), UsageError);
  Expression deep = kX;
  EXPECT_THROW(for (int i = 0; i < 10'000; ++i) deep = sin(deep), UsageError);
}

TEST(Expression, ClippedFunctionsAreClosedByTheBox) {
  const auto f = clip(make_function(plane(0, 0, 1, 0)), {{-1, -1, -1}, {1, 1, 2}});
  EXPECT_NEAR(f->value({0, 0, 0.5}), 0.5, 0);
  EXPECT_NEAR(f->value({3, 0, -0.5}), 2, 0);
  EXPECT_EQ(f->gradient({3, 0, -0.5}).gradient, Vec3(1, 0, 0));
  EXPECT_NE(f->piece({0, 0, 0}), f->piece({1, 0.2, -0.5}));
  EXPECT_EQ(f->piece_function({1, 0.2, -0.5}).value({4, 9, 9}), 3);
  EXPECT_GT(f->range({{2, 0, 0}, {3, 1, 1}}).min, 0);
}

TEST(Expression, ConstantsFold) {
  const auto f = make_function(square(Expression(3.0)) + sin(Expression(0.5 * std::numbers::pi)));
  EXPECT_EQ(f->value({1, 2, 3}), 10);
  EXPECT_EQ(f->range(ImplicitFunction::everywhere()).min, 10);
}

}  // namespace
}  // namespace burin
