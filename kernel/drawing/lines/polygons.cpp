#include <burin/base/box.h>
#include <burin/drawing/polygons.h>

#include <cmath>

namespace burin {
namespace {

/// Places of a ring that are asked; most of them decide, as rings may touch.
constexpr std::size_t kAsked = 9;

/// A ring beside others.
struct Ring {
  std::span<const Vec2> points;
  Box2 box;
  double area = 0;

  explicit Ring(std::span<const Vec2> of) : points(of) {
    double doubled = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 &a = points[i], &b = points[(i + 1) % points.size()];
      box.add(a);
      doubled += a.x * b.y - a.y * b.x;
    }
    area = std::abs(doubled) / 2;
  }

  bool holds(Vec2 p) const {
    bool odd = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 &a = points[i], &b = points[(i + 1) % points.size()];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
    }
    return odd;
  }

  bool is_within(const Ring& other) const {
    const bool may_be = area < other.area && box.min.x >= other.box.min.x &&
                        box.min.y >= other.box.min.y && box.max.x <= other.box.max.x &&
                        box.max.y <= other.box.max.y;
    if (!may_be) return false;
    std::size_t held = 0;
    const std::size_t n = points.size();
    for (std::size_t k = 0; k < kAsked; ++k) {
      const std::size_t i = k * n / kAsked;
      if (other.holds(0.5 * (points[i] + points[(i + 1) % n]))) ++held;
    }
    return 2 * held > kAsked;
  }
};

}  // namespace

std::vector<RingPolygon> polygons_of(std::span<const std::vector<Vec2>> rings) {
  const std::vector<Ring> all(rings.begin(), rings.end());
  std::vector<std::size_t> depth(all.size(), 0), around(all.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (i == j || !all[i].is_within(all[j])) continue;
      ++depth[i];
      if (around[i] == all.size() || all[j].area < all[around[i]].area) around[i] = j;
    }
  }
  std::vector<RingPolygon> out;
  std::vector<std::size_t> of_shell(all.size(), 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (depth[i] % 2 != 0) continue;
    of_shell[i] = out.size();
    out.push_back({i});
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (depth[i] % 2 != 0) out[of_shell[around[i]]].holes.push_back(i);
  }
  return out;
}

}  // namespace burin
