// Facets whose surface is known.

#include <burin/forms/recognised/recognised_form.h>
#include <burin/surface/nearest_on.h>

#include <burin_test/shapes.h>
#include <burin_test/turned.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace burin {
namespace {

using test::kPi, test::moved, test::sphere_profile, test::tilted, test::turned;

TurnedSurface line(Vec2 a, Vec2 b, int sides) {
  TurnedSurface s;
  s.step = 2 * kPi / sides;
  s.a = a;
  s.b = b;
  return s;
}

TurnedSurface circle(Vec2 middle, double radius, int sides, int along) {
  TurnedSurface s;
  s.step = 2 * kPi / sides;
  s.profile = TurnedSurface::Profile::Circle;
  s.middle = middle;
  s.radius = radius;
  s.profile_step = 2 * kPi / along;
  return s;
}

using Says = std::function<std::int32_t(Vec3 center, Vec3 normal)>;

RecognisedForm known_form(const TriMesh& mesh, std::vector<TurnedSurface> surfaces,
                          const Says& says) {
  KnownSurfaces known{std::move(surfaces), {}};
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Vec3 center(0);
    for (const std::uint32_t v : mesh.triangles[t]) center += mesh.positions[v] / 3.0;
    known.of.push_back(says(center, mesh.normal(t)));
  }
  return {mesh, known, RunContext()};
}

bool is_side(Vec3 normal) { return std::abs(normal.z) < 0.9; }

TEST(KnownSurfaces, ACylinderIsWhatItIsSaidToBe) {
  const RecognisedForm form =
      known_form(turned({{10, 0}, {10, 30}}, 24), {line({10, 0}, {10, 30}, 24)},
                 [](Vec3, Vec3 n) { return is_side(n) ? 0 : KnownSurfaces::kMeantFlat; });
  EXPECT_EQ(form.faces().cylinders, 1);
  EXPECT_EQ(form.faces().total(), 1);
  RunContext context;
  const auto surface = form.realise({.tolerance = 0.001}, context);
  double least = 1e9;
  for (std::uint32_t t = 0; t < surface->proxy().mesh.triangles.size(); ++t) {
    if (!is_side(surface->proxy().mesh.normal(t))) continue;
    for (const std::uint32_t v : surface->proxy().mesh.triangles[t]) {
      const Vec3 p = surface->proxy().mesh.positions[v];
      least = std::min(least, std::hypot(p.x, p.y));
    }
  }
  EXPECT_NEAR(least, 10, 1e-5);
}

// Solids that overlap by a little leave rings far narrower than the sagitta of their circles.
TEST(KnownSurfaces, RimsOfNarrowRingsAreRound) {
  for (const double width : {1e-4, 1e-3, 0.02, 0.3}) {
    const std::vector<Vec2> profile{{10, 0}, {9, 2}, {9 - width, 2}, {8.2, 3.5}};
    const RecognisedForm form = known_form(
        turned(profile, 16), {line(profile[0], profile[1], 16), line(profile[2], profile[3], 16)},
        [](Vec3 c, Vec3 n) {
          if (std::abs(n.z) > 0.99) return KnownSurfaces::kMeantFlat;
          return c.z < 2 ? 0 : 1;
        });
    RunContext context;
    const auto surface = form.realise({.tolerance = 0.005}, context);
    const ProxyMesh& proxy = surface->proxy();
    for (std::size_t i = 0; i < proxy.edge_kind.size(); ++i) {
      const auto h = static_cast<HalfEdge>(i);
      const Vec3 a = proxy.mesh.positions[origin(proxy.mesh, h)],
                 b = proxy.mesh.positions[origin(proxy.mesh, next_in_face(h))];
      if (!proxy.is_crease(h) || std::max(std::abs(a.z - 2), std::abs(b.z - 2)) > 1e-6) continue;
      const Vec3 middle = 0.5 * (a + b);
      const double r = std::hypot(middle.x, middle.y);  // the chords are 0.17 inside
      EXPECT_LT(std::min(std::abs(r - 9), std::abs(r - 9 + width)), 0.01) << width;
    }
  }
}

