#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/mesh/curvature.h>

#include <burin_test/cad.h>
#include <burin_test/irregular.h>
#include <burin_test/jets.h>
#include <gtest/gtest.h>

#include <map>

namespace burin {
namespace {

struct Estimate {
  ProxyMesh proxy;
  std::vector<Curvature> curvature;
};

Estimate estimate(const TriMesh& mesh, CurvatureOptions options = {}) {
  const RunContext context;
  Estimate result;
  result.proxy = build_proxy(mesh, {}, context);
  result.curvature = estimate_curvature(result.proxy, options, context);
  return result;
}

/// Errors of k1 and k2 relative to the largest |k| of the shape, and of the direction in degrees
/// where |k1 - k2| is over a tenth of it.
struct Errors {
  std::vector<double> k1, k2, angle;
};

Errors curvature_errors(const Estimate& e, const test::ExactSurface& exact) {
  std::vector<test::ExactFrame> truth;
  double largest = 0;
  for (std::uint32_t w = 0; w < e.curvature.size(); ++w) {
    truth.push_back(exact(e.proxy.wedge_position(w)));
    largest = std::max({largest, std::abs(truth[w].k1), std::abs(truth[w].k2)});
  }
  Errors result;
  for (std::size_t w = 0; w < truth.size(); ++w) {
    const Curvature& c = e.curvature[w];
    result.k1.push_back(std::abs(c.k1 - truth[w].k1) / largest);
    result.k2.push_back(std::abs(c.k2 - truth[w].k2) / largest);
    if (truth[w].k1 - truth[w].k2 > 0.1 * largest) {
      result.angle.push_back(test::line_angle(c.d1, truth[w].d1));
    }
  }
  return result;
}

double confidence_at(const Estimate& e, double share) {
  std::vector<double> values;
  for (const Curvature& c : e.curvature) values.push_back(c.confidence);
  return test::quantile(values, share);
}

const test::ExactSurface kTorus = test::exact_torus(10, 4);
const Vec3 kHalf(10, 7, 5);
const test::ExactSurface kEllipsoid = test::exact_ellipsoid(kHalf);

TEST(IrregularMeshes, AreIrregular) {
  const TriMesh m = test::irregular_torus(10, 4, 20000);
  std::vector<int> valence(m.positions.size(), 0);
  for (const Triangle& t : m.triangles) {
    for (const std::uint32_t v : t) ++valence[v];
  }
  std::map<int, double> share;
  for (const int n : valence) share[n] += 1.0 / static_cast<double>(valence.size());
  EXPECT_LT(share[6], 0.6);
  EXPECT_GT(share[5], 0.15);
  EXPECT_GT(share[7], 0.15);
  EXPECT_GT(share[4] + share[8], 0.005);
}

class CurvatureAt100k : public testing::TestWithParam<bool> {};

TEST_P(CurvatureAt100k, IsWithinATenthPercentAndAFifthOfADegree) {
  const Errors e =
      GetParam() ? curvature_errors(estimate(test::irregular_torus(10, 4, 1e5)), kTorus)
                 : curvature_errors(estimate(test::irregular_ellipsoid(kHalf, 1e5)), kEllipsoid);
  EXPECT_LE(test::quantile(e.k1, 0.5), 1e-3);
  EXPECT_LE(test::quantile(e.k1, 0.95), 1e-2);
  EXPECT_LE(test::quantile(e.k2, 0.5), 1e-3);
  EXPECT_LE(test::quantile(e.k2, 0.95), 1e-2);
  EXPECT_LE(test::quantile(e.angle, 0.5), 0.2);
  EXPECT_LE(test::quantile(e.angle, 0.95), 1);
}

INSTANTIATE_TEST_SUITE_P(TorusAndEllipsoid, CurvatureAt100k, testing::Bool());

TEST(Curvature, AtTwoThousandTrianglesIsWithinFivePercentAndThreeDegrees) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    for (const bool torus : {true, false}) {
      const Errors e =
          torus ? curvature_errors(estimate(test::irregular_torus(10, 4, 2000, seed)), kTorus)
                : curvature_errors(estimate(test::irregular_ellipsoid(kHalf, 2000, seed)),
                                   kEllipsoid);
      EXPECT_LE(test::quantile(e.k1, 0.95), 0.05) << torus << seed;
      EXPECT_LE(test::quantile(e.k2, 0.95), 0.05) << torus << seed;
      EXPECT_LE(test::quantile(e.angle, 0.95), 3) << torus << seed;
    }
  }
}

TEST(Curvature, OfNoisyMeshesKeepsItsDirections) {
  for (const double triangles : {2000.0, 20000.0, 100000.0}) {
    const TriMesh torus = test::noisy(test::irregular_torus(10, 4, triangles), 0.05);
    const TriMesh ellipsoid = test::noisy(test::irregular_ellipsoid(kHalf, triangles), 0.05);
    EXPECT_LE(test::quantile(curvature_errors(estimate(torus), kTorus).angle, 0.95), 15)
        << triangles;
    EXPECT_LE(test::quantile(curvature_errors(estimate(ellipsoid), kEllipsoid).angle, 0.95), 15)
        << triangles;
  }
}

