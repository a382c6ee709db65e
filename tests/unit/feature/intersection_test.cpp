// Curves in which parts pass through each other, and contacts that are none.

#include "feature_support.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace burin::test {
namespace {

Mat3 some_rotation() {
  const Vec3 a = glm::normalize(Vec3(1, 2, 0.5));
  const Vec3 b = glm::normalize(reject(Vec3(0.3, -1, 2), a));
  return {a, b, glm::cross(a, b)};
}

TriMesh shifted(TriMesh m, Vec3 d) {
  return mapped(std::move(m), [d](Vec3 p) { return p + d; });
}

/// A cylinder along x through the origin.
TriMesh lying_cylinder(double radius, double half, std::uint32_t n) {
  return mapped(cylinder(radius, 2 * half, n),
                [half](Vec3 p) { return Vec3(p.z - half, p.x, p.y); });
}

TEST(Intersection, TwoBoxes) {
  const Looked s({box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})}, {.direction = {1, -1, 1}});
  const auto curves = s.of(LineClass::Intersection);
  ASSERT_FALSE(curves.empty());
  double sum = 0;
  for (const Curve3& c : curves) {
    sum += length(c);
    EXPECT_EQ(c.source.part, 0);
    EXPECT_EQ(c.crease_sign, -1);
    ASSERT_EQ(c.normals.size(), c.points.size());
    ASSERT_EQ(c.faces.size(), c.segment_count());
    for (const Vec3& p : c.points) {  // on the surfaces of both boxes
      EXPECT_NEAR(std::max({std::abs(p.x - 1), std::abs(p.y - 1), std::abs(p.z - 1)}), 1, 1e-12);
      EXPECT_NEAR(std::max({std::abs(p.x - 2), std::abs(p.y - 2), std::abs(p.z - 2)}), 1, 1e-12);
    }
  }
  EXPECT_NEAR(sum, 6, 1e-9);  // a hexagon of unit edges in space
}

TEST(Intersection, BelongsToThePartWhoseLinesShowMore) {
  const Looked s({box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})}, {.direction = {1, -1, 1}});
  const std::vector<const ProxyMesh*> proxies{&s.proxies[0], &s.proxies[1]};
  Diagnostics said;
  const auto parts = [&](const MeetingParts& meeting) {
    std::set<std::int32_t> out;
    for (const Curve3& c : extract_features(proxies, s.camera, {}, said, s.context, meeting)) {
      if (c.kind != LineClass::Intersection) continue;
      out.insert(c.source.part);
      const ProxyMesh& own = s.proxies[static_cast<std::size_t>(c.source.part)];
      // Its triangles are those of that part.
      const auto face = static_cast<std::uint32_t>(c.faces[0]);
      const Vec3 corner = own.mesh.positions[own.mesh.triangles[face][0]];
      const Vec3 middle = 0.5 * (c.points[0] + c.points[1]);
      EXPECT_NEAR(glm::dot(middle - corner, own.mesh.normal(face)), 0, 1e-12);
    }
    return out;
  };
  EXPECT_EQ(parts({}), std::set<std::int32_t>{0});
  EXPECT_EQ(parts({.ink = {1, 1}}), std::set<std::int32_t>{0});
  EXPECT_EQ(parts({.ink = {1, 2}}), std::set<std::int32_t>{1});
  EXPECT_EQ(parts({.ink = {2, 1}}), std::set<std::int32_t>{0});
  // What is solid has the line, whatever shows more.
  EXPECT_EQ(parts({.transparent = {false, true}, .ink = {1, 2}}), std::set<std::int32_t>{0});
}

