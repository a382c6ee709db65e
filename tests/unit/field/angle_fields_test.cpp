#include <burin/field/field.h>
#include <burin/forms/charted/nurbs.h>
#include <burin/forms/patches/parametric_form.h>

#include <burin_test/fields.h>
#include <burin_test/nurbs_shapes.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

using test::Probe;

std::shared_ptr<const Surface> exact(const NurbsData& nurbs) {
  RunContext context;
  return ParametricForm({make_nurbs_chart(nurbs)}).realise({.tolerance = 0.01}, context);
}

Camera camera_of(const Surface& s, Vec3 direction, std::optional<double> perspective = {}) {
  return Camera::fit(
      [&](const Mat3& axes) {
        Box3 box;
        for (const Vec3& p : s.proxy().mesh.positions) box.add(axes * p);
        return box;
      },
      {.direction = direction, .perspective = perspective, .paper = {100, 100}});
}

double cosine(const Camera& camera, const Frame& f, const SurfacePoint& p) {
  return glm::dot(f.normal, camera.to_viewer(p.position));
}

TEST(Isophote, OnASphereAreCirclesOfLatitudeAboutTheView) {
  const auto s = exact(test::sphere_nurbs(2));
  const Camera camera = camera_of(*s, {0, 0, 1});
  const Field along = field::isophote(camera, {}), across = field::steepest(camera, {});
  int still = 0;
  for (const Probe& p : test::probes(*s)) {
    const auto d = test::direction(along, p.query());
    const Vec3 n = p.frame.normal;
    if (!d) {
      ++still;
      EXPECT_GT(std::abs(n.z), 0.9999) << "only about the poles the angle stands still";
      EXPECT_FALSE(test::direction(across, p.query()));
      continue;
    }
    EXPECT_NEAR(d->z, 0, 1e-9);
    EXPECT_NEAR(glm::length(*d), 1, 1e-12);
    const auto steep = test::direction(across, p.query());
    EXPECT_NEAR(glm::dot(*d, *steep), 0, 1e-9);
    EXPECT_GT(steep->z, 0) << "towards the viewer";
    EXPECT_NEAR(std::abs(glm::dot(*test::direction(along, p.query(2)), *steep)), 1, 1e-12);
    EXPECT_NEAR(std::abs(glm::dot(*test::direction(across, p.query(2)), *d)), 1, 1e-12);
    // The arm that goes on, and its sign.
    EXPECT_NEAR(glm::dot(*test::direction(along, p.query(1, -0.9 * *steep + 0.1 * *d)), *steep), -1,
                1e-12);
    EXPECT_NEAR(test::certainty(along, p.query()), std::sqrt(1 - n.z * n.z), 1e-6);
  }
  EXPECT_LT(still, 10);
}

// Marched as strokes are: half a step, the direction there, the whole step along it.
double drift(const Surface& s, const Field& field, const Camera& camera, const Probe& from,
             double step, int steps) {
  SurfacePoint at = from.point;
  Vec3 previous = *test::direction(field, from.query());
  const double start = cosine(camera, from.frame, at);
  double most = 0;
  for (int i = 0; i < steps; ++i) {
    const Frame f = s.frame(at);
    const auto d = test::direction(field, {{0, at, f}, 1, previous});
    if (!d) break;
    const MarchStep half = s.march(at, *d, 0.5 * step);
    const Frame g = s.frame(half.end);
    const auto e = test::direction(field, {{0, half.end, g}, 1, half.direction});
    if (!e) break;
    const MarchStep whole = s.march(at, transport(*e, g.normal, f.normal), step);
    if (glm::dot(whole.direction, *e) < 0.7) break;
    at = whole.end;
    previous = whole.direction;
    most = std::max(most, std::abs(cosine(camera, s.frame(at), at) - start));
  }
  return most;
}

