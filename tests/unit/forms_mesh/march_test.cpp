#include <burin_test/facets.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

using test::kPi;

std::shared_ptr<const Surface> realise(TriMesh mesh, bool curvature = false) {
  return test::realised(std::move(mesh), curvature);
}

/// The square [0,n]^2 in the plane z = 0.
TriMesh plate(std::uint32_t n) {
  return test::grid(n + 1, n + 1, false, false,
                    [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
}

/// A cylinder about z of radius 1 without caps.
TriMesh tube(std::uint32_t around, std::uint32_t up, double height) {
  return test::grid(around, up, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * kPi * i / around;
    return Vec3(std::cos(u), std::sin(u), height * j / (up - 1));
  });
}

SurfacePoint at(const Surface& s, std::uint32_t face, Vec3 bary) { return s.lift({face, bary}); }

/// Some triangle that has `p` as a corner, and that corner.
SurfacePoint at_vertex(const Surface& s, Vec3 p) {
  const TriMesh& m = s.proxy().mesh;
  for (std::uint32_t f = 0; f < m.triangles.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      if (glm::distance(m.positions[m.triangles[f][static_cast<std::size_t>(k)]], p) > 1e-9)
        continue;
      Vec3 bary(0);
      bary[k] = 1;
      return at(s, f, bary);
    }
  }
  ADD_FAILURE() << "no such vertex";
  return {};
}

TEST(March, GoesStraightOnAPlane) {
  const auto s = realise(plate(20));
  const SurfacePoint start = at(*s, 100, {0.3, 0.3, 0.4});
  for (int i = 0; i < 720; ++i) {
    const Vec3 d(std::cos(i * kPi / 360), std::sin(i * kPi / 360), 0);
    const MarchStep step = s->march(start, d, 1.7);
    ASSERT_EQ(step.stop, MarchStop::Completed);
    EXPECT_LT(glm::distance(step.end.position, start.position + 1.7 * d), 1e-13);
    EXPECT_LT(glm::distance(step.direction, d), 1e-13);
    EXPECT_EQ(step.length, 1.7);
  }
}

TEST(March, StartsOnVerticesAndEdgesInEveryDirection) {
  const auto s = realise(plate(8));
  const TriMesh& m = s->proxy().mesh;
  for (std::uint32_t f = 0; f < m.triangles.size(); ++f) {
    for (const Vec3 bary : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(.5, .5, 0),
                            Vec3(0, .25, .75), Vec3(.1, 0, .9)}) {
      const SurfacePoint start = at(*s, f, bary);
      const Vec3 p = start.position;
      if (p.x < 2 || p.y < 2 || p.x > 6 || p.y > 6) continue;
      for (int i = 0; i < 48; ++i) {
        const Vec3 d(std::cos(i * kPi / 24), std::sin(i * kPi / 24), 0);
        const MarchStep step = s->march(start, d, 1.9);
        ASSERT_EQ(step.stop, MarchStop::Completed) << f << " " << i;
        ASSERT_LT(glm::distance(step.end.position, p + 1.9 * d), 1e-12) << f << " " << i;
      }
    }
  }
}

TEST(March, ProjectsTheTangentAndIgnoresItsLength) {
  const auto s = realise(plate(8));
  const SurfacePoint start = at(*s, 60, {0.3, 0.3, 0.4});
  const MarchStep a = s->march(start, {1, 0.5, 0}, 1);
  const MarchStep b = s->march(start, {100, 50, 70}, 1);
  EXPECT_LT(glm::distance(a.end.position, b.end.position), 1e-13);
}

TEST(March, EndsAtTheBoundaryAndSaysHowFarItCame) {
  const auto s = realise(plate(4));
  const SurfacePoint start = at_vertex(*s, {1, 2, 0});
  const MarchStep step = s->march(start, {-1, 0, 0}, 5);
  EXPECT_EQ(step.stop, MarchStop::Boundary);
  EXPECT_NEAR(step.length, 1, 1e-14);
  EXPECT_LT(glm::distance(step.end.position, Vec3(0, 2, 0)), 1e-13);
  const MarchStep out = s->march(step.end, {-1, 0, 0}, 5);
  EXPECT_EQ(out.stop, MarchStop::Boundary);
  EXPECT_EQ(out.length, 0);
  const MarchStep along = s->march(step.end, {0, 1, 0}, 1.5);
  EXPECT_EQ(along.stop, MarchStop::Completed);
  EXPECT_LT(glm::distance(along.end.position, Vec3(0, 3.5, 0)), 1e-13);
}