// A strip of a cone between two rims.
TEST(KnownSurfaces, RimsOfNarrowConesAreRound) {
  const std::vector<Vec2> profile{{10, 0}, {9, 2}, {8.999, 2.004}, {8.2, 2.5}};
  const RecognisedForm form =
      known_form(turned(profile, 16),
                 {line(profile[0], profile[1], 16), line(profile[1], profile[2], 16),
                  line(profile[2], profile[3], 16)},
                 [](Vec3 c, Vec3 n) {
                   if (std::abs(n.z) > 0.99) return KnownSurfaces::kMeantFlat;
                   return c.z < 2 ? 0 : c.z < 2.004 ? 1 : 2;
                 });
  RunContext context;
  const auto surface = form.realise({.tolerance = 0.005}, context);
  const ProxyMesh& proxy = surface->proxy();
  std::size_t seen = 0;
  for (std::size_t i = 0; i < proxy.edge_kind.size(); ++i) {
    const auto h = static_cast<HalfEdge>(i);
    const Vec3 a = proxy.mesh.positions[origin(proxy.mesh, h)],
               b = proxy.mesh.positions[origin(proxy.mesh, next_in_face(h))];
    if (std::abs(a.z - 2.004) > 1e-6 || std::abs(b.z - 2.004) > 1e-6) continue;
    const Vec3 middle = 0.5 * (a + b);
    EXPECT_NEAR(std::hypot(middle.x, middle.y), 8.999, 0.01);
    ++seen;
  }
  EXPECT_GT(seen, 32u);
}

// A cylinder under a cone about the same axis whose facets stand between its own: their edges cross
// the facets of the cylinder in the middle, and three corners of each lie on the circle where the
// surfaces meet.
TEST(KnownSurfaces, FacetsWithThreeCornersOnARimDoNotStandAcrossTheirSurface) {
  constexpr std::uint32_t kSides = 12;
  TriMesh mesh;
  const auto around = [&](double r, double step, double z) {
    const double a = 2 * kPi * step / kSides;
    mesh.positions.emplace_back(r * std::cos(a), r * std::sin(a), z);
  };
  const double apothem = 10 * std::cos(kPi / kSides), beyond = 10 / std::cos(kPi / kSides);
  for (std::uint32_t i = 0; i < kSides; ++i) {
    around(10, i, 0);
    around(10, i, 32 - beyond);
    around(apothem, i + 0.5, 32 - apothem);
  }
  const std::uint32_t bottom = 3 * kSides, top = bottom + 1;
  mesh.positions.emplace_back(0, 0, 0);
  mesh.positions.emplace_back(0, 0, 32);
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t a = 3 * i, b = 3 * ((i + 1) % kSides);
    mesh.triangles.insert(mesh.triangles.end(), {{a, bottom, b},
                                                 {a, b, b + 1},
                                                 {a, b + 1, a + 1},
                                                 {a + 1, b + 1, a + 2},
                                                 {a + 1, a + 2, top},
                                                 {a + 2, b + 1, top}});
  }
  const RecognisedForm form = known_form(
      mesh, {line({10, 0}, {10, 22}, kSides), line({12, 20}, {0, 32}, kSides)}, [](Vec3, Vec3 n) {
        return n.z < -0.9 ? KnownSurfaces::kMeantFlat : n.z < 0.1 ? 0 : 1;
      });
  RunContext context;
  const auto surface = form.realise({.tolerance = 0.005}, context);
  const ProxyMesh& proxy = surface->proxy();
  for (std::uint32_t t = 0; t < proxy.wedges.size(); ++t) {
    for (const std::uint32_t w : proxy.wedges[t]) {
      if (proxy.wedge_position(w).z > 31.9) continue;  // the tip
      EXPECT_GT(glm::dot(proxy.mesh.normal(t), proxy.wedge_normal[w]), 0.9);
    }
  }
  for (std::size_t i = 0; i < proxy.edge_kind.size(); ++i) {
    const auto h = static_cast<HalfEdge>(i);
    const Vec3 middle = 0.5 * (proxy.mesh.positions[origin(proxy.mesh, h)] +
                               proxy.mesh.positions[origin(proxy.mesh, next_in_face(h))]);
    if (!proxy.is_crease(h) || middle.z < 20) continue;
    EXPECT_NEAR(std::hypot(middle.x, middle.y), 10, 0.01);
    EXPECT_NEAR(middle.z, 22, 0.01);
  }
}

TEST(KnownSurfaces, WhatIsMeantFlatStaysAPrism) {
  const TriMesh prism = turned({{10, 0}, {10, 30}}, 24);
  EXPECT_EQ(
      known_form(prism, {}, [](Vec3, Vec3) { return KnownSurfaces::kMeantFlat; }).faces().total(),
      0);
  // The same of which nobody knows is judged by its looks.
  EXPECT_EQ(
      known_form(prism, {}, [](Vec3, Vec3) { return KnownSurfaces::kUnknown; }).faces().cylinders,
      1);
}

TEST(KnownSurfaces, OneFacetIsEnough) {
  const RecognisedForm form = known_form(
      turned({{10, 0}, {10, 30}}, 24), {line({10, 30}, {10, 0}, 24)}, [](Vec3 c, Vec3 n) {
        const double angle = std::atan2(c.y, c.x);
        const bool first = is_side(n) && angle > 0 && angle < 2 * kPi / 24;
        return first ? 0 : KnownSurfaces::kMeantFlat;
      });
  EXPECT_EQ(form.faces().cylinders, 1);
}