// Each shows the line where its own surface does, whichever way the other is turned.
TEST(Intersection, OfTwoTransparentPartsIsALineOfBoth) {
  const Looked s({box({-4, -1, -1}, {4, 1, 1}), box({-0.5, -4, -0.5}, {0.5, 4, 0.5})},
                 {.direction = {1, -2, 3}});
  const std::vector<const ProxyMesh*> proxies{&s.proxies[0], &s.proxies[1]};
  Diagnostics said;
  // Of each part: shown and self-hidden.
  const auto lengths = [&](const MeetingParts& meeting) {
    std::array<std::array<double, 2>, 2> sums{};
    for (const Curve3& c : extract_features(proxies, s.camera, {}, said, s.context, meeting)) {
      if (c.kind != LineClass::Intersection) continue;
      for (std::size_t i = 0; i < c.segment_count(); ++i) {
        sums[static_cast<std::size_t>(c.source.part)][c.self_hidden[i]] +=
            glm::distance(c.points[i], c.points[c.next(i)]);
      }
    }
    return sums;
  };
  // Two squares, where the second bar comes out of the first. Of solid bars two sides of the one in
  // front are seen, on the front of both.
  const auto solid = lengths({});
  EXPECT_NEAR(solid[0][0], 2, 1e-9);
  EXPECT_NEAR(solid[0][1], 6, 1e-9);
  EXPECT_EQ(solid[1][0] + solid[1][1], 0);
  const auto glass = lengths({.transparent = {true, true}});
  EXPECT_NEAR(glass[0][0], 4, 1e-9) << "the square on the side that is turned to the viewer";
  EXPECT_NEAR(glass[0][1], 4, 1e-9);
  EXPECT_NEAR(glass[1][0], 4, 1e-9) << "two sides of both squares";
  EXPECT_NEAR(glass[1][1], 4, 1e-9);
  const auto one = lengths({.transparent = {false, true}});
  EXPECT_NEAR(one[0][0], 4, 1e-9);
  EXPECT_EQ(one[1][0] + one[1][1], 0);
}

TEST(Intersection, TwoComponentsOfOnePart) {
  const Looked s({joined(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}))},
                 {.direction = {1, -1, 1}});
  double sum = 0;
  for (const Curve3& c : s.of(LineClass::Intersection)) sum += length(c);
  EXPECT_NEAR(sum, 6, 1e-9);
}

/// A square of 2 about the origin, across x.
TriMesh sheet_across_x(std::uint32_t n) {
  return grid(n, n, false, false, [n](std::uint32_t i, std::uint32_t j) {
    return Vec3(0, 2.0 * i / (n - 1) - 1, 2.0 * j / (n - 1) - 1);
  });
}

TEST(Intersection, TwoOpenComponentsOfOnePart) {
  const TriMesh upright = sheet_across_x(4);
  const TriMesh across = mapped(upright, [](Vec3 p) { return Vec3(p.y, p.x + 0.1, 0.9 * p.z); });
  const Looked s({joined(upright, across)}, {.direction = {1, -1, 1}});
  double sum = 0;
  for (const Curve3& c : s.of(LineClass::Intersection)) {
    sum += length(c);
    for (const Vec3& p : c.points) EXPECT_NEAR(std::hypot(p.x, p.y - 0.1), 0, 1e-12);
    for (const auto hidden : c.self_hidden) EXPECT_EQ(hidden, 0);
  }
  EXPECT_NEAR(sum, 1.8, 1e-9);
}

// Every triangle on its own and across each other: what damaged files make.
TEST(Intersection, OfTooManyOpenPiecesAreLeftOutAndTold) {
  TriMesh all;
  for (int i = 0; i < 500; ++i) {
    const TriMesh one{{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}, {{0, 1, 2}}};
    const double turn = 0.01 * i;
    all = joined(all, mapped(one, [turn](Vec3 p) {
                   return Vec3(std::cos(turn) * p.x, std::sin(turn) * p.x + 1e-4 * p.z, p.z);
                 }));
  }
  const Looked s({all}, {.direction = {1, -1, 1}});
  EXPECT_TRUE(s.of(LineClass::Intersection).empty());
  ASSERT_EQ(s.diagnostics.entries().size(), 1u);
  EXPECT_EQ(s.diagnostics.entries()[0].code, "feature.open_pieces");
}

