#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/recognised/recognised_form.h>

#include <burin_test/shapes.h>
#include <burin_test/turned.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace burin {
namespace {

using test::kPi, test::moved, test::single, test::sphere_profile, test::tilted, test::turned;

std::shared_ptr<const Surface> realise(const RecognisedForm& form, double tolerance = 0.01) {
  RunContext context;
  return form.realise({.tolerance = tolerance}, context);
}

RecognisedFaces faces_of(TriMesh mesh) {
  return RecognisedForm(std::move(mesh), RunContext()).faces();
}

TEST(Recognised, PolyhedraAreLeftAlone) {
  for (const int sides : {3, 4, 5, 6, 7, 8}) {
    EXPECT_EQ(faces_of(turned({{10, 0}, {10, 5}}, sides)).total(), 0) << sides;
    EXPECT_EQ(faces_of(turned({{10, 0}, {4, 5}}, sides)).total(), 0) << sides;
    EXPECT_EQ(faces_of(turned(sphere_profile(10, sides), sides)).total(), 0) << sides;
  }
  EXPECT_EQ(faces_of(test::box({0, 0, 0}, {3, 4, 5})).total(), 0);
  // Neither a ball nor an egg of steps that are unequal along the meridian and eight around.
  EXPECT_EQ(faces_of(test::ellipsoid({10, 10, 10}, 8, 6)).total(), 0);
}

TEST(Recognised, UnequalStepsAreLeftAlone) {
  // A prism of twelve sides at angles that alternate.
  TriMesh mesh = turned({{10, 0}, {10, 5}}, 12);
  for (Vec3& p : mesh.positions) {
    const int i = static_cast<int>(std::lround(std::atan2(p.y, p.x) / (kPi / 6)));
    const double a = kPi / 6 * (i + (i % 2 ? 0.2 : 0));
    p = Vec3(10 * std::cos(a), 10 * std::sin(a), p.z);
  }
  EXPECT_EQ(faces_of(mesh).total(), 0);
}

TEST(Recognised, FacetsThatStandForNothingAreRoundedAsThoseOfMeshesAre) {
  // A cylinder beside an egg that is stretched in three ways, in one part.
  const TriMesh egg = moved(test::ellipsoid({10, 14, 20}, 12, 8), Mat3(1), Vec3(40, 0, 0));
  const TriMesh mesh = test::joined(turned({{10, 0}, {10, 5}}, 24), egg);
  const RecognisedForm form(mesh, RunContext());
  EXPECT_EQ(form.faces().cylinders, 1);
  EXPECT_EQ(form.faces().total(), 1);
  RunContext context;
  constexpr double kTolerance = 0.1;
  const RealiseOptions options{.tolerance = kTolerance, .crease_angle = 60};
  const auto alone = MeshForm(egg).realise(options, context);
  const auto surface = form.realise(options, context);
  const ProxyMesh& proxy = surface->proxy();
  std::size_t on_egg = 0;
  double off = 0;
  for (std::uint32_t t = 0; t < proxy.mesh.triangles.size(); ++t) {
    const Vec3 middle = proxy.position(t, Vec3(1.0 / 3));
    on_egg += middle.x > 20;
    const Vec3 drawn = surface->drawn_position(surface->lift({t, Vec3(1.0 / 3)}));
    if (middle.x > 20) off = std::max(off, glm::distance(drawn, middle));
    // Each triangle keeps its source.
    EXPECT_EQ(surface->frame(surface->lift({t, Vec3(1.0 / 3)})).kind == FaceKind::Cylinder,
              middle.x < 20 && std::abs(proxy.mesh.normal(t).z) < 0.5);
  }
  EXPECT_EQ(proxy.source_face.size(), proxy.mesh.triangles.size());
  // What hides lines and strokes is what they are drawn on.
  EXPECT_LT(off, kTolerance);
  EXPECT_EQ(on_egg, alone->proxy().mesh.triangles.size());
  EXPECT_GT(on_egg, 2 * egg.triangles.size());
}

TEST(Recognised, MirroredFacetsOfAZonohedronAreNoCylinder) {
  // Rhombs between the sums of consecutive ones of ten edges around an axis: along each zone the
  // edges are parallel, and the three facets in the middle turn by one angle.
  constexpr int kEdges = 10;
  const auto corner = [](int from, int to) {
    Vec3 sum(0);
    for (int k = from; k <= to; ++k) {
      const double a = 2 * kPi * k / kEdges, up = 35.5 * kPi / 180;
      sum +=
          Vec3(10 * std::cos(up) * std::cos(a), 9 * std::cos(up) * std::sin(a), 12 * std::sin(up));
    }
    return sum;
  };
  PolygonSoup soup;
  for (int i = 0; i < kEdges; ++i) {
    for (int j = i + 1; j < kEdges + i; ++j) {
      for (const Vec3& p :
           {corner(i, j), corner(i + 1, j), corner(i + 1, j - 1), corner(i, j - 1)}) {
        soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
        soup.positions.push_back(p);
      }
      soup.offsets.push_back(soup.indices.size());
    }
  }
  Diagnostics diagnostics;
  EXPECT_EQ(faces_of(repair(std::move(soup), {}, diagnostics, RunContext())).total(), 0);
}

TEST(Recognised, TwoChamfersAreNoCurve) {
  // A shaft with a cone of 12 degrees between two cylinders: three faces, sharp between.
  const TriMesh mesh = turned({{10, 0}, {10, 10}, {8, 20}, {8, 30}}, 24);
  const RecognisedForm form(mesh, RunContext());
  EXPECT_EQ(form.faces().cylinders, 2);
  EXPECT_EQ(form.faces().cones, 1);
  EXPECT_EQ(form.faces().total(), 3);
  const auto surface = realise(form);
  for (const Vec3& p : surface->proxy().mesh.positions) {
    const double most = p.z < 10 ? 10 : p.z > 20 ? 8 : 10 - 0.2 * (p.z - 10);
    EXPECT_LE(std::hypot(p.x, p.y), most + 1e-5);
  }
}

TEST(Recognised, CylindersAreRound) {
  for (const int sides : {9, 12, 30, 100, 360}) {
    const Mat3 turn = tilted();
    const Vec3 offset(300, -200, 100);
    const RecognisedForm form(moved(turned({{10, 0}, {10, 30}}, sides), turn, offset),
                              RunContext());
    ASSERT_EQ(form.faces().cylinders, 1) << sides;
    ASSERT_EQ(form.faces().total(), 1) << sides;
    const auto surface = realise(form, 0.002);
    std::size_t round = 0;
    for (std::uint32_t t = 0; t < surface->proxy().mesh.triangles.size(); ++t) {
      const SurfacePoint at = surface->lift({t, {0.2, 0.3, 0.5}});
      const Frame f = surface->frame(at);
      if (f.kind != FaceKind::Cylinder) continue;
      ++round;
      const Vec3 p = glm::transpose(turn) * (at.position - offset);
      const Vec3 n = glm::normalize(Vec3(p.x, p.y, 0));
      EXPECT_GT(std::hypot(p.x, p.y), 10 - 0.004);
      EXPECT_NEAR(glm::length(glm::transpose(turn) * f.normal - n), 0, 1e-4);
      EXPECT_NEAR(f.k1, 0.1, 1e-4);
      EXPECT_NEAR(f.k2, 0, 1e-9);
      EXPECT_NEAR(std::abs((glm::transpose(turn) * f.d2).z), 1, 1e-6);
      const Vec3 drawn = glm::transpose(turn) * (surface->drawn_position(at) - offset);
      EXPECT_NEAR(std::hypot(drawn.x, drawn.y), 10, 1e-3);
    }
    EXPECT_GT(round, 40U);
    // The rims are circles: no edge of them is farther from it than the tolerance.
    for (const Vec3& q : surface->proxy().mesh.positions) {
      const Vec3 p = glm::transpose(turn) * (q - offset);
      EXPECT_NEAR(std::hypot(p.x, p.y), 10, 1e-3);
    }
  }
}

// Walks on the triangles would be off by their sagitta, 0.08 mm, and turn at every edge.
TEST(Recognised, MarchesFollowTheRoundSurface) {
  const RecognisedForm form(turned({{10, 0}, {10, 30}}, 24), RunContext());
  const auto surface = realise(form);
  std::size_t walked = 0;
  for (std::uint32_t t = 0; t < surface->proxy().mesh.triangles.size(); t += 7) {
    const SurfacePoint from = surface->lift({t, {0.2, 0.3, 0.5}});
    const Frame f = surface->frame(from);
    if (f.kind != FaceKind::Cylinder || from.position.z < 8 || from.position.z > 22) continue;
    // A helix that rises by 5 mm while it turns by 2 radians.
    const double turn = 2, rise = 5, length = std::hypot(10 * turn, rise);
    const Vec3 around = glm::cross(Vec3(0, 0, 1), f.normal);
    const MarchStep step = surface->march(from, 10 * turn * around + rise * Vec3(0, 0, 1), length);
    ASSERT_EQ(step.stop, MarchStop::Completed);
    const Vec3 p = from.position;
    const Vec3 end(p.x * std::cos(turn) - p.y * std::sin(turn),
                   p.x * std::sin(turn) + p.y * std::cos(turn), p.z + rise);
    EXPECT_LT(glm::distance(step.end.position, end), 1e-5);
    EXPECT_NEAR(std::hypot(p.x, p.y), 10, 1e-5);
    EXPECT_GT(glm::length(f.du), 0);
    ++walked;
  }
  EXPECT_GT(walked, 3U);
}

TEST(Recognised, ASurfaceOfNineSidesIsSmooth) {
  const RecognisedForm form(turned({{10, 0}, {10, 30}}, 9), RunContext());
  EXPECT_EQ(realise(form)->proxy().region_count, 3);
}

TEST(Recognised, HolesLookInwards) {
  TriMesh mesh = turned({{10, 0}, {10, 30}}, 32);
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  const RecognisedForm form(mesh, RunContext());
  ASSERT_EQ(form.faces().cylinders, 1);
  const auto surface = realise(form);
  for (std::uint32_t t = 0; t < surface->proxy().mesh.triangles.size(); ++t) {
    const SurfacePoint at = surface->lift({t, {0.2, 0.3, 0.5}});
    const Frame f = surface->frame(at);
    if (f.kind != FaceKind::Cylinder) continue;
    EXPECT_LT(glm::dot(f.normal, at.position * Vec3(1, 1, 0)), -9);
    EXPECT_NEAR(f.k2, -0.1, 1e-6);
    EXPECT_NEAR(f.k1, 0, 1e-9);
  }
}

TEST(Recognised, ConesHaveTheirNormals) {
  const RecognisedForm form(turned({{10, 0}, {4, 8}}, 24), RunContext());
  ASSERT_EQ(form.faces().cones, 1);
  ASSERT_EQ(form.faces().total(), 1);
  const auto surface = realise(form, 0.001);
  const double slope = 6.0 / 8;
  for (std::uint32_t t = 0; t < surface->proxy().mesh.triangles.size(); ++t) {
    const SurfacePoint at = surface->lift({t, {0.2, 0.3, 0.5}});
    const Frame f = surface->frame(at);
    if (f.kind != FaceKind::Cone) continue;
    const Vec3 p = surface->drawn_position(at);
    const double r = std::hypot(p.x, p.y);
    EXPECT_NEAR(r, 10 - slope * p.z, 2e-5);
    const Vec3 n = glm::normalize(Vec3(p.x / r, p.y / r, slope));
    EXPECT_NEAR(glm::length(f.normal - n), 0, 1e-5);
    EXPECT_NEAR(f.k1, n.x / p.x, 1e-4);
  }
}

TEST(Recognised, SpheresAreOneFaceToTheirPoles) {
  for (const int fn : {9, 10, 15, 24, 50, 100, 200}) {
    const RecognisedForm form(turned(sphere_profile(10, fn), fn), RunContext());
    ASSERT_EQ(form.faces().spheres, 1)
        << fn << ' ' << form.faces().cylinders << ' ' << form.faces().cones << ' '
        << form.faces().tori << ' ' << form.faces().revolved;
    ASSERT_EQ(form.faces().total(), 1) << fn;
    const auto surface = realise(form, 0.005);
    EXPECT_EQ(surface->proxy().region_count, 1) << fn;
    for (std::uint32_t t = 0; t < surface->proxy().mesh.triangles.size(); ++t) {
      const SurfacePoint at = surface->lift({t, {0.2, 0.3, 0.5}});
      const Frame f = surface->frame(at);
      ASSERT_EQ(f.kind, FaceKind::Sphere) << fn << " z " << at.position.z;
      EXPECT_NEAR(glm::length(f.normal - glm::normalize(at.position)), 0, 1e-5);
      EXPECT_NEAR(f.k1, 0.1, 1e-5);
      EXPECT_NEAR(f.k2, 0.1, 1e-5);
      EXPECT_TRUE(f.umbilic || f.confidence < 1e-4);
    }
    for (const Vec3& p : surface->proxy().mesh.positions) {
      EXPECT_NEAR(glm::length(p), 10, 1e-4);
    }
    const Box3 box = form.bounds(Mat3(1));
    EXPECT_NEAR(box.max.z, 10, 2e-4);
    EXPECT_NEAR(box.min.y, -10, 2e-4);
  }
}

TEST(Recognised, ToriAreClosed) {
  for (const int fn : {12, 18, 31}) {
    std::vector<Vec2> circle;
    for (int i = 0; i < fn; ++i) {
      const double a = 2 * kPi * i / fn;
      circle.push_back(Vec2(20, 0) + 6.0 * Vec2(std::cos(a), std::sin(a)));
    }
    const RecognisedForm form(turned(circle, 36, true), RunContext());
    ASSERT_EQ(form.faces().tori, 1) << fn;
    ASSERT_EQ(form.faces().total(), 1) << fn;
    const auto surface = realise(form);
    for (const Vec3& p : surface->proxy().mesh.positions) {
      EXPECT_NEAR(std::hypot(std::hypot(p.x, p.y) - 20, p.z), 6, 1e-3)
          << fn << ' ' << p.x << ' ' << p.y << ' ' << p.z;
    }
  }
}

TEST(Recognised, ProfilesOfManyPointsAreSmooth) {
  // A vase whose profile is a sine, by 24 points.
  std::vector<Vec2> profile;
  const auto radius = [](double z) { return 10 + 3 * std::sin(z / 5); };
  for (int i = 0; i <= 24; ++i) profile.emplace_back(radius(i * 1.5), i * 1.5);
  const RecognisedForm form(turned(profile, 40), RunContext());
  EXPECT_EQ(form.faces().total(), 1);
  EXPECT_EQ(form.faces().revolved, 1);
  const auto surface = realise(form, 0.005);
  // Chords of the profile are 0.034 off at most.
  for (const Vec3& p : surface->proxy().mesh.positions) {
    if (p.z < 1e-3 || p.z > 36 - 1e-3) continue;
    EXPECT_NEAR(std::hypot(p.x, p.y), radius(p.z), 0.006) << p.z;
  }
}

TEST(Recognised, RoundedRimsEndWhereTheirLinesBegin) {
  // A puck: a flat disc, a quarter circle, a wall, a quarter circle.
  std::vector<Vec2> profile;
  for (int i = -8; i <= 0; ++i) {
    profile.push_back(Vec2(17, 3) + 3.0 * Vec2(std::cos(kPi * i / 16), std::sin(kPi * i / 16)));
  }
  for (int i = 0; i <= 8; ++i) {
    profile.push_back(Vec2(17, 9) + 3.0 * Vec2(std::cos(kPi * i / 16), std::sin(kPi * i / 16)));
  }
  const RecognisedForm form(turned(profile, 48), RunContext());
  EXPECT_EQ(form.faces().cylinders, 1);
  EXPECT_EQ(form.faces().tori, 2);
  EXPECT_EQ(form.faces().total(), 3);
  const auto surface = realise(form, 0.002);
  EXPECT_EQ(surface->proxy().region_count, 1);
  for (const Vec3& p : surface->proxy().mesh.positions) {
    const double r = std::hypot(p.x, p.y);
    if (p.z > 3 && p.z < 9) {
      EXPECT_NEAR(r, 20, 1e-3);
    }
    if (p.z > 9 && r > 17) {
      EXPECT_NEAR(std::hypot(r - 17, p.z - 9), 3, 3e-3);
    }
    EXPECT_LE(p.z, 12 + 1e-4);
    EXPECT_GE(p.z, -1e-4);
  }
}

TEST(Recognised, NothingMovesFartherThanTheSagittas) {
  const TriMesh mesh = turned(sphere_profile(10, 20), 20);
  const RecognisedForm form(mesh, RunContext());
  const auto surface = realise(form);
  // A triangle of the proxy lies within both sagittas of the polyhedron, whose least radius is
  // about cos(9 degrees)^2.
  for (const Vec3& p : surface->proxy().mesh.positions) {
    EXPECT_GT(glm::length(p), 10 * std::pow(std::cos(kPi / 20), 2));
    EXPECT_LT(glm::length(p), 10 + 1e-4);
  }
}

TEST(Recognised, TheSameForAnyScaleAndPlace) {
  for (const double scale : {1e-3, 1.0, 1e4}) {
    const TriMesh mesh =
        moved(turned({{10, 0}, {10, 30}}, 20), tilted() * scale, scale * Vec3(200, 100, 50));
    EXPECT_EQ(faces_of(mesh).cylinders, 1) << scale;
    EXPECT_EQ(faces_of(mesh).total(), 1) << scale;
  }
}

TEST(Recognised, FarFromTheOriginTheSameOrNothing) {
  // A cylinder, a ball and a cone of about 20 mm.
  const std::vector<TriMesh> shapes{turned({{10, 0}, {10, 30}}, 48),
                                    turned(sphere_profile(10, 48), 48),
                                    turned({{4, 0}, {10, 30}}, 48)};
  for (const TriMesh& shape : shapes) {
    const RecognisedFaces near = faces_of(shape);
    ASSERT_EQ(near.total(), 1);
    int healed = 0;
    for (const double away : {1e2, 3e2, 1e3, 3e3, 1e4, 1e5, 1e6}) {
      TriMesh mesh = moved(shape, tilted(), away * Vec3(1, 0.7, -0.4));
      for (Vec3& p : mesh.positions) p = Vec3(single(p.x), single(p.y), single(p.z));
      const RecognisedForm form(std::move(mesh), RunContext());
      const RecognisedFaces far = form.faces();
      EXPECT_EQ(form.too_coarse(), far.total() == 0) << away;
      if (form.too_coarse()) continue;
      ++healed;
      EXPECT_EQ(far.total(), 1) << away;
      EXPECT_EQ(far.cylinders, near.cylinders) << away;
      EXPECT_EQ(far.spheres, near.spheres) << away;
      EXPECT_EQ(far.cones, near.cones) << away;
    }
    EXPECT_GE(healed, 4);
  }
}

TEST(Recognised, CancelStops) {
  RunContext context;
  context.cancel();
  EXPECT_THROW(RecognisedForm(turned({{10, 0}, {10, 30}}, 200), context), Cancelled);
}

}  // namespace
}  // namespace burin
