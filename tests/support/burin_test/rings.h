#pragma once
/// What holds of regions of a sheet, whatever they are of.

#include <burin/area/partition.h>

#include "ring_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace burin::test {

/// How often rings wind round a place, counterclockwise.
inline int winding(std::span<const std::vector<Vec2>> rings, Vec2 p) {
  int n = 0;
  for (const std::vector<Vec2>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) n += b.y > a.y ? 1 : -1;
    }
  }
  return n;
}

/// Places where two sides of one ring cross, not merely touch, by more than 1e-6 mm.
inline std::vector<Vec2> self_crossings(std::span<const Vec2> ring) {
  struct Side {
    Vec2 a, b, low, high;
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    sides.push_back({a, b, glm::min(a, b), glm::max(a, b)});
  }
  std::ranges::sort(sides, {}, [](const Side& s) { return s.low.x; });
  // mm beside the line through a side, to the left.
  const auto beside = [](const Side& s, Vec2 p) {
    const Vec2 d = s.b - s.a, e = p - s.a;
    const double l = glm::length(d);
    return l > 0 ? (d.x * e.y - d.y * e.x) / l : 0;
  };
  const auto apart = [](double x, double y) {
    constexpr double kTouch = 1e-6;
    return (x > kTouch && y < -kTouch) || (x < -kTouch && y > kTouch);
  };
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& s = sides[i];
    for (std::size_t k = i + 1; k < sides.size() && sides[k].low.x <= s.high.x; ++k) {
      const Side& t = sides[k];
      if (t.low.y > s.high.y || s.low.y > t.high.y) continue;
      const double c = beside(s, t.a), d = beside(s, t.b);
      if (!apart(c, d) || !apart(beside(t, s.a), beside(t, s.b))) continue;
      out.push_back(glm::mix(t.a, t.b, c / (c - d)));
    }
  }
  return out;
}

/// What holds of every partition of a sheet: rings turn as they should and do not cross themselves,
/// neighbours name each other, and the regions cover the sheet once.
inline void expect_sound(const Partition& p, const Box2& sheet) {
  const double total =
      std::accumulate(p.regions.begin(), p.regions.end(), 0.0,
                      [](double sum, const AreaRegion& r) { return sum + r.area; });
  EXPECT_NEAR(total / (sheet.size().x * sheet.size().y), 1, 1e-9);
  std::multiset<std::array<std::int64_t, 4>> sides;  // from, to, region, beyond
  for (std::size_t r = 0; r < p.regions.size(); ++r) {
    ASSERT_FALSE(p.regions[r].rings.empty());
    double area = 0;
    for (std::size_t k = 0; k < p.regions[r].rings.size(); ++k) {
      const AreaRing& ring = p.regions[r].rings[k];
      ASSERT_GE(ring.corners.size(), 3u);
      const std::vector<Vec2> points = p.polygon(ring);
      for (std::size_t i = 0; i < ring.corners.size(); ++i) {
        ASSERT_NE(ring.beyond[i], static_cast<std::int32_t>(r));
        sides.insert({ring.corners[i], ring.corners[(i + 1) % ring.corners.size()],
                      static_cast<std::int64_t>(r), ring.beyond[i]});
      }
      const double turned = signed_area(points);
      EXPECT_EQ(turned > 0, k == 0) << r << ' ' << k;
      area += turned;
      EXPECT_TRUE(self_crossings(points).empty()) << r << ' ' << k;
    }
    EXPECT_NEAR(area, p.regions[r].area, 1e-9);
  }
  for (const auto& [from, to, region, beyond] : sides) {
    if (beyond >= 0) {
      EXPECT_EQ(sides.count({to, from, beyond, region}), 1u);
    }
  }
}

}  // namespace burin::test
