#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/converters/mesh_reader.h>

#include <burin_test/cad.h>
#include <burin_test/fields.h>
#include <burin_test/irregular.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

using test::cross_angle;
using test::kPi;
using test::Probe;
using test::quantile;
using test::Smoothed;

/// Degrees off the exact principal cross, all over the surface.
std::vector<double> errors(const Smoothed& s, const test::ExactSurface& exact,
                           std::uint32_t stride = 1) {
  std::vector<double> result;
  for (const Probe& p : test::probes(*s.surface, stride)) {
    const auto d = s.at(p);
    const test::ExactFrame e = exact(p.point.position);
    result.push_back(d ? cross_angle(*d, e.d1, e.normal) : 45);
  }
  return result;
}

TEST(SmoothedField, ACylinderWithCaps) {
  const Smoothed s(test::cylinder(2, 5, 48));
  Vec3 cap(0);
  for (const Probe& p : test::probes(*s.surface)) {
    const auto d = s.at(p);
    ASSERT_TRUE(d);
    if (std::abs(p.frame.normal.z) < 0.5) {
      EXPECT_LT(test::line_angle(*d, glm::cross(Vec3(0, 0, 1), p.frame.normal)), 1e-6);
      EXPECT_LT(test::line_angle(*s.at(p, 2), {0, 0, 1}), 1e-6);
    } else {
      if (cap == Vec3(0)) cap = *d;
      EXPECT_LT(test::line_angle(*d, cap), 1e-9) << "a cap has one direction";
    }
  }
}

TEST(SmoothedField, ACylinderWithUnevenRims) {
  const Smoothed s(test::uneven_rims(1, 3, 36, 48).mesh);
  for (const Probe& p : test::probes(*s.surface)) {
    const auto d = s.at(p);
    ASSERT_TRUE(d);
    EXPECT_LT(cross_angle(*d, {0, 0, 1}, p.frame.normal), 2);
  }
}

TEST(SmoothedField, AConeFollowsCirclesAndRulings) {
  const std::uint32_t n = 40;
  const Smoothed s(test::grid(n, 2, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * kPi * i / n, r = j ? 1 : 3;
    return Vec3(r * std::cos(u), r * std::sin(u), 2.0 * j);
  }));
  for (const Probe& p : test::probes(*s.surface)) {
    const auto d = s.at(p);
    ASSERT_TRUE(d);
    // Inside a flat facet circles and rulings turn by up to the facet's share of the unrolled cone.
    const Vec3 around = glm::cross(Vec3(0, 0, 1), p.point.position);
    EXPECT_LT(cross_angle(*d, around, p.frame.normal), 360.0 / n / 2);
    EXPECT_LT(test::line_angle(*d, around), 10) << "family 1 bends most";
  }
}

TEST(SmoothedField, ATorusKeepsItsPrincipalDirections) {
  for (const bool irregular : {false, true}) {
    const Smoothed s(irregular ? test::irregular_torus(1, 0.4, 20000)
                               : test::torus(1, 0.4, 160, 60));
    const std::vector<double> e = errors(s, test::exact_torus(1, 0.4));
    EXPECT_LT(quantile(e, 0.5), 0.5);
    EXPECT_LT(quantile(e, 0.95), 1.0);
    EXPECT_LT(quantile(e, 1.0), 5.0);
    EXPECT_EQ(s.index_sum(), 0);
    EXPECT_TRUE(s.field->singularities(0).empty());
    for (const Probe& p : test::probes(*s.surface, 7)) {
      const test::ExactFrame exact = test::exact_torus(1, 0.4)(p.point.position);
      EXPECT_LT(test::line_angle(*s.at(p), exact.d1), 10) << "family 1 runs around the tube";
    }
  }
}

