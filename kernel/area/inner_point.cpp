#include <burin/area/partition.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace burin {
namespace {

/// Paper mm from the nearest side; negative outside.
double inside_by(std::span<const std::vector<Vec2>> rings, Vec2 p) {
  bool inside = false;
  double nearest2 = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec2>& ring : rings) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Vec2 a = ring[j], b = ring[i], d = b - a;
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + d.x * (p.y - a.y) / d.y) inside = !inside;
      const double length2 = glm::dot(d, d);
      const double t = length2 > 0 ? std::clamp(glm::dot(p - a, d) / length2, 0.0, 1.0) : 0;
      const Vec2 away = a + t * d - p;
      nearest2 = std::min(nearest2, glm::dot(away, away));
    }
  }
  return (inside ? 1 : -1) * std::sqrt(nearest2);
}

struct Cell {
  Vec2 center{0};
  double half = 0, radius = 0;
  double most() const { return radius + half * std::sqrt(2.0); }
  bool operator<(const Cell& other) const { return most() < other.most(); }
};

}  // namespace

InnerPoint inner_point(std::span<const std::vector<Vec2>> rings, double precision) {
  Box2 box;
  for (const std::vector<Vec2>& ring : rings) {
    for (const Vec2& p : ring) box.add(p);
  }
  const double side = box.empty() ? 0 : std::min(box.size().x, box.size().y);
  if (!(side > 0)) return {};
  std::priority_queue<Cell> cells;
  const auto push = [&](Vec2 center, double half) {
    cells.push({center, half, inside_by(rings, center)});
  };
  InnerPoint best;
  const double half = 0.5 * side;
  const Vec2 count = glm::ceil(box.size() / side);
  for (double y = 0; y < count.y; ++y) {
    for (double x = 0; x < count.x; ++x) push(box.min + side * Vec2(x + 0.5, y + 0.5), half);
  }
  // Each division halves a cell: as many as lie along a strip of the border are enough.
  constexpr int kMostCells = 20000;
  for (int k = 0; k < kMostCells && !cells.empty(); ++k) {
    const Cell cell = cells.top();
    cells.pop();
    if (cell.radius > best.radius) best = {cell.center, cell.radius};
    if (cell.most() - best.radius <= precision) break;
    const double h = 0.5 * cell.half;
    for (const Vec2& way : {Vec2(-h, -h), Vec2(h, -h), Vec2(-h, h), Vec2(h, h)}) {
      push(cell.center + way, h);
    }
  }
  return best;
}

}  // namespace burin
