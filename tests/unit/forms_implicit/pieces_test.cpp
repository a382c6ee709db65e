/// Components of implicit surfaces that lie between the samples of a first look.

#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/implicit/volume_function.h>

#include "components.h"

#include <gtest/gtest.h>

namespace burin {
namespace {

using namespace implicit;

using test::around;
using test::find;
using test::Found;

Expression balls_and_a_speck(Vec3 speck, double radius) {
  Expression e = translate(sphere(radius), speck);
  for (int i = 0; i < 27; ++i) {
    e = unite(e, translate(sphere(1), 4.0 * Vec3(i % 3, i / 3 % 3, i / 9)));
  }
  return e;
}

TEST(ImplicitPieces, ABallFarFromOthersIsFound) {
  const Found found = find(balls_and_a_speck(Vec3(20), 0.1));
  EXPECT_EQ(found.components, 28u);
  EXPECT_TRUE(found.diagnostics.empty());
  const Box3 box = test::box_of(around(found.mesh, Vec3(20), 1));
  ASSERT_FALSE(box.empty());
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(box.size()[a], 0.2, 0.01);
}

// Of a 300th of the domain, wherever it lies between the samples.
TEST(ImplicitPieces, SmallOnesAreFoundAnywhere) {
  const Rng rng(3);
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Vec3 at = Vec3(11) + Vec3(rng.uniform(3 * i), rng.uniform(3 * i + 1), 0.2);
    const Expression e = unite(sphere(10), translate(sphere(22.0 / 600), at));
    const Found found = find(e, Box3{Vec3(-10.5), Vec3(12.5)});
    EXPECT_EQ(found.components, 2u) << at.x << ' ' << at.y;
    EXPECT_FALSE(found.says("implicit.may_miss"));
  }
}

TEST(ImplicitPieces, AHollowIsFound) {
  const Expression e = subtract(sphere(10), translate(sphere(0.04), {3, 2, 1}));
  EXPECT_EQ(find(e).components, 2u);
}

TEST(ImplicitPieces, OneBesideAWallIsNotTakenForIt) {
  const Expression e = unite(sphere(10), translate(sphere(0.05), {10.08, 0.03, 0.04}));
  EXPECT_EQ(find(e).components, 2u);
}

TEST(ImplicitPieces, WhatIsInsideOrUnitedIsNone) {
  EXPECT_EQ(find(unite(sphere(10), translate(sphere(0.04), {3, 2, 1}))).components, 1u);
  EXPECT_EQ(find(unite(sphere(10), translate(sphere(0.1), {10, 0, 0}))).components, 1u);
}

// Where the coefficients of a spline tell.
TEST(ImplicitPieces, AHumpOfASplineIsFound) {
  TrivariateSpline s;
  s.order = {4, 4, 4};
  constexpr int kSize = 200;
  for (std::size_t a = 0; a < 3; ++a) {
    s.size[a] = a == 0 ? kSize : 24;
    for (int k = 0; k < s.size[a] + 4; ++k) s.knots[a].push_back(k);
  }
  s.coefficients.assign(static_cast<std::size_t>(s.size[0]) * 24 * 24, 1);
  const auto put = [&](int x, double v) {
    for (int z = 11; z < 13; ++z) {
      for (int y = 11; y < 13; ++y) {
        s.coefficients[static_cast<std::size_t>((z * 24 + y) * kSize + x)] = v;
      }
    }
  };
  for (int x = 20; x < 60; ++x) put(x, -9);
  put(150, -5.2);
  const auto f = make_trivariate_function(s, 0);
  EXPECT_EQ(find(f).components, 2u);
}

TEST(ImplicitPieces, ThreadsChangeNothing) {
  Expression e = sphere(5);
  const Rng rng(5);
  for (std::uint64_t i = 0; i < 12; ++i) {
    const Vec3 to(rng.uniform(3 * i), rng.uniform(3 * i + 1), rng.uniform(3 * i + 2));
    e = unite(e, translate(sphere(0.02 + 0.005 * static_cast<double>(i)), Vec3(6) + 4.0 * to));
  }
  std::vector<Found> found;
  for (const int threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    found.push_back(find(e));
  }
  EXPECT_EQ(found[0].components, 13u);
  for (const Found& f : found) {
    EXPECT_EQ(f.mesh.positions, found[0].mesh.positions);
    EXPECT_EQ(f.mesh.triangles, found[0].mesh.triangles);
  }
}

TEST(ImplicitPieces, SaysWhereTheFunctionDoesNotTell) {
  // Zero on a ball without getting below.
  const Expression x = Expression::x() - 10.0, y = Expression::y(), z = Expression::z();
  const Expression touch = square(square(x) + square(y) + square(z) - 4.0);
  EXPECT_TRUE(
      find(unite(sphere(5), touch), Box3{Vec3(-8), Vec3(15, 8, 8)}).says("implicit.may_miss"));
}

TEST(ImplicitPieces, NothingIsSaidOfWhatIsWhole) {
  const Expression forms[] = {
      torus(3, 1),
      box(3, 4, 5),
      round_box(20, 20, 20, 0.01),
      cone(10, 0, 20),
      superquadric(5, 6, 7, 0.3, 0.2),
      twist(box(4, 6, 20), 12),
      subtract(box(20, 20, 20), rotate(cylinder(4, 40), {30, 40, 0})),
      smooth_unite(sphere(5), translate(sphere(4), {6, 0, 0}), 1),
      1.0 - blob(5) - translate(blob(4), {7, 0, 0}),
  };
  for (const Expression& e : forms) {
    const Found found = find(e);
    EXPECT_EQ(found.components, 1u);
    EXPECT_FALSE(found.says("implicit.may_miss"));
  }
}

}  // namespace
}  // namespace burin