TEST(SmoothedField, ASphereFollowsTheFallback) {
  const Vec3 axis = glm::normalize(Vec3(0.3, -0.5, 0.8));
  const Smoothed s(test::icosphere(2, 24), {.fallback = axis});
  std::vector<double> off;
  for (const Probe& p : test::probes(*s.surface)) {
    const Vec3 n = glm::normalize(p.point.position);
    if (std::abs(glm::dot(n, axis)) > 0.7) continue;
    const auto d = s.at(p);
    ASSERT_TRUE(d);
    off.push_back(test::line_angle(*d, reject(axis, n)));
  }
  EXPECT_LT(quantile(off, 0.5), 3);
  EXPECT_LT(quantile(off, 0.95), 12);
  EXPECT_EQ(s.index_sum(), 8) << "four times the Euler characteristic";
}

TEST(SmoothedField, IndicesOfClosedSurfacesSumToFourTimesTheirEulerCharacteristic) {
  EXPECT_EQ(Smoothed(test::ellipsoid({1, 0.7, 0.5}, 60, 40)).index_sum(), 8);
  EXPECT_EQ(Smoothed(test::noisy(test::icosphere(1, 20), 0.04)).index_sum(), 8);
  EXPECT_EQ(Smoothed(test::irregular_torus(1, 0.45, 8000)).index_sum(), 0);
}

TEST(SmoothedField, RealSurfacesOfGenusTwo) {
  const auto path = test::data("mesh/cgal/eight.off");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  RunContext context;
  const Scene scene = read_mesh(path, context);
  const auto surface = scene.parts[0].form->realise({.crease_angle = 180}, context);
  const field::SmoothedField f({surface.get()}, {}, context);
  int sum = 0;
  for (const field::Singularity& s : f.singularities(0)) sum += s.index;
  EXPECT_EQ(sum, -8);
}

TEST(SmoothedField, IsSingularOnlyNearSingularities) {
  const Smoothed s(test::icosphere(1, 16));
  const auto singular = s.field->singularities(0);
  ASSERT_FALSE(singular.empty());
  const auto nothing = [&](std::uint32_t face) {
    int count = 0;
    for (int i = 0; i < 40; ++i) {
      for (int j = 0; i + j < 40; ++j) {
        const Vec3 bary((i + 0.3) / 40.6, (j + 0.3) / 40.6, (39 - i - j + 0.3) / 40.6);
        count += !s.at(Probe(*s.surface, {face, bary / (bary.x + bary.y + bary.z)}));
      }
    }
    return count / 820.0;
  };
  for (const field::Singularity& x : singular) {
    EXPECT_GT(nothing(x.face), 0.0);
    EXPECT_LT(nothing(x.face), 0.3);
  }
  for (std::uint32_t f = 0; f < 200; ++f) {
    const bool is =
        std::any_of(singular.begin(), singular.end(), [&](auto x) { return x.face == f; });
    if (!is) {
      EXPECT_EQ(nothing(f), 0) << f;
    }
  }
}

TEST(SmoothedField, FlatFacesHaveOneDirectionAlongTheirEdges) {
  // A prism over an L: in the model's axes, and turned in its plane by 20 degrees.
  const std::vector<Vec2> outline = {{0, 0}, {6, 0}, {6, 1}, {1, 1}, {1, 4}, {0, 4}};
  for (const double angle : {0.0, 20.0}) {
    const double a = angle * kPi / 180;
    const Vec3 x(std::cos(a), std::sin(a), 0), y(-std::sin(a), std::cos(a), 0);
    TriMesh m;
    for (const double z : {0.0, 2.0}) {
      for (const Vec2 p : outline) m.positions.push_back(p.x * x + p.y * y + Vec3(0, 0, z));
    }
    const Triangle cap[4] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    for (const Triangle& t : cap) {
      m.triangles.push_back({t[0], t[2], t[1]});
      m.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
    }
    for (std::uint32_t i = 0; i < 6; ++i) {
      const std::uint32_t j = (i + 1) % 6;
      m.triangles.push_back({i, j, j + 6});
      m.triangles.push_back({i, j + 6, i + 6});
    }
    const Smoothed s(m);
    for (const Probe& p : test::probes(*s.surface)) {
      const Vec3 n = p.frame.normal;
      const Vec3 along = std::abs(n.z) > 0.5 ? x : Vec3(0, 0, 1);
      EXPECT_LT(cross_angle(*s.at(p), along, n), 1e-9);
      EXPECT_GE(s.field->flat_patches(0)[p.point.triangle], 0);
    }
  }
}

