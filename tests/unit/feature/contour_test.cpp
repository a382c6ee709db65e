// Contours of smooth surfaces against their formulas.

#include <burin/base/error.h>
#include <burin/base/parallel.h>

#include "feature_support.h"

#include <gtest/gtest.h>

namespace burin::test {
namespace {

constexpr std::uint32_t kAround = 200, kAlong = 100;
constexpr double kRadius = 10;
// The chord height of the coarser direction of the sphere's grid.
const double kSphereSagitta = kRadius * (1 - std::cos(kPi / kAlong / 2));

TriMesh sphere() { return ellipsoid(Vec3(kRadius), kAround, kAlong); }

TEST(Contour, SphereIsOneCircle) {
  for (const Vec3 direction : {Vec3(1, -1, 1), Vec3(0.3, 0.2, 0.9), Vec3(0, 0, 1), Vec3(1, 0, 0)}) {
    const Looked s({sphere()}, {.direction = direction});
    ASSERT_EQ(s.curves.size(), 1u);
    const Curve3& c = s.curves[0];
    EXPECT_EQ(c.kind, LineClass::Contour);
    EXPECT_EQ(c.source, (SourceId{0, 0, -1}));
    EXPECT_TRUE(c.closed);
    EXPECT_TRUE(c.occluding);
    EXPECT_TRUE(none_hidden(c));
    ASSERT_EQ(c.normals.size(), c.points.size());
    ASSERT_EQ(c.faces.size(), c.segment_count());
    ASSERT_EQ(c.self_hidden.size(), c.segment_count());
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      const double r =
          glm::length(s.camera.to_paper(c.points[i]) - s.camera.offset()) / s.camera.scale();
      EXPECT_NEAR(r, kRadius, 2 * kSphereSagitta);
      EXPECT_GT(glm::dot(c.normals[i], c.points[i]), 0.999 * kRadius);
      EXPECT_NEAR(glm::dot(c.normals[i], s.camera.direction()), 0, 2e-3);
    }
    EXPECT_NEAR(length(c), 2 * kPi * kRadius, 0.01 * kRadius);
  }
}

TEST(Contour, SphereInPerspectiveIsTheSmallerCircle) {
  const Looked s({sphere()}, {.direction = {1, -1, 1}, .perspective = 60});
  ASSERT_EQ(s.curves.size(), 1u);
  const double distance = glm::length(s.camera.eye());
  const double height = kRadius * kRadius / distance;
  const double radius = std::sqrt(kRadius * kRadius - height * height);
  EXPECT_GT(height, 0.3 * kRadius);
  for (const Vec3& p : s.curves[0].points) {
    const double h = glm::dot(p, s.camera.direction());
    EXPECT_NEAR(h, height, 0.005 * kRadius);
    EXPECT_NEAR(glm::length(p - h * s.camera.direction()), radius, 0.005 * kRadius);
  }
}

TEST(Contour, TorusFollowsTheAnalyticZeroSet) {
  const double major = 3, minor = 1;
  const std::uint32_t nu = 200, nv = 100;
  const Looked s({torus(major, minor, nu, nv)}, {.direction = {0.3, -1, 1}});
  const Vec3 v = s.camera.direction();
  ASSERT_EQ(s.curves.size(), 2u);
  std::vector<Vec2> exact;  // for each u both zeros of g in v, on paper
  const int samples = 8000;
  for (int i = 0; i < samples; ++i) {
    const double u = 2 * kPi * i / samples;
    const double root = std::atan2(-(v.x * std::cos(u) + v.y * std::sin(u)), v.z);
    for (const double w : {root, root + kPi}) {
      const double r = major + minor * std::cos(w);
      exact.push_back(s.camera.to_paper({r * std::cos(u), r * std::sin(u), minor * std::sin(w)}));
    }
  }
  const double chord = 2 * kPi * (major + minor) / nu;
  const double sagitta = chord * chord / 8 / minor;
  for (const Curve3& c : s.curves) {
    EXPECT_TRUE(c.closed);
    for (const Vec3& p : c.points) {
      double nearest = 1e9;
      for (const Vec2& e : exact) {
        nearest = std::min(nearest, glm::length(e - s.camera.to_paper(p)));
      }
      EXPECT_LT(nearest, 2 * sagitta * s.camera.scale());
    }
  }
}

TEST(Contour, TorusFromAboveAndFromTheSide) {
  const Looked top({torus(3, 1, 200, 100)}, {.direction = {0, 0, 1}});
  ASSERT_EQ(top.curves.size(), 2u);
  for (const Curve3& c : top.curves) {
    EXPECT_TRUE(c.closed);
    EXPECT_TRUE(none_hidden(c));
  }
  EXPECT_NEAR(length(top.curves[0]) + length(top.curves[1]), 2 * kPi * (4 + 2), 0.02);
  // From the side the two halves of the outer outline and the folded inner one meet in four points;
  // which of them join there is a matter of rounding, not whether they close.
  const Looked side({torus(3, 1, 200, 100)}, {.direction = {0, 1, 0}});
  EXPECT_GE(side.curves.size(), 1u);
  EXPECT_LE(side.curves.size(), 3u);
  for (const Curve3& c : side.curves) EXPECT_TRUE(c.closed);
}

TEST(Contour, TorusHidesItsFoldedPart) {
  // Seen flat enough the hole's contour has two cusps; between them its far side is in front.
  const Looked s({torus(3, 1, 400, 200)}, {.direction = {0, -1, 0.35}});
  ASSERT_EQ(s.curves.size(), 2u);
  int changes = 0, folded = 0;
  for (const Curve3& c : s.curves) {
    const std::size_t n = c.segment_count();
    for (std::size_t i = 0; i < n; ++i) {
      changes += c.self_hidden[i] != c.self_hidden[(i + n - 1) % n];
      if (!c.self_hidden[i]) continue;
      ++folded;
      const Vec3 p = 0.5 * (c.points[i] + c.points[c.next(i)]);
      EXPECT_LT(std::hypot(p.x, p.y), 3.0);  // on the inner half only
    }
  }
  EXPECT_EQ(changes, 4);  // two cusps on either side of the hole
  EXPECT_GT(folded, 10);
}

TEST(Contour, OpenBowlHidesNothingAndTurnsItsNormals) {
  // The lower half of a sphere, seen from above at a slant: inside and outside both show.
  TriMesh bowl = grid(128, 33, true, false, [](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * kPi * i / 128, w = -kPi / 2 + 0.02 + (kPi / 2 - 0.02) * j / 32;
    return 10.0 * Vec3(std::cos(u) * std::cos(w), std::sin(u) * std::cos(w), std::sin(w));
  });
  const Looked s({bowl}, {.direction = {1, 0, 0.7}}, {}, 60);
  const auto boundaries = s.of(LineClass::Boundary);
  ASSERT_EQ(boundaries.size(), 2u);  // the rim and the tiny hole at the pole
  for (const Curve3& b : boundaries) {
    EXPECT_TRUE(b.closed);
    EXPECT_TRUE(b.occluding);
    for (std::size_t i = 0; i < b.points.size(); ++i) {
      EXPECT_GE(glm::dot(b.normals[i], s.camera.direction()), 0);
    }
  }
  for (const Curve3& c : s.curves) EXPECT_TRUE(none_hidden(c));
  const auto contours = s.of(LineClass::Contour);
  ASSERT_FALSE(contours.empty());
  for (const Curve3& c : contours) {
    EXPECT_FALSE(c.closed);
    EXPECT_EQ(c.normals.size(), c.points.size());
    for (std::size_t i = 0; i < c.points.size(); ++i) {  // convex outside: outward
      EXPECT_GT(glm::dot(c.normals[i], c.points[i]), 0);
    }
    // Its ends are points of the rim, bit for bit.
    for (const Vec3& p : {c.points.front(), c.points.back()}) {
      EXPECT_TRUE(std::ranges::any_of(boundaries, [&](const Curve3& b) {
        return std::ranges::find(b.points, p) != b.points.end();
      }));
    }
  }
}

TEST(Contour, RippledPlateHasNoSpecks) {
  // A closed plate whose top is rippled by less than the noise limit, seen edge-on.
  TriMesh plate = ellipsoid({20, 20, 2}, 160, 80);
  for (std::size_t i = 0; i < plate.positions.size(); ++i) {
    Vec3& p = plate.positions[i];
    p *= 1 + 2e-5 * std::sin(37.0 * static_cast<double>(i));
  }
  const Looked s({plate}, {.direction = {1, 0, 0}});
  ASSERT_EQ(s.of(LineClass::Contour).size(), 1u);
}

TEST(Contour, SameBytesForAnyNumberOfThreads) {
  const auto run = [](int threads) {
    const ThreadLimit limit(threads);
    return Looked({torus(3, 1, 600, 300), mapped(sphere(), [](Vec3 p) { return p * 0.3; })},
                  {.direction = {0.3, -1, 0.4}});
  };
  const Looked one = run(1), many = run(4);
  ASSERT_EQ(one.curves.size(), many.curves.size());
  for (std::size_t i = 0; i < one.curves.size(); ++i) {
    EXPECT_EQ(one.curves[i].points, many.curves[i].points);
    EXPECT_EQ(one.curves[i].normals, many.curves[i].normals);
    EXPECT_EQ(one.curves[i].faces, many.curves[i].faces);
    EXPECT_EQ(one.curves[i].self_hidden, many.curves[i].self_hidden);
    EXPECT_EQ(one.curves[i].source, many.curves[i].source);
  }
}

TEST(Contour, CancelStopsIt) {
  RunContext context;
  const ProxyMesh proxy = build_proxy(sphere(), {}, context);
  const ProxyMesh* pointer = &proxy;
  std::vector<ProxyMesh> one{proxy};
  const Camera camera = Looked::fit(one, {});
  context.cancel();
  Diagnostics diagnostics;
  EXPECT_THROW(extract_features({&pointer, 1}, camera, {}, diagnostics, context), Cancelled);
}

}  // namespace
}  // namespace burin::test