TEST(Curvature, WithoutSmoothingDrownsInNoise) {
  const TriMesh torus = test::noisy(test::irregular_torus(10, 4, 1e5), 0.05);
  EXPECT_GT(test::quantile(curvature_errors(estimate(torus, {.smoothing = 0}), kTorus).angle, 0.95),
            30);
  EXPECT_LT(test::quantile(curvature_errors(estimate(torus, {.smoothing = 8}), kTorus).angle, 0.95),
            15);
}

TEST(Curvature, OfASphereIsPositiveAndHasNoDirection) {
  for (const double noise : {0.0, 0.05}) {
    const Estimate e = estimate(test::noisy(test::irregular_ellipsoid(Vec3(10), 20000), noise));
    std::vector<double> k1, k2;
    for (const Curvature& c : e.curvature) {
      k1.push_back(c.k1);
      k2.push_back(c.k2);
    }
    EXPECT_NEAR(test::quantile(k1, 0.5), 0.1, noise > 0 ? 0.01 : 1e-4);
    EXPECT_NEAR(test::quantile(k2, 0.5), 0.1, noise > 0 ? 0.01 : 1e-4);
    EXPECT_LT(confidence_at(e, 0.95), 0.1) << noise;
  }
}

TEST(Curvature, OfPlanesAndNoiseHasNoDirection) {
  const TriMesh plane = test::grid(150, 150, false, false, [](std::uint32_t i, std::uint32_t j) {
    return Vec3(i + 0.3 * (j % 3), j, 0);
  });
  EXPECT_EQ(confidence_at(estimate(plane), 1), 0);
  for (const double noise : {1e-6, 1e-3, 0.05}) {
    EXPECT_LT(confidence_at(estimate(test::noisy(plane, noise)), 0.95), 0.1) << noise;
  }
}

TEST(Curvature, OfToriAndEllipsoidsIsConfident) {
  EXPECT_GT(confidence_at(estimate(test::irregular_torus(10, 4, 2000)), 0.05), 0.95);
  EXPECT_GT(confidence_at(estimate(test::irregular_torus(10, 4, 20000)), 0.02), 0.95);
  EXPECT_GT(confidence_at(estimate(test::noisy(test::irregular_torus(10, 4, 20000), 0.02)), 0.05),
            0.9);
  EXPECT_GT(confidence_at(estimate(test::irregular_ellipsoid(kHalf, 20000)), 0.1), 0.95);
}

TEST(Curvature, OfAFacetedCylinderIsExact) {
  for (const std::uint32_t n : {16u, 24u, 64u}) {
    const Estimate e = estimate(test::cylinder(5, 40, n));
    for (std::uint32_t w = 0; w < e.curvature.size(); ++w) {
      const Curvature& c = e.curvature[w];
      const Vec3 normal = e.proxy.wedge_normal[w];
      EXPECT_NEAR(glm::dot(glm::cross(c.d1, c.d2), normal), 1, 1e-12);
      if (std::abs(normal.z) > 0.5) {
        EXPECT_EQ(c.k1, 0);
        EXPECT_EQ(c.k2, 0);
        EXPECT_EQ(c.confidence, 0);
      } else {
        EXPECT_NEAR(c.k1, 0.2, 1e-12);
        EXPECT_NEAR(c.k2, 0, 1e-12);
        EXPECT_NEAR(std::abs(c.d2.z), 1, 1e-12);
        EXPECT_EQ(c.confidence, 1);
      }
    }
  }
}

TEST(Curvature, OfAConcaveCylinderIsNegative) {
  TriMesh tube = test::cylinder(5, 40, 32);
  for (Triangle& t : tube.triangles) std::swap(t[1], t[2]);
  const Estimate e = estimate(tube);
  for (std::uint32_t w = 0; w < e.curvature.size(); ++w) {
    if (std::abs(e.proxy.wedge_normal[w].z) > 0.5) continue;
    EXPECT_NEAR(e.curvature[w].k1, 0, 1e-12);
    EXPECT_NEAR(e.curvature[w].k2, -0.2, 1e-12);
    EXPECT_NEAR(std::abs(e.curvature[w].d1.z), 1, 1e-12);
  }
}

TEST(Curvature, OfAFilletIsThatOfItsRadiusAndEndsAtTheFlatFaces) {
  const test::CadShape shape = test::filleted_edge(2, 50, 30, 6, 1);
  const Estimate e = estimate(shape.mesh);
  for (std::uint32_t w = 0; w < e.curvature.size(); ++w) {
    const Curvature& c = e.curvature[w];
    const std::uint32_t row =
        e.proxy.wedge_vertex[w] / 2;  // 0 and 8 far on the flats, 1 and 7 where the fillet ends
    if (row == 0 || row == 8) {
      EXPECT_EQ(c.k1, 0);
      EXPECT_EQ(c.k2, 0);
      EXPECT_EQ(c.confidence, 0);
      continue;
    }
    if (row != 1 && row != 7) {
      EXPECT_NEAR(c.k1, 0.5, 1e-12);
    }
    EXPECT_GT(c.k1, 0);
    EXPECT_NEAR(c.k2, 0, 1e-12);
    EXPECT_NEAR(std::abs(c.d2.y), 1, 1e-12);
    EXPECT_GT(c.confidence, 0.99);
  }
}