TEST(March, EndsAtACreaseAndWalksAlongIt) {
  const auto s = realise(test::box({0, 0, 0}, {4, 4, 4}));
  const SurfacePoint top = s->march(at_vertex(*s, {0, 0, 4}), {1, 1, 0}, 1).end;
  ASSERT_NEAR(top.position.z, 4, 1e-12);
  const MarchStep step = s->march(top, {1, 0.1, 0}, 100);
  EXPECT_EQ(step.stop, MarchStop::Crease);
  EXPECT_NEAR(step.end.position.x, 4, 1e-12);
  EXPECT_NEAR(step.length, (4 - std::sqrt(0.5)) * std::sqrt(1.01), 1e-12);
  const MarchStep along = s->march(step.end, {0, 1, 0}, 1.25);
  EXPECT_EQ(along.stop, MarchStop::Completed);
  EXPECT_LT(glm::distance(along.end.position, step.end.position + Vec3(0, 1.25, 0)), 1e-12);
}

TEST(March, SaysSingularWhereTheTangentVanishes) {
  const auto s = realise(plate(4));
  const SurfacePoint start = at(*s, 3, {0.3, 0.3, 0.4});
  EXPECT_EQ(s->march(start, {0, 0, 1}, 1).stop, MarchStop::Singular);
  EXPECT_EQ(s->march(start, {0, 0, 0}, 1).stop, MarchStop::Singular);
  EXPECT_EQ(s->march(start, {0, 0, 1}, 1).length, 0);
}

TEST(March, ClosedLoopsAroundACylinderComeBack) {
  for (const std::uint32_t n : {13u, 24u, 1000u}) {
    const auto s = realise(tube(n, 9, 2));
    const double perimeter = 2 * n * std::sin(kPi / n);
    for (const Vec3 bary : {Vec3(0.3, 0.3, 0.4), Vec3(1, 0, 0), Vec3(0.5, 0.5, 0)}) {
      const SurfacePoint start = at(*s, 2 * 3, bary);
      const Vec3 t = s->march(start, {0, 0, 1}, 0).direction;
      const Vec3 across = glm::cross(t, s->proxy().mesh.normal(6));
      const MarchStep step = s->march(start, across, 10 * perimeter);
      ASSERT_EQ(step.stop, MarchStop::Completed) << n;
      EXPECT_LT(glm::distance(step.end.position, start.position), 1e-9 * perimeter) << n;
      if (step.end.triangle == start.triangle) {
        EXPECT_LT(glm::distance(step.direction, across), 1e-9) << n;
      }
    }
  }
}

TEST(March, FollowsAHelixOfTheUnrolledCylinder) {
  const std::uint32_t n = 400;
  const auto s = realise(tube(n, 50, 10));
  const double perimeter = 2 * n * std::sin(kPi / n);
  const SurfacePoint start = at_vertex(*s, {1, 0, 0});
  const Vec3 d = glm::normalize(Vec3(-std::sin(kPi / n), std::cos(kPi / n), 0.3));
  const double length = 3 * perimeter / glm::length(Vec2(d));
  const MarchStep step = s->march(start, d, length);
  ASSERT_EQ(step.stop, MarchStop::Completed);
  EXPECT_LT(glm::distance(step.end.position, Vec3(1, 0, length * d.z)), 1e-10);
}