TEST(SmoothedField, FlatFacesGoOverIntoFilletsCalmly) {
  const Smoothed s(test::filleted_edge(1, 8, 10, 6, 4).mesh);
  int flat = 0, curved = 0;
  for (const Probe& p : test::probes(*s.surface)) {
    EXPECT_LT(cross_angle(*s.at(p), {0, 1, 0}, p.frame.normal), 0.1);
    EXPECT_LT(std::abs(s.at(p)->y), 0.1) << "family 1 crosses the bend, on the flat parts too";
    ++(s.field->flat_patches(0)[p.point.triangle] >= 0 ? flat : curved);
  }
  EXPECT_EQ(flat, 16);
  EXPECT_EQ(curved, 48);
}

// The foot of a hood: a square with rounded corners, half as large on top. The two smooth sides of
// a wall point at no centre, though one is as far from both as from a circle.
TEST(SmoothedField, WallsThatNarrowBetweenRoundCornersHaveNoStar) {
  constexpr std::uint32_t kCorner = 8;  // vertices of each rounded corner
  const Smoothed s(test::grid(4 * kCorner, 2, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t quarter = i / kCorner;
    const double u = 0.5 * kPi * (quarter + double(i % kCorner) / (kCorner - 1));
    const double x = quarter == 0 || quarter == 3 ? 25 : -25, y = quarter < 2 ? 25 : -25;
    const Vec2 foot(x + 10 * std::cos(u), y + 10 * std::sin(u));
    return Vec3(j ? 0.5 * foot : foot, 20.0 * j);
  }));
  for (const Probe& p : test::probes(*s.surface)) {
    if (std::max(std::abs(p.frame.normal.x), std::abs(p.frame.normal.y)) < 0.752) continue;
    const auto d = s.at(p);
    ASSERT_TRUE(d);
    EXPECT_LT(cross_angle(*d, glm::cross(Vec3(0, 0, 1), p.frame.normal), p.frame.normal), 30);
  }
}

TEST(SmoothedField, ATurnedPartFollowsItsCircles) {
  const Smoothed s(test::turned(5, 1, 8, 64, 6).mesh);
  int tops = 0;
  for (const Probe& p : test::probes(*s.surface)) {
    const auto d = s.at(p);
    ASSERT_TRUE(d);
    const Vec3 around = glm::cross(Vec3(0, 0, 1), p.point.position);
    const bool flat = s.field->flat_patches(0)[p.point.triangle] >= 0;
    EXPECT_LT(cross_angle(*d, around, p.frame.normal), flat ? 0.1 : 3);
    tops += flat;
  }
  EXPECT_EQ(tops, 62);
}

TEST(SmoothedField, NoiseIsCalmed) {
  const test::ExactSurface exact = test::exact_torus(1, 0.4);
  const Smoothed s(test::noisy(test::irregular_torus(1, 0.4, 20000), 0.05));
  std::vector<double> raw;
  for (const Probe& p : test::probes(*s.surface)) {
    const test::ExactFrame e = exact(p.point.position);
    raw.push_back(cross_angle(p.frame.d1, e.d1, p.frame.normal));
  }
  const std::vector<double> smooth = errors(s, exact);
  EXPECT_LT(quantile(smooth, 0.95), 0.7 * quantile(raw, 0.95));
  EXPECT_LT(quantile(smooth, 0.95), 6);
  EXPECT_LE(s.field->singularities(0).size(), 6u);
}