TEST(Isophote, StrokesOnATorusKeepTheirAngleToTheView) {
  const auto s = exact(test::torus_nurbs(3, 1));
  for (const auto& perspective : {std::optional<double>(), std::optional<double>(40)}) {
    const Camera camera = camera_of(*s, {1, -1.3, 0.9}, perspective);
    const Field field = field::isophote(camera, {});
    int strokes = 0;
    // Steps of 0.4 mm on paper, over 40 mm; where the angle hardly changes the lines are level
    // curves of a flat hill, and strokes do not start.
    for (const Probe& p : test::probes(*s, 23)) {
      if (cosine(camera, p.frame, p.point) < 0.05 || test::certainty(field, p.query()) < 0.25)
        continue;
      EXPECT_LT(drift(*s, field, camera, p, 0.4 / camera.scale(), 100), 1e-3);
      ++strokes;
    }
    EXPECT_GT(strokes, 20);
  }
}

TEST(Isophote, FollowsTheChangeOfTheAngleInAllDirections) {
  // The derivative of n . v by small steps, on a mesh and in perspective too.
  const auto mesh = test::realised(test::torus(3, 1, 180, 80));
  const auto nurbs = exact(test::torus_nurbs(3, 1));
  for (const auto& s : {mesh, nurbs}) {
    const Camera camera = camera_of(*s, {0.4, -1, 0.7}, 35);
    const Field field = field::steepest(camera, {});
    double error = 0, count = 0;
    for (const Probe& p : test::probes(*s, s == mesh ? 41 : 7)) {
      const auto d = test::direction(field, p.query());
      if (!d || test::certainty(field, p.query()) < 0.2) continue;
      const test::ExactFrame e = test::exact_torus(3, 1)(p.point.position);
      const Vec3 e2 = glm::cross(e.normal, e.d1);
      const auto rate = [&](Vec3 t) {
        const auto at = [&](double h) {
          const Vec3 q = test::onto_torus(3, 1)(p.point.position + h * t);
          return glm::dot(test::exact_torus(3, 1)(q).normal, camera.to_viewer(q));
        };
        return (at(1e-4) - at(-1e-4)) / 2e-4;
      };
      const Vec3 gradient = rate(e.d1) * e.d1 + rate(e2) * e2;
      EXPECT_GT(glm::dot(*d, gradient), 0) << "towards the smaller angle";
      error += test::line_angle(*d, glm::normalize(gradient));
      ++count;
    }
    ASSERT_GT(count, 50);
    EXPECT_LT(error / count, s == mesh ? 1.0 : 1e-3);
  }
}

TEST(Isophote, FlatPlacesFollowTheStyleAndCylindersTheirRulings) {
  const auto s = test::realised(test::cylinder(2, 5, 96));
  const Camera camera = camera_of(*s, {1, -1, 0.6});
  const Field field = field::isophote(camera, {.fallback = {0, 1, 0}, .flat = 1e-3});
  int caps = 0, sides = 0;
  for (const Probe& p : test::probes(*s)) {
    const auto d = test::direction(field, p.query());
    if (std::abs(p.frame.normal.z) > 0.9) {
      ASSERT_TRUE(d);
      EXPECT_LT(test::line_angle(*d, {0, 1, 0}), 1e-9);
      EXPECT_EQ(test::certainty(field, p.query()), 0);
      ++caps;
    } else if (d) {
      EXPECT_LT(test::line_angle(*d, {0, 0, 1}), 1e-6);
      ++sides;
    }
  }
  EXPECT_GT(caps, 50);
  EXPECT_GT(sides, 100);
}

TEST(Isophote, OfALightDoesNotDependOnTheView) {
  const auto s = exact(test::sphere_nurbs(2));
  const Vec3 light = glm::normalize(Vec3(1, 2, -0.5));
  const Field field = field::isophote(3.0 * light, {});
  for (const Probe& p : test::probes(*s, 5)) {
    const auto d = test::direction(field, p.query());
    if (d) {
      EXPECT_NEAR(glm::dot(*d, light), 0, 1e-9);
    }
  }
}

TEST(PlanesField, RunsInPlanes) {
  const auto s = test::realised(test::ellipsoid({1, 2, 3}, 60, 40), false);
  const Vec3 normal = glm::normalize(Vec3(1, 1, 2));
  const Field planes = field::planes(2.0 * normal), fixed = field::fixed(normal);
  for (const Probe& p : test::probes(*s)) {
    const auto d = test::direction(planes, p.query());
    ASSERT_EQ(d.has_value(), test::direction(fixed, p.query()).has_value());
    if (!d) continue;
    EXPECT_NEAR(glm::dot(*d, normal), 0, 1e-12);
    EXPECT_NEAR(std::abs(glm::dot(*test::direction(planes, p.query(2)),
                                  *test::direction(fixed, p.query()))),
                1, 1e-12);
  }
}

