#include "sides.h"

#include <burin/base/box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace burin::irit {
namespace {

struct Side {
  std::uint32_t list = 0;
  Vec3 begin, middle, end;
  bool collapsed = false;
};

Side side_of(const Chart& chart, Vec2 from, Vec2 to, std::uint32_t list, double tolerance) {
  const auto at = [&](double t) { return chart.position(from + t * (to - from)); };
  Side side{list, at(0), at(0.5), at(1)};
  const Vec3 quarter = at(0.25);
  side.collapsed = glm::distance(side.begin, side.middle) < tolerance &&
                   glm::distance(side.begin, quarter) < tolerance;
  return side;
}

bool same(const Side& a, const Side& b, double tolerance) {
  const auto near = [&](Vec3 p, Vec3 q) { return glm::distance(p, q) < tolerance; };
  return near(a.middle, b.middle) && ((near(a.begin, b.begin) && near(a.end, b.end)) ||
                                      (near(a.begin, b.end) && near(a.end, b.begin)));
}

std::array<Vec2, 4> corners(const Chart& chart) {
  const ParameterBox box = chart.domain();
  return {box.min, Vec2(box.max.x, box.min.y), box.max, Vec2(box.min.x, box.max.y)};
}

/// Sides by the cell of their middle.
class Grid {
 public:
  Grid(Vec3 origin, double cell) : origin_(origin), cell_(cell) {}
  void add(Vec3 p, std::size_t side) { sides_.emplace(key(index(p)), side); }
  template <class Visit>
  void near(Vec3 p, const Visit& visit) const {
    const auto center = index(p);
    for (int i = 0; i < 27; ++i) {
      const auto range = sides_.equal_range(
          key({center[0] + i % 3 - 1, center[1] + i / 3 % 3 - 1, center[2] + i / 9 - 1}));
      for (auto it = range.first; it != range.second; ++it) visit(it->second);
    }
  }

 private:
  using Index = std::array<std::int64_t, 3>;
  Index index(Vec3 p) const {
    constexpr double kFar = 1e15;  // whatever the file says, an index is an integer
    const auto of = [&](double x) {
      return static_cast<std::int64_t>(std::floor(std::clamp(x / cell_, -kFar, kFar)));
    };
    const Vec3 q = p - origin_;
    return {of(q.x), of(q.y), of(q.z)};
  }
  static std::uint64_t key(Index i) {
    std::uint64_t h = 0;
    for (const std::int64_t k : i) {
      h = (h ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return h;
  }
  Vec3 origin_;
  double cell_;
  std::unordered_multimap<std::uint64_t, std::size_t> sides_;
};

}  // namespace

void join_sides(const std::vector<Patches>& lists, DisjointSets& sets) {
  Box3 box;
  for (const Patches& list : lists) {
    for (const auto& chart : list) {
      for (const Vec2 uv : corners(*chart)) box.add(chart->position(uv));
      box.add(chart->position(chart->domain().center()));
    }
  }
  const double tolerance = kWeld * box.diagonal();
  if (lists.size() < 2 || !(tolerance > 0) || !std::isfinite(tolerance)) return;
  std::vector<Side> sides;
  Grid grid(box.min, 2 * tolerance);
  for (std::uint32_t i = 0; i < lists.size(); ++i) {
    for (const auto& chart : lists[i]) {
      const std::array<Vec2, 4> corner = corners(*chart);
      for (std::size_t k = 0; k < 4; ++k) {
        const Side side = side_of(*chart, corner[k], corner[(k + 1) % 4], i, tolerance);
        if (side.collapsed) continue;
        grid.near(side.middle, [&](std::size_t other) {
          if (same(side, sides[other], tolerance)) sets.join(sides[other].list, i);
        });
        grid.add(side.middle, sides.size());
        sides.push_back(side);
      }
    }
  }
}

}  // namespace burin::irit