TEST(SmoothedField, FollowsStraightCreasesOfARealPart) {
  const auto path = test::data("mesh/cgal/fandisk.off");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  RunContext context;
  const auto surface = read_mesh(path, context).parts[0].form->realise({}, context);
  const field::SmoothedField f({surface.get()}, {}, context);
  const ProxyMesh& proxy = surface->proxy();
  std::vector<double> off;
  for (std::uint32_t face = 0; face < proxy.wedges.size(); ++face) {
    for (int k = 0; k < 3; ++k) {
      const auto h = static_cast<HalfEdge>(3 * face + static_cast<std::uint32_t>(k));
      if (!proxy.is_crease(h)) continue;
      Vec3 bary(0.02);
      bary[k] = bary[(k + 1) % 3] = 0.49;
      const Probe p(*surface, {face, bary});
      const auto d = test::direction(f, p.query());
      const Vec3 edge = proxy.mesh.positions[origin(proxy.mesh, next_in_face(h))] -
                        proxy.mesh.positions[origin(proxy.mesh, h)];
      off.push_back(d ? cross_angle(*d, reject(edge, p.frame.normal), p.frame.normal) : 45);
    }
  }
  ASSERT_GT(off.size(), 500u);
  EXPECT_LT(quantile(off, 0.5), 3);
  EXPECT_LT(f.singularities(0).size(), 12u);
}

// The rims of its holes are rounded: that folds narrow triangles back onto the face around them.
TEST(SmoothedField, AFaceAroundRoundedHolesIsFlat) {
  const auto path = test::data("mesh/cgal/anchor_dense.off");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  RunContext context;
  const auto surface =
      read_mesh(path, context).parts[0].form->realise({.tolerance = 1e-4}, context);
  const field::SmoothedField f({surface.get()}, {}, context);
  int all = 0, upright = 0;
  for (const Probe& p : test::probes(*surface)) {
    // A face of the part, none of the needles.
    if (surface->proxy().mesh.normal(p.point.triangle).x < 0.999999) continue;
    if (std::abs(p.point.position.x - 0.5) > 1e-9) continue;
    const auto d = test::direction(f, p.query());
    ASSERT_TRUE(d);
    ++all;
    upright += cross_angle(*d, {0, 0, 1}, p.frame.normal) < 0.5;
  }
  EXPECT_GT(all, 1000);
  EXPECT_GT(upright, 0.95 * all);  // the others are needles that are not folded
}

/// The length of the edges over which the lines of family 1 in the middles of both triangles differ
/// by more than 45 degrees, as a share of the square root of the area: cuts where strokes of the
/// two families end against one another.
double length_of_cuts(const Smoothed& s) {
  const ProxyMesh& proxy = s.surface->proxy();
  double length = 0, area = 0;
  for (std::uint32_t f = 0; f < proxy.wedges.size(); ++f) {
    area += proxy.mesh.area(f);
    const Probe p(*s.surface, {f, Vec3(1.0 / 3)});
    const auto d = s.at(p);
    for (std::uint32_t k = 0; d && k < 3; ++k) {
      const std::uint32_t beyond = face_of(proxy.topology.opposite[3 * std::size_t{f} + k]);
      if (beyond < f) continue;
      const Probe q(*s.surface, {beyond, Vec3(1.0 / 3)});
      const auto e = s.at(q);
      if (!e || test::line_angle(transport(*d, p.frame.normal, q.frame.normal), *e) <= 45) continue;
      length += glm::distance(proxy.wedge_position(proxy.wedges[f][k]),
                              proxy.wedge_position(proxy.wedges[f][(k + 1) % 3]));
    }
  }
  return length / std::sqrt(area);
}

TEST(SmoothedField, FamiliesDoNotMeetAlongCuts) {
  // Around singularities of half a turn a few edges lie between lines at more than 45 degrees.
  const Smoothed blob(test::mapped(test::icosphere(1, 40), [](Vec3 p) {
    return p * (1 + 0.2 * std::sin(3 * p.x) * std::cos(2 * p.y + 1) + 0.15 * p.z * p.z);
  }));
  EXPECT_LT(length_of_cuts(blob), 0.3);
  const Smoothed rounded_box(test::mapped(test::icosphere(1, 40), [](Vec3 p) {
    const Vec3 q = p * p;
    return Vec3(0.8, 1, 1.5) * p / std::pow(glm::dot(q * q, q), 1.0 / 6);
  }));
  EXPECT_LT(length_of_cuts(rounded_box), 0.7);
  EXPECT_EQ(rounded_box.index_sum(), 8);
  const Smoothed ellipsoid(
      test::mapped(test::icosphere(1, 40), [](Vec3 p) { return Vec3(1, 0.7, 0.5) * p; }));
  EXPECT_LT(length_of_cuts(ellipsoid), 0.2);
}

