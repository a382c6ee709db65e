#include <burin/base/parallel.h>
#include <burin/mesh/proxy_mesh.h>

#include <burin_test/cad.h>
#include <burin_test/irregular.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

ProxyMesh proxy_of(TriMesh mesh) {
  const RunContext context;
  return build_proxy(std::move(mesh), {}, context);
}

/// Degrees between wedge normals and the true normals of their vertices.
std::vector<double> errors(const ProxyMesh& proxy, const std::vector<Vec3>& truth) {
  std::vector<double> result;
  for (std::size_t w = 0; w < proxy.wedge_vertex.size(); ++w) {
    result.push_back(test::line_angle(proxy.wedge_normal[w], truth[proxy.wedge_vertex[w]]));
  }
  return result;
}

std::vector<double> errors(const ProxyMesh& proxy, const test::ExactSurface& truth) {
  std::vector<Vec3> normals;
  for (const Vec3& p : proxy.mesh.positions) normals.push_back(truth(p).normal);
  return errors(proxy, normals);
}

TEST(Normals, OfFacetedCylindersAreRadialAndThoseOfCapsExact) {
  for (const std::uint32_t n : {13u, 16u, 32u, 64u}) {
    for (const double height : {1.0, 20.0, 200.0}) {
      const ProxyMesh proxy = proxy_of(test::cylinder(5, height, n));
      ASSERT_EQ(proxy.region_count, 3);
      for (std::uint32_t w = 0; w < proxy.wedge_vertex.size(); ++w) {
        const Vec3 normal = proxy.wedge_normal[w], p = proxy.wedge_position(w);
        if (std::abs(normal.z) > 0.5) {
          ASSERT_EQ(normal, Vec3(0, 0, p.z > 0 ? 1 : -1));
        } else {
          ASSERT_LT(test::line_angle(normal, {p.x, p.y, 0}), 1e-10);
        }
      }
    }
  }
}

TEST(Normals, WhereAFilletRunsIntoAFlatFaceAreThoseOfTheFace) {
  for (const double width : {50.0, 10.0}) {
    for (const std::uint32_t facets : {4u, 8u}) {
      for (const std::uint32_t along : {1u, 3u}) {
        const test::CadShape shape = test::filleted_edge(2, width, 30, facets, along);
        EXPECT_LT(test::quantile(errors(proxy_of(shape.mesh), shape.normals), 1), 1e-10)
            << width << ' ' << facets << ' ' << along;
      }
    }
  }
}

TEST(Normals, OfTheFlatFacesOfARoundedBoxAreTheirsInTheirCornersToo) {
  for (const Vec3 half : {Vec3(24, 21, 12), Vec3(24, 21, 100), Vec3(10, 10, 10)}) {
    for (const std::uint32_t facets : {3u, 4u, 8u}) {
      const test::CadShape shape = test::rounded_box(half, 5, facets);
      const ProxyMesh proxy = proxy_of(shape.mesh);
      double flat = 0;
      for (std::size_t w = 0; w < proxy.wedge_vertex.size(); ++w) {
        const Vec3 truth = shape.normals[proxy.wedge_vertex[w]];
        if (std::max({std::abs(truth.x), std::abs(truth.y), std::abs(truth.z)}) < 1 - 1e-12)
          continue;
        flat = std::max(flat, test::line_angle(proxy.wedge_normal[w], truth));
      }
      EXPECT_LT(flat, 1e-6) << half.x << ' ' << half.z << ' ' << facets;
    }
  }
}

// A round boss on a plate that is only 3 mm wider than its fillet, which has facets of 1.5 mm.
// There width does not tell the plate from the fillet; before and behind it does.
TEST(Normals, OfAFlatFaceAreItsOwnWhereItIsNarrowToo) {
  constexpr std::uint32_t kSides = 24, kRim = 1;
  constexpr double kBoss = 23, kFillet = 3;
  for (const double half : {29.0, 40.0}) {
    const TriMesh mesh = test::grid(kSides, 6, true, false, [&](std::uint32_t i, std::uint32_t j) {
      const double u = 2 * test::kPi * i / kSides, v = (j - kRim) * test::kPi / 6;
      const Vec3 out(std::cos(u), std::sin(u), 0);
      if (j < kRim) return std::min(40 / std::abs(out.x), half / std::abs(out.y)) * out;
      if (j == 5) return kBoss * out + Vec3(0, 0, 10);
      return (kBoss + kFillet * (1 - std::sin(v))) * out + Vec3(0, 0, kFillet * (1 - std::cos(v)));
    });
    const ProxyMesh proxy = proxy_of(mesh);
    for (std::uint32_t w = 0; w < proxy.wedge_vertex.size(); ++w) {
      const Vec3 p = proxy.wedge_position(w);
      if (p.z > 0) continue;
      EXPECT_EQ(proxy.wedge_normal[w], Vec3(0, 0, 1)) << half << ' ' << p.x << ' ' << p.y;
    }
  }
}