TEST(March, FollowsTheGeodesicsOfATorus) {
  const auto drift = [](std::uint32_t nu, std::uint32_t nv) {
    // A meridian is a geodesic; a line in its direction stays at its longitude, as the mesh allows.
    const auto s = realise(test::torus(3, 1, nu, nv));
    const SurfacePoint start = at(*s, 0, {0.4, 0.3, 0.3});
    const Vec3 p = start.position, around = glm::normalize(Vec3(-p.y, p.x, 0));
    const Vec3 up = glm::cross(s->proxy().mesh.normal(0), around);
    const MarchStep step = s->march(start, -up, 2 * kPi);
    EXPECT_EQ(step.stop, MarchStop::Completed);
    return std::abs(std::atan2(step.end.position.y, step.end.position.x) - std::atan2(p.y, p.x));
  };
  EXPECT_LT(drift(150, 50), 0.02);
  EXPECT_LT(drift(600, 200), 0.005);
  const auto s = realise(test::torus(3, 1, 600, 200));
  // Clairaut: r cos(angle to the circle of latitude) is constant along any geodesic. The start is
  // off the vertices: through a vertex with an angle defect no line is straight to both sides.
  const SurfacePoint off = at(*s, 0, {0.35, 0.31, 0.34});
  const auto clairaut = [](Vec3 p, Vec3 d) { return p.x * d.y - p.y * d.x; };
  SurfacePoint p = off;
  Vec3 d = s->march(off, {0, 0.8, 0.6}, 0).direction;
  const double start = clairaut(p.position, d);
  for (int i = 0; i < 100; ++i) {
    const MarchStep step = s->march(p, d, 0.1);
    ASSERT_EQ(step.stop, MarchStop::Completed);
    p = step.end;
    d = step.direction;
    EXPECT_NEAR(clairaut(p.position, d) / start, 1, 2e-2);
  }
  // In one go or in a hundred steps: the same end.
  const MarchStep whole = s->march(off, {0, 0.8, 0.6}, 10);
  EXPECT_LT(glm::distance(whole.end.position, p.position), 1e-8);
}

TEST(March, GoingBackReturnsToTheStart) {
  const auto s = realise(test::ellipsoid({1, 0.7, 0.5}, 61, 40));
  const TriMesh& m = s->proxy().mesh;
  for (std::uint32_t f = 0; f < m.triangles.size(); f += 7) {
    const SurfacePoint start = at(*s, f, {0.21, 0.46, 0.33});
    const MarchStep there = s->march(start, {0.3, -0.5, 0.8}, 0.8);
    ASSERT_EQ(there.stop, MarchStop::Completed);
    const MarchStep back = s->march(there.end, -there.direction, there.length);
    EXPECT_LT(glm::distance(back.end.position, start.position), 1e-9) << f;
  }
}

TEST(March, DoesNotDependOnScaleOrPlace) {
  const TriMesh base = test::torus(3, 1, 60, 30);
  const auto reference = realise(base);
  const SurfacePoint p0 = at(*reference, 500, {0.2, 0.5, 0.3});
  const Vec3 end = reference->march(p0, {0.3, 0.5, 0.8}, 4).end.position;
  for (const double scale : {1e-3, 1.0, 1e4}) {
    for (const Vec3 shift : {Vec3(0), Vec3(1e5, -1e5, 1e5)}) {
      const auto s = realise(test::mapped(base, [&](Vec3 p) { return p * scale + shift; }));
      const MarchStep step = s->march(at(*s, 500, {0.2, 0.5, 0.3}), {0.3, 0.5, 0.8}, 4 * scale);
      // Positions 1e5 away carry errors of 1.5e-11; near a vertex they are magnified.
      EXPECT_LT(glm::distance((step.end.position - shift) / scale, end),
                1e-9 + 1e3 * glm::length(shift) * 2e-16 / scale);
    }
  }
}

TEST(March, NeverHangsOnAStrangeTriangulation) {
  // A fan of slivers whose heights shrink down to nothing.
  TriMesh m;
  m.positions = {{0, 0, 0}};
  for (int i = 0; i <= 60; ++i) {
    const double a = 0.5 * std::pow(0.6, i);
    m.positions.push_back({std::cos(a), std::sin(a), 0});
  }
  for (std::uint32_t i = 1; i <= 60; ++i) m.triangles.push_back({0, i + 1, i});
  const auto s = realise(m);
  for (std::uint32_t f = 0; f < 60; ++f) {
    for (int i = 0; i < 40; ++i) {
      const Vec3 d(std::cos(i * kPi / 20), std::sin(i * kPi / 20), 0);
      const MarchStep step = s->march(at(*s, f, {0.2, 0.3, 0.5}), d, 10);
      EXPECT_NE(step.stop, MarchStop::Completed);
      EXPECT_LE(step.length, 1.01);
    }
  }
}

}  // namespace
}  // namespace burin