TEST(SmoothedField, FollowsTheArmNearestToThePreviousDirection) {
  const Smoothed s(test::torus(1, 0.4, 60, 30));
  for (const Probe& p : test::probes(*s.surface, 5)) {
    for (int i = 0; i < 16; ++i) {
      const double a = (i + 0.5) * kPi / 8;
      const Vec3 previous = std::cos(a) * p.frame.d1 + std::sin(a) * p.frame.d2;
      const auto d = s.at(p, 1, previous);
      ASSERT_TRUE(d);
      EXPECT_GT(glm::dot(*d, previous), std::cos(kPi / 4) - 0.05);
      EXPECT_NEAR(glm::length(*d), 1, 1e-12);
      EXPECT_NEAR(glm::dot(*d, p.frame.normal), 0, 1e-12);
    }
  }
}

TEST(SmoothedField, DoesNotDependOnScalePlaceOrPose) {
  const TriMesh base = test::noisy(test::irregular_torus(1, 0.4, 4000), 0.03);
  const Smoothed reference(base);
  const std::vector<Probe> at = test::probes(*reference.surface, 11);
  const Mat3 turn = [] {
    const Vec3 x = glm::normalize(Vec3(1, 2, -0.5)), y = any_orthogonal(x);
    return Mat3(x, y, glm::cross(x, y));
  }();
  const auto compare = [&](double scale, Vec3 shift, const Mat3& pose, double tolerance) {
    const Smoothed s(test::mapped(base, [&](Vec3 p) { return pose * p * scale + shift; }),
                     {.fallback = pose * Vec3(0, 0, 1)});
    const std::vector<Probe> here = test::probes(*s.surface, 11);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto a = reference.at(at[i]), b = s.at(here[i]);
      ASSERT_EQ(a.has_value(), b.has_value());
      if (a) {
        EXPECT_LT(test::line_angle(pose * *a, *b), tolerance);
      }
    }
  };
  compare(1e-3, Vec3(0), Mat3(1), 1e-6);
  compare(1e4, Vec3(0), Mat3(1), 1e-6);
  compare(1, Vec3(1e5, -1e5, 1e5), Mat3(1), 1e-2);
  compare(1, Vec3(0), turn, 1e-3);
}

TEST(SmoothedField, SameBitsForAnyNumberOfThreads) {
  const TriMesh mesh = test::noisy(test::irregular_torus(1, 0.4, 20000), 0.05);
  const auto run = [&](int threads) {
    const ThreadLimit limit(threads);
    const Smoothed s(mesh);
    std::vector<Vec3> result;
    for (const Probe& p : test::probes(*s.surface, 3)) result.push_back(s.at(p).value_or(Vec3(0)));
    return result;
  };
  EXPECT_EQ(run(1), run(0));
}

TEST(SmoothedField, SeveralPartsAndTheNamedField) {
  const auto a = test::realised(test::torus(1, 0.4, 60, 30));
  const auto b = test::realised(test::box({0, 0, 0}, {1, 2, 3}));
  const RunContext context;
  const Field f = field::smoothed({a.get(), b.get()}, {}, context);
  EXPECT_EQ(f.name, "smoothed");
  const Probe on_a(*a, {17, {0.2, 0.3, 0.5}}), on_b(*b, {3, {0.2, 0.3, 0.5}});
  EXPECT_LT(cross_angle(f.cross({0, on_a.point, on_a.frame})->first,
                        test::exact_torus(1, 0.4)(on_a.point.position).d1, on_a.frame.normal),
            3);
  EXPECT_LT(cross_angle(f.cross({1, on_b.point, on_b.frame})->first, {1, 0, 0}, {0, 0, 1}), 1e-9);
}

TEST(SmoothedField, ACancelledRunThrows) {
  const auto s = test::realised(test::torus(1, 0.4, 60, 30));
  RunContext context;
  context.cancel();
  EXPECT_THROW(field::SmoothedField({s.get()}, {}, context), Cancelled);
}

}  // namespace
}  // namespace burin