TEST(KnownSurfaces, RowsOfOneSurfaceAreOneFace) {
  // The other half is told of from above, the axis downwards.
  TurnedSurface below = line({10, 0}, {10, 30}, 24);
  below.origin = {0, 0, 30};
  below.axis = {0, 0, -1};
  const RecognisedForm form =
      known_form(turned({{10, 0}, {10, 30}}, 24), {line({10, 0}, {10, 30}, 24), below},
                 [](Vec3 c, Vec3 n) { return is_side(n) ? (c.x > 0 ? 0 : 1) : -1; });
  EXPECT_EQ(form.faces().cylinders, 1);
  EXPECT_EQ(form.faces().total(), 1);
}

TEST(KnownSurfaces, TiltedConesSpheresAndTori) {
  const Mat3 turn = tilted();
  const Vec3 offset(30, -20, 10);
  const auto placed = [&](TurnedSurface s) {
    s.origin = turn * s.origin + offset;
    s.axis = turn * s.axis;
    return s;
  };
  const auto all = [](Vec3, Vec3) { return 0; };
  const auto sides = [&](Vec3, Vec3 n) {
    return std::abs(glm::dot(n, turn[2])) < 0.95 ? 0 : KnownSurfaces::kMeantFlat;
  };
  const auto tilt = [&](TriMesh mesh) { return moved(std::move(mesh), turn, offset); };
  EXPECT_EQ(
      known_form(tilt(turned({{10, 0}, {4, 5}}, 16)), {placed(line({10, 0}, {4, 5}, 16))}, sides)
          .faces()
          .cones,
      1);
  // The flat caps of the sphere, too.
  EXPECT_EQ(known_form(tilt(turned(sphere_profile(10, 20), 20)),
                       {placed(circle({0, 0}, 10, 20, 20))}, all)
                .faces()
                .spheres,
            1);
  std::vector<Vec2> ring;
  for (int i = 0; i < 12; ++i) {
    ring.push_back(Vec2(20, 0) + 5.0 * Vec2(std::cos(kPi * i / 6), std::sin(kPi * i / 6)));
  }
  const RecognisedForm torus =
      known_form(tilt(turned(ring, 36, true)), {placed(circle({20, 0}, 5, 36, 12))}, all);
  EXPECT_EQ(torus.faces().tori, 1);
  EXPECT_EQ(torus.faces().total(), 1);
  RunContext context;
  const auto surface = torus.realise({.tolerance = 0.01}, context);
  for (const Vec3& p : surface->proxy().mesh.positions) {
    const Vec3 q = glm::transpose(turn) * (p - offset);
    EXPECT_NEAR(std::hypot(std::hypot(q.x, q.y) - 20, q.z), 5, 1e-4);
  }
}

TEST(KnownSurfaces, ASurfaceThatFacesBothWaysIsTwoFaces) {
  // A pin in the place of a hole of its size, side by side along one axis.
  TriMesh pin = turned({{5, 0}, {5, 10}}, 24), hole = turned({{5, 20}, {5, 30}}, 24);
  for (Triangle& t : hole.triangles) std::swap(t[1], t[2]);
  const auto first = static_cast<std::uint32_t>(pin.positions.size());
  pin.positions.insert(pin.positions.end(), hole.positions.begin(), hole.positions.end());
  for (Triangle t : hole.triangles) {
    for (std::uint32_t& v : t) v += first;
    pin.triangles.push_back(t);
  }
  const RecognisedForm form = known_form(pin, {line({5, 0}, {5, 10}, 24)},
                                         [](Vec3, Vec3 n) { return is_side(n) ? 0 : -1; });
  EXPECT_EQ(form.faces().cylinders, 2);
  RunContext context;
  const auto surface = form.realise({.tolerance = 0.01}, context);
  const ProxyMesh& proxy = surface->proxy();
  for (std::uint32_t t = 0; t < proxy.mesh.triangles.size(); ++t) {
    if (!is_side(proxy.mesh.normal(t))) continue;
    for (const std::uint32_t w : proxy.wedges[t]) {
      EXPECT_GT(glm::dot(proxy.wedge_normal[w], proxy.mesh.normal(t)), 0.9);
    }
  }
}