TEST(Curvature, AgreesWithJets) {
  const Estimate e = estimate(test::irregular_ellipsoid(kHalf, 20000));
  const std::vector<Curvature> jets = test::jet_curvature(e.proxy);
  ASSERT_EQ(jets.size(), e.curvature.size());
  const double largest = 10.0 / 25;
  std::vector<double> k1, k2, angle, jet_angle;
  for (std::uint32_t w = 0; w < jets.size(); ++w) {
    k1.push_back(std::abs(jets[w].k1 - e.curvature[w].k1) / largest);
    k2.push_back(std::abs(jets[w].k2 - e.curvature[w].k2) / largest);
    if (jets[w].k1 - jets[w].k2 < 0.1 * largest) continue;
    angle.push_back(test::line_angle(jets[w].d1, e.curvature[w].d1));
    jet_angle.push_back(test::line_angle(jets[w].d1, kEllipsoid(e.proxy.wedge_position(w)).d1));
  }
  EXPECT_LT(test::quantile(jet_angle, 0.95), 0.1);  // the measure itself is right
  EXPECT_LT(test::quantile(k1, 0.5), 0.003);
  EXPECT_LT(test::quantile(k1, 0.95), 0.015);
  EXPECT_LT(test::quantile(k2, 0.5), 0.003);
  EXPECT_LT(test::quantile(k2, 0.95), 0.015);
  EXPECT_LT(test::quantile(angle, 0.5), 0.2);
  EXPECT_LT(test::quantile(angle, 0.95), 1);
}

TEST(Curvature, DoesNotDependOnScalePlaceAndTurn) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Mat3 turn(c, s, 0, -s, c, 0, 0, 0, 1);
  const TriMesh meshes[] = {test::irregular_torus(10, 4, 5000),
                            test::noisy(test::irregular_torus(10, 4, 5000), 0.05),
                            test::turned(20, 1, 15, 64, 6).mesh};
  for (const TriMesh& mesh : meshes) {
    const Estimate base = estimate(mesh);
    double largest = 0;
    for (const Curvature& k : base.curvature) largest = std::max(largest, std::abs(k.k1));
    const auto check = [&](const std::function<Vec3(Vec3)>& map, const Mat3& rotation, double scale,
                           double tolerance) {
      const Estimate other = estimate(test::mapped(mesh, map));
      ASSERT_EQ(other.curvature.size(), base.curvature.size());
      for (std::size_t w = 0; w < base.curvature.size(); ++w) {
        const Curvature &a = base.curvature[w], &b = other.curvature[w];
        ASSERT_NEAR(a.k1, b.k1 * scale, tolerance * largest) << w;
        ASSERT_NEAR(a.k2, b.k2 * scale, tolerance * largest) << w;
        ASSERT_NEAR(a.confidence, b.confidence, 1e-3) << w;
        if (a.k1 - a.k2 > 0.05 * largest) {
          ASSERT_LT(test::line_angle(rotation * a.d1, b.d1), 1e3 * tolerance) << w;
        }
      }
    };
    check([](Vec3 p) { return p * 1e-3; }, Mat3(1), 1e-3, 1e-8);
    check([](Vec3 p) { return p * 1e4; }, Mat3(1), 1e4, 1e-8);
    check([&](Vec3 p) { return turn * p; }, turn, 1, 1e-8);
    check([](Vec3 p) { return p + Vec3(1e5, -1e5, 1e5); }, Mat3(1), 1, 1e-5);
  }
}

TEST(Curvature, IsTheSameForAnyNumberOfThreads) {
  const TriMesh mesh = test::noisy(test::irregular_torus(10, 4, 30000), 0.05);
  const Estimate many = estimate(mesh);
  const ThreadLimit one(1);
  const Estimate single = estimate(mesh);
  for (std::size_t w = 0; w < many.curvature.size(); ++w) {
    const Curvature &a = many.curvature[w], &b = single.curvature[w];
    ASSERT_EQ(a.k1, b.k1);
    ASSERT_EQ(a.k2, b.k2);
    ASSERT_EQ(a.d1, b.d1);
    ASSERT_EQ(a.d2, b.d2);
    ASSERT_EQ(a.confidence, b.confidence);
  }
}

TEST(Curvature, StopsWhenCancelled) {
  RunContext context;
  const ProxyMesh proxy = build_proxy(test::torus(10, 3, 60, 40), {}, context);
  context.cancel();
  EXPECT_THROW(estimate_curvature(proxy, {}, context), Cancelled);
}

}  // namespace
}  // namespace burin
