// Normals for flat tones: noise goes, and what bends evenly stays as it is.

#include <burin/feature/isophotes.h>
#include <burin/feature/light_normals.h>

#include "feature_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace burin::test {
namespace {

constexpr double kAxis = 12, kTube = 5, kPen = 0.25;
const ViewOptions kAbove{.direction = {0, 0, 1}, .up = {0, 1, 0}};

/// A ring of triangles of one size, each vertex where `x` is more than `from` moved by up to a
/// tenth of an edge.
TriMesh noisy_ring(double from) {
  TriMesh mesh = torus(kAxis, kTube, 240, 100);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-0.03, 0.03);
  for (Vec3& p : mesh.positions) {
    const Vec3 by(off(random), off(random), off(random));
    if (p.x > from) p += by;
  }
  return mesh;
}

Vec3 exact_normal(Vec3 p) {
  const Vec3 axis = kAxis * glm::normalize(Vec3(p.x, p.y, 0));
  return glm::normalize(p - axis);
}

double mean_error(const ProxyMesh& proxy, const std::vector<Vec3>& normals) {
  double sum = 0;
  for (std::uint32_t w = 0; w < normals.size(); ++w) {
    sum += glm::distance(normals[w], exact_normal(proxy.wedge_position(w)));
  }
  return sum / static_cast<double>(normals.size());
}

TEST(LightNormals, AreThoseOfTheProxyWhereItBendsEvenly) {
  const auto same = [](TriMesh mesh) {
    const Looked s({std::move(mesh)}, kAbove);
    return light_normals(s.proxies[0], s.camera, kPen, s.context).empty();
  };
  EXPECT_TRUE(same(torus(kAxis, kTube, 240, 100)));
  EXPECT_TRUE(same(torus(kAxis, kTube, 60, 24)));
  EXPECT_TRUE(same(cylinder(4, 30, 48)));
  EXPECT_TRUE(same(box({-20, 0, -10}, {20, 30, 10})));
  EXPECT_FALSE(same(noisy_ring(-100)));
}

TEST(LightNormals, OfANoisyRingAreNearTheRingAndStayWhereItIsEven) {
  const Looked s({noisy_ring(3)}, kAbove);
  const ProxyMesh& proxy = s.proxies[0];
  const std::vector<Vec3> normals = light_normals(proxy, s.camera, kPen, s.context);
  ASSERT_EQ(normals.size(), proxy.wedge_normal.size());
  EXPECT_LT(mean_error(proxy, normals), 0.3 * mean_error(proxy, proxy.wedge_normal));
  for (std::uint32_t w = 0; w < normals.size(); ++w) {
    EXPECT_NEAR(glm::length(normals[w]), 1, 1e-12);
    // Noise is told by four rings of neighbours.
    if (proxy.wedge_position(w).x < 0.5) {
      EXPECT_EQ(normals[w], proxy.wedge_normal[w]);
    }
  }
}

TEST(LightNormals, GiveANoisyRingItsIsophotesWithoutIslands) {
  const Looked s({noisy_ring(-100)}, kAbove);
  const ProxyMesh& proxy = s.proxies[0];
  const Isophotes of{{0, 0, 1}, {0.8}};
  const auto borders = [&](std::span<const Vec3> normals) {
    return trace_isophotes(proxy, 0, of, s.camera, s.context, {.border = true, .normals = normals});
  };
  const std::vector<Vec3> normals = light_normals(proxy, s.camera, kPen, s.context);
  const std::vector<Curve3> circles = borders(normals);
  ASSERT_EQ(circles.size(), 2u) << "inside and outside of the crest";
  EXPECT_GT(borders({}).size(), 2 * circles.size());
  for (const Curve3& circle : circles) {
    EXPECT_TRUE(circle.closed);
    double length = 0;
    for (std::size_t i = 0; i < circle.segment_count(); ++i) {
      length += glm::distance(circle.points[i], circle.points[circle.next(i)]);
    }
    const Vec3& p = circle.points[0];
    EXPECT_LT(length, 1.1 * 2 * kPi * std::hypot(p.x, p.y)) << "no frayed coast";
  }
}

// The crest of the ring is lit in full. A dent in it is an island where the light falls below 0.8.
TEST(LightNormals, LoseIslandsThatAreSmallOrFaint) {
  constexpr double kLevel = 0.8, kWidePen = 0.5;
  const Looked s({noisy_ring(-100)}, kAbove);
  const ProxyMesh& proxy = s.proxies[0];
  const Isophotes of{{0, 0, 1}, {kLevel}};
  const std::vector<Vec3> plain = light_normals(proxy, s.camera, kWidePen, s.context);
  const auto islands = [&](double radius, double light) {
    std::vector<Vec3> normals = plain;
    for (std::uint32_t w = 0; w < normals.size(); ++w) {
      if (glm::distance(proxy.wedge_position(w), Vec3(kAxis, 0, kTube)) > radius) continue;
      normals[w] = Vec3(std::sqrt(1 - light * light), 0, light);
    }
    const auto lines = [&](std::span<const Vec3> by) {
      return trace_isophotes(proxy, 0, of, s.camera, s.context, {.border = true, .normals = by})
          .size();
    };
    EXPECT_EQ(lines(normals), 3U) << "two circles and the dent";
    return lines(without_islands(proxy, normals, of, s.camera, kWidePen)) - 2;
  };
  EXPECT_EQ(islands(0.3, 0.3), 0U) << "small";
  EXPECT_EQ(islands(1, 0.3), 1U) << "dark";
  EXPECT_EQ(islands(1, kLevel - 0.05), 0U) << "faint";
  EXPECT_EQ(islands(2.2, kLevel - 0.05), 1U) << "large";
  // What is no noise is none as an island either.
  EXPECT_TRUE(without_islands(proxy, {}, of, s.camera, kWidePen).empty());
  EXPECT_EQ(without_islands(proxy, proxy.wedge_normal, of, s.camera, kWidePen), proxy.wedge_normal);
}

TEST(LightNormals, AverageOverWidthsOfThePenWhereTheseAreMoreThanTwoEdges) {
  ViewOptions small = kAbove;
  small.paper = {60, 40};
  const Looked s({noisy_ring(-100)}, small);
  const auto normals = [&](double pen) {
    return light_normals(s.proxies[0], s.camera, pen, s.context);
  };
  EXPECT_EQ(normals(0.02), normals(0));
  EXPECT_NE(normals(0.25), normals(0));
}

}  // namespace
}  // namespace burin::test