/// A profile about the z axis, from pole to pole, turned by three quarters in 18 steps; two flat
/// faces through the axis close it.
TriMesh three_quarters(const std::vector<Vec2>& profile) {
  constexpr int kSteps = 18;
  TriMesh mesh;
  const auto n = static_cast<std::uint32_t>(profile.size());
  const auto number = [&](std::uint32_t k, std::uint32_t j) {
    return k == 0 ? 0 : k + 1 == n ? 1 : 2 + (k - 1) * (kSteps + 1) + j;
  };
  mesh.positions = {{0, 0, profile.front().y}, {0, 0, profile.back().y}};
  for (std::uint32_t k = 1; k + 1 < n; ++k) {
    for (int j = 0; j <= kSteps; ++j) {
      const double a = 1.5 * kPi * j / kSteps;
      mesh.positions.emplace_back(profile[k].x * std::cos(a), profile[k].x * std::sin(a),
                                  profile[k].y);
    }
  }
  for (std::uint32_t k = 0; k + 1 < n; ++k) {
    for (std::uint32_t j = 0; j < kSteps; ++j) {
      const std::uint32_t a = number(k, j), b = number(k, j + 1), c = number(k + 1, j + 1),
                          d = number(k + 1, j);
      if (k > 0) mesh.triangles.push_back({a, b, c});
      if (k + 2 < n) mesh.triangles.push_back({a, c, d});
    }
    if (k == 0) continue;
    mesh.triangles.push_back({0, number(k, 0), number(k + 1, 0)});
    mesh.triangles.push_back({0, number(k + 1, kSteps), number(k, kSteps)});
  }
  return mesh;
}

TEST(KnownSurfaces, CornersOnABallMakeNoFacePartOfIt) {
  // All corners of the flat halves of a disc lie on the ball.
  constexpr int kBands = 12;
  std::vector<Vec2> profile;
  std::vector<TurnedSurface> bands;
  for (int k = 0; k <= kBands; ++k) {
    const double a = kPi * k / kBands;
    profile.push_back(12.0 * Vec2(k % kBands == 0 ? 0 : std::sin(a), -std::cos(a)));
    if (k > 0) bands.push_back(line(profile[k - 1], profile[k], 24));
  }
  const TriMesh mesh = three_quarters(profile);
  const RecognisedForm form = known_form(mesh, bands, [&](Vec3 c, Vec3) {
    if (std::hypot(c.x, c.y, c.z) < 9 || std::abs(std::min(c.x, -c.y)) < 1e-9) return -1;
    const double a = std::acos(-c.z / std::hypot(c.x, c.y, c.z));
    return std::clamp(static_cast<int>(kBands * a / kPi), 0, kBands - 1);
  });
  EXPECT_EQ(form.faces().spheres, 1);
  RunContext context;
  const auto surface = form.realise({.tolerance = 0.01}, context);
  const ProxyMesh& proxy = surface->proxy();
  double flat = 0;
  for (std::uint32_t t = 0; t < proxy.mesh.triangles.size(); ++t) {
    for (const Vec3 n : {Vec3(0, -1, 0), Vec3(1, 0, 0)}) {
      if (!(glm::dot(proxy.mesh.normal(t), n) > 1 - 1e-9)) continue;
      flat += proxy.mesh.area(t);
      for (const std::uint32_t w : proxy.wedges[t]) {
        EXPECT_GT(glm::dot(proxy.wedge_normal[w], n), 1 - 1e-9);
      }
    }
  }
  EXPECT_NEAR(flat, kPi * 12 * 12, 0.5);
}

TEST(KnownSurfaces, ThePointOfAConeOverItsTrianglesIsTheNearest) {
  for (const double top : {2.0, 0.01}) {
    const Vec2 a{10, 0}, b{top, 24};
    const RecognisedForm form = known_form(turned({a, b}, 96), {line(a, b, 96)}, [](Vec3, Vec3 n) {
      return is_side(n) ? 0 : KnownSurfaces::kMeantFlat;
    });
    RunContext context;
    const auto surface = form.realise({.tolerance = 0.01}, context);
    const ProxyMesh& proxy = surface->proxy();
    const Vec2 along = glm::normalize(b - a);
    double beside = 0;
    for (std::uint32_t t = 0; t < proxy.mesh.triangles.size(); ++t) {
      if (!is_side(proxy.mesh.normal(t))) continue;
      for (const Vec3 bary : {Vec3(1.0 / 3), Vec3(0.25, 0.25, 0.5), Vec3(0.6, 0.3, 0.1)}) {
        const Vec3 p = proxy.position(t, bary), out = glm::normalize(Vec3(p.x, p.y, 0));
        const Vec3 normal = along.y * out - Vec3(0, 0, along.x);
        const SurfacePoint near = nearest_on(*surface, {t, bary});
        EXPECT_LT(glm::distance(near.position, p), proxy.tolerance);
        EXPECT_LT(glm::distance(surface->frame(near).normal, normal), 1e-5) << "corners are floats";
        beside = std::max(beside, glm::distance(surface->lift({t, bary}).position, p));
      }
    }
    EXPECT_GT(beside, 4 * proxy.tolerance) << "of what is linear in its parameters";
  }
}

TEST(KnownSurfaces, OneRowATriangle) {
  EXPECT_THROW(RecognisedForm(turned({{10, 0}, {10, 30}}, 24), KnownSurfaces{}, RunContext()),
               std::invalid_argument);
}

}  // namespace
}  // namespace burin