TEST(ScreenVerticalField, IsUprightOnTheSheet) {
  // The tangent part of up is off by up to 40 degrees here.
  const auto s = test::realised(test::ellipsoid({1, 2, 3}, 60, 40), false);
  for (const auto& perspective : {std::optional<double>(), std::optional<double>(60)}) {
    const Camera camera = camera_of(*s, {1, -1, 2}, perspective);
    const Field field = field::screen_vertical(camera);
    int upright = 0;
    for (const Probe& p : test::probes(*s, 3)) {
      const auto d = test::direction(field, p.query());
      if (!d) continue;
      EXPECT_NEAR(glm::length(*d), 1, 1e-12);
      EXPECT_NEAR(glm::dot(*d, p.frame.normal), 0, 1e-12);
      const Vec2 v = camera.velocity(p.point.position, *d);
      EXPECT_NEAR(v.x, 0, 1e-9 * camera.scale());
      const Vec2 across = camera.velocity(p.point.position, *test::direction(field, p.query(2)));
      EXPECT_GT(std::abs(across.x), 0);
      if (cosine(camera, p.frame, p.point) > 0.1) {
        EXPECT_GT(v.y, 0);
        ++upright;
      }
    }
    EXPECT_GT(upright, 200);
  }
}

TEST(SilhouetteField, IsAcrossTheNormalAndTheLineOfSight) {
  const auto s = test::realised(test::ellipsoid({1, 2, 3}, 60, 40), false);
  for (const auto& perspective : {std::optional<double>(), std::optional<double>(60)}) {
    const Camera camera = camera_of(*s, {1, -1, 2}, perspective);
    const Field field = field::silhouette(camera);
    int asked = 0;
    for (const Probe& p : test::probes(*s, 3)) {
      const auto along = test::direction(field, p.query()), to = test::direction(field, p.query(2));
      if (!along) continue;
      ++asked;
      const Vec3 view = camera.to_viewer(p.point.position);
      EXPECT_NEAR(std::abs(glm::dot(*along, glm::normalize(glm::cross(p.frame.normal, view)))), 1,
                  1e-12);
      // The other way is that of the line of sight on the surface.
      EXPECT_NEAR(std::abs(glm::dot(*to, glm::normalize(reject(view, p.frame.normal)))), 1, 1e-12);
    }
    EXPECT_GT(asked, 200);
  }
}

TEST(IsoparametricField, RunsAlongParametersOrNotAtAll) {
  const auto s = exact(test::torus_nurbs(3, 1));
  const Field field = field::isoparametric();
  for (const Probe& p : test::probes(*s, 5)) {
    const auto u = test::direction(field, p.query()), v = test::direction(field, p.query(2));
    ASSERT_TRUE(u && v);
    EXPECT_LT(test::line_angle(*u, p.frame.du), 1e-9);
    EXPECT_LT(test::line_angle(*v, p.frame.dv), 1e-9);
    EXPECT_NEAR(glm::dot(*test::direction(field, p.query(1, -*v)), *v), -1, 1e-9);
  }
  const auto mesh = test::realised(test::torus(3, 1, 20, 10));
  EXPECT_FALSE(field.cross(test::probes(*mesh).front().query().query));
}

TEST(SilhouetteAcross, IsTheTangentPartOfTheLineOfSight) {
  const auto s = exact(test::sphere_nurbs(2));
  const Camera camera = camera_of(*s, {1, 2, 3});
  const Field across = field::silhouette_across(camera), along = field::silhouette(camera);
  int count = 0;
  for (const Probe& p : test::probes(*s)) {
    const auto d = test::direction(across, p.query());
    if (!d) continue;
    ++count;
    const Vec3 view = camera.to_viewer(p.point.position), n = p.frame.normal;
    const Vec3 tangent = glm::normalize(view - glm::dot(view, n) * n);
    EXPECT_NEAR(std::abs(glm::dot(*d, tangent)), 1, 1e-9);
    EXPECT_NEAR(glm::dot(*d, *test::direction(along, p.query())), 0, 1e-9);
  }
  EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace burin