TEST(Normals, OfAFilletedRimFollowCapFilletAndSide) {
  const test::CadShape shape = test::turned(20, 1, 15, 64, 6);
  const ProxyMesh proxy = proxy_of(shape.mesh);
  ASSERT_EQ(proxy.region_count, 1);
  const std::vector<double> e = errors(proxy, shape.normals);
  EXPECT_LT(test::quantile(e, 1), 0.5);
  for (std::size_t w = 0; w < e.size(); ++w) {
    const Vec3 n = shape.normals[proxy.wedge_vertex[w]];
    // Rim of the cap, rim of the side: exact, though the fillet's first facets lean by 7.5 degrees.
    if (n.z == 1 || n.z < 1e-9) {
      EXPECT_LT(e[w], 1e-9);
    }
  }
}

TEST(Normals, OfLongLeaningTrianglesStayNearTheTruth) {
  for (const double height : {1.0, 20.0}) {
    for (const std::uint32_t above : {24u, 33u, 60u}) {
      const test::CadShape shape = test::uneven_rims(5, height, 32, above);
      EXPECT_LT(test::quantile(errors(proxy_of(shape.mesh), shape.normals), 1), 3)
          << height << ' ' << above;
    }
  }
}

TEST(Normals, OfCountersinksWrittenWithFewDigitsAreThoseOfTheCone) {
  // Quads that are planar but for the digits of the file, and two rims alone.
  const auto cone = test::grid(40, 2, true, false, [](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * test::kPi * i / 40, r = 1.65 + 0.5 * j;
    const Vec3 p(50 + r * std::cos(u), 30 + r * std::sin(u), 6 + 0.5 * j);
    return glm::round(p * 1e4) / 1e4;
  });
  const auto truth = [](Vec3 p) {
    const Vec3 radial = glm::normalize(Vec3(p.x - 50, p.y - 30, 0));
    return test::ExactFrame{glm::normalize(radial - Vec3(0, 0, 1)), 0, 0, radial};
  };
  EXPECT_LT(test::quantile(errors(proxy_of(cone), truth), 1), 2);
}

TEST(Normals, ConvergeOnIrregularMeshes) {
  const auto torus = test::exact_torus(10, 4);
  const std::vector<double> coarse = errors(proxy_of(test::irregular_torus(10, 4, 5000)), torus);
  const std::vector<double> fine = errors(proxy_of(test::irregular_torus(10, 4, 50000)), torus);
  EXPECT_LT(test::quantile(coarse, 0.5), 0.15);
  EXPECT_LT(test::quantile(coarse, 0.95), 0.35);
  // Ten times the triangles: a tenth of the error.
  EXPECT_LT(test::quantile(fine, 0.5), 0.13 * test::quantile(coarse, 0.5));
  EXPECT_LT(test::quantile(fine, 0.95), 0.13 * test::quantile(coarse, 0.95));
}

TEST(Normals, AndCreasesDoNotDependOnScalePlaceAndTurn) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Mat3 turn(c, s, 0, -s, c, 0, 0, 0, 1);
  const TriMesh meshes[] = {test::irregular_torus(10, 4, 5000), test::cylinder(5, 20, 48),
                            test::turned(20, 1, 15, 64, 6).mesh};
  for (const TriMesh& mesh : meshes) {
    const ProxyMesh base = proxy_of(mesh);
    const auto check = [&](const std::function<Vec3(Vec3)>& map, const Mat3& rotation,
                           double degrees) {
      const ProxyMesh other = proxy_of(test::mapped(mesh, map));
      EXPECT_EQ(other.edge_kind, base.edge_kind);
      ASSERT_EQ(other.wedges, base.wedges);
      for (std::size_t w = 0; w < base.wedge_normal.size(); ++w) {
        ASSERT_LT(test::line_angle(rotation * base.wedge_normal[w], other.wedge_normal[w]),
                  degrees);
      }
    };
    check([](Vec3 p) { return p * 1e-3; }, Mat3(1), 1e-9);
    check([](Vec3 p) { return p * 1e4; }, Mat3(1), 1e-9);
    check([&](Vec3 p) { return turn * p; }, turn, 1e-9);
    // Coordinates of 1e5 are known to 1e-11 only.
    check([](Vec3 p) { return p + Vec3(1e5, -1e5, 1e5); }, Mat3(1), 1e-6);
  }
}

TEST(Normals, AreTheSameForAnyNumberOfThreads) {
  const TriMesh mesh = test::noisy(test::irregular_torus(10, 4, 20000), 0.02);
  const ProxyMesh many = proxy_of(mesh);
  const ThreadLimit one(1);
  const ProxyMesh single = proxy_of(mesh);
  EXPECT_EQ(many.edge_kind, single.edge_kind);
  EXPECT_EQ(many.wedges, single.wedges);
  EXPECT_EQ(many.face_region, single.face_region);
  EXPECT_EQ(many.wedge_normal, single.wedge_normal);
  EXPECT_EQ(many.wedge_sagitta, single.wedge_sagitta);
}

}  // namespace
}  // namespace burin