TEST(Intersection, TwoCylinders) {
  const std::uint32_t n = 180;
  const double big = 4, small = 3;
  const Looked s({shifted(cylinder(big, 20, n), {0, 0, -10}), lying_cylinder(small, 10, n)},
                 {.direction = {1, -1, 1}});
  const auto curves = s.of(LineClass::Intersection);
  ASSERT_EQ(curves.size(), 2u);
  const double sagitta = big * (1 - std::cos(kPi / n));
  // Length of x = sqrt(16 - y^2), y^2 + z^2 = 9, by the midpoint rule.
  double exact = 0;
  Vec3 last(std::sqrt(big * big - small * small), small, 0);
  for (int i = 1; i <= 100000; ++i) {
    const double a = 2 * kPi * i / 100000, y = small * std::cos(a);
    const Vec3 p(std::sqrt(big * big - y * y), y, small * std::sin(a));
    exact += glm::length(p - last);
    last = p;
  }
  for (const Curve3& c : curves) {
    EXPECT_TRUE(c.closed);
    EXPECT_NEAR(length(c), exact, 0.002 * exact);
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      const Vec3& p = c.points[i];
      EXPECT_NEAR(std::hypot(p.x, p.y), big, 2 * sagitta);
      EXPECT_NEAR(std::hypot(p.y, p.z), small, 2 * sagitta);
      // The open side: out of both cylinders.
      EXPECT_GT(glm::dot(c.normals[i], Vec3(p.x, p.y, 0)), 0);
      EXPECT_GT(glm::dot(c.normals[i], Vec3(0, p.y, p.z)), 0);
    }
    for (std::size_t i = 0; i < c.segment_count(); ++i) {  // hidden where either is turned away
      const Vec3 p = 0.5 * (c.points[i] + c.points[c.next(i)]), v = s.camera.direction();
      const double a = glm::dot(Vec3(p.x, p.y, 0), v) / big;
      const double b = glm::dot(Vec3(0, p.y, p.z), v) / small;
      if (std::abs(std::min(a, b)) > 0.05) {
        EXPECT_EQ(hidden(c, i), std::min(a, b) < 0);
      }
    }
  }
}

TEST(Intersection, TwoSpheresInACircle) {
  const double r = 5;
  const Looked s(
      {ellipsoid(Vec3(r), 200, 100), shifted(ellipsoid(Vec3(r), 200, 100), {6, 0, 0.01})},
      {.direction = {1, -1, 1}});
  const auto curves = s.of(LineClass::Intersection);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_NEAR(length(curves[0]), 2 * kPi * 4, 0.02);
}

TEST(Intersection, PartsThatTouchHaveNone) {
  const TriMesh plate = box({-5, -5, -1}, {5, 5, 0});
  const TriMesh block = box({-2, -1, 0}, {1, 2, 3});  // stands on the plate
  const TriMesh flush = box({5, -5, -1}, {8, 5, 0});  // continues it
  const TriMesh post = cylinder(1, 2, 40);            // a round foot
  const Mat3 turn = some_rotation();
  for (const bool turned : {false, true}) {
    // Turned, the planes agree within rounding only.
    const auto place = [&](TriMesh m) {
      if (!turned) return m;
      return mapped(std::move(m), [&](Vec3 p) { return turn * p + Vec3(1, 7, 3); });
    };
    const Looked s({place(plate), place(block), place(flush), place(shifted(post, {3, -3, 0}))},
                   {.direction = turn * Vec3(1, -1, 1)});
    EXPECT_TRUE(s.of(LineClass::Intersection).empty()) << turned;
  }
}

TEST(Intersection, ShaftInItsHoleHasNone) {
  // The hole: a ring whose bore has the shaft's radius but other facets.
  const std::uint32_t n = 50;
  TriMesh ring;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double u = 2 * kPi * i / n;
    for (const auto& [r, z] : {std::pair(5.0, 0.0), {5.0, 8.0}, {9.0, 8.0}, {9.0, 0.0}}) {
      ring.positions.push_back({r * std::cos(u), r * std::sin(u), z});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t a = 4 * i + k, b = 4 * i + (k + 1) % 4;
      const std::uint32_t c = 4 * ((i + 1) % n) + (k + 1) % 4, d = 4 * ((i + 1) % n) + k;
      ring.triangles.push_back({a, b, c});
      ring.triangles.push_back({a, c, d});
    }
  }
  const Looked s({shifted(cylinder(5, 20, 36), {0, 0, -6}), ring}, {.direction = {1, -1, 1}});
  // Facets of both cut each other at the mouth of the hole only, by less than their sagitta.
  double drawn = 0;
  for (const Curve3& c : s.of(LineClass::Intersection)) drawn += open_length(s.camera, c);
  EXPECT_LT(drawn, 0.02 * 2 * kPi * 5 * s.camera.scale());
}

TEST(Intersection, CanBeTurnedOff) {
  const Looked s({box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})}, {},
                 {.intersections = false});
  EXPECT_TRUE(s.of(LineClass::Intersection).empty());
}

}  // namespace
}  // namespace burin::test
