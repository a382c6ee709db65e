#include <burin/area/largest_disc.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace burin {
namespace {

using Sides = std::vector<BorderSide>;

void add_ring(const std::vector<Vec2>& ring, Sides& sides) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

std::vector<Vec2> circle(Vec2 middle, double radius, int n) {
  std::vector<Vec2> ring;
  for (int i = 0; i < n; ++i) {
    const double u = 2 * std::numbers::pi * i / n;
    ring.push_back(middle + radius * Vec2(std::cos(u), std::sin(u)));
  }
  return ring;
}

TEST(LargestDisc, OfATriangleIsItsInscribedCircle) {
  Sides sides;
  add_ring({{0, 0}, {4, 0}, {0, 3}}, sides);
  const InnerDisc disc = largest_disc(sides, {}, {.precision = 1e-4});
  EXPECT_NEAR(disc.radius, 1, 2e-4);
  EXPECT_NEAR(glm::distance(disc.middle, Vec2(1, 1)), 0, 0.02);
}

TEST(LargestDisc, StandsBesideAHoleAndALine) {
  // A square of 10 mm with a hole of radius 3 in its middle: in a corner (5 - r) sqrt 2 = 3 + r.
  Sides sides;
  add_ring({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, sides);
  add_ring(circle({5, 5}, 3, 720), sides);
  const double root = std::numbers::sqrt2;
  const double radius = (5 * root - 3) / (1 + root);
  EXPECT_NEAR(largest_disc(sides, {}, {.precision = 1e-3}).radius, radius, 2e-3);
  // Lines through three of the corners leave the fourth.
  const Sides lines{{Vec2(0, 0), Vec2(10, 10)}, {Vec2(0, 10), Vec2(4, 6)}};
  const InnerDisc disc = largest_disc(sides, lines, {.precision = 1e-3});
  EXPECT_NEAR(disc.radius, radius, 2e-3);
  EXPECT_NEAR(glm::distance(disc.middle, Vec2(10 - radius, radius)), 0, 0.01);
}

TEST(LargestDisc, OfARandomPolygonIsNoSmallerThanThatOfAnyPlace) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int n = 0; n < 40; ++n) {
    std::vector<Vec2> ring;
    for (int i = 0; i < 24; ++i) {
      const double u = 2 * std::numbers::pi * i / 24, r = 2 + 8 * unit(random);
      ring.push_back(r * Vec2(std::cos(u), std::sin(u)));
    }
    Sides sides;
    add_ring(ring, sides);
    const InnerDisc disc = largest_disc(sides, {}, {.precision = 0.01});
    const auto radius_at = [&](Vec2 p) {
      double nearest = 1e9;
      bool inside = false;
      for (const auto& [a, b] : sides) {
        const Vec2 d = b - a;
        const double t = std::clamp(glm::dot(p - a, d) / glm::dot(d, d), 0.0, 1.0);
        nearest = std::min(nearest, glm::distance(p, a + t * d));
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) {
          inside = !inside;
        }
      }
      return inside ? nearest : -nearest;
    };
    EXPECT_NEAR(radius_at(disc.middle), disc.radius, 1e-9) << "polygon " << n;
    for (int i = 0; i < 2000; ++i) {
      const Vec2 p = 20.0 * Vec2(unit(random), unit(random)) - 10.0;
      EXPECT_LE(radius_at(p), disc.radius + 0.01) << "polygon " << n;
    }
  }
}

TEST(LargestDisc, EndsAsSoonAsItIsLargeEnoughAndOfNothingIsNone) {
  Sides sides;
  add_ring({{0, 0}, {100, 0}, {100, 1}, {0, 1}}, sides);
  EXPECT_GE(largest_disc(sides, {}, {.precision = 1e-3, .enough = 0.4}).radius, 0.4);
  EXPECT_LT(largest_disc(sides, {}, {.precision = 1e-3, .enough = 0.6}).radius, 0.6);
  EXPECT_EQ(largest_disc({}).radius, 0);
}

}  // namespace
}  // namespace burin
