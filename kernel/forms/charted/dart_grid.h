#pragma once
// Points in a grid of cubes, hashed: who is near?

#include <burin/base/vec.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace burin {

class DartGrid {
 public:
  DartGrid(double cell, std::size_t expected) : cell_(cell) {
    std::size_t buckets = 16;
    while (buckets < 2 * expected) buckets *= 2;
    head_.assign(buckets, -1);
  }

  std::size_t size() const { return points_.size(); }

  void add(Vec3 p) {
    const auto index = static_cast<std::int32_t>(points_.size());
    points_.push_back(p);
    next_.push_back(-1);
    if (points_.size() > head_.size()) return rehash();
    link(index);
  }

  /// Whether a point that `counts(index, distance squared)` accepts lies within `radius`.
  template <class Counts>
  bool any_within(Vec3 p, double radius, Counts counts) const {
    const Cell low = cell_of(p - radius), high = cell_of(p + radius);
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          bool found = false;
          visit({x, y, z}, [&](std::int32_t i, const Vec3& q) {
            const double d2 = glm::dot(p - q, p - q);
            found = found || (d2 < radius * radius && counts(i, d2));
          });
          if (found) return true;
        }
      }
    }
    return false;
  }

  /// Distance to the nearest point that `counts(index)` accepts; infinite where there is none.
  template <class Counts>
  double nearest(Vec3 p, Counts counts) const {
    constexpr std::int64_t kMaxRing = 6;  // beyond, going through all points costs less
    double best = std::numeric_limits<double>::infinity();
    const Cell center = cell_of(p);
    for (std::int64_t ring = 0; ring <= kMaxRing; ++ring) {
      const double reach = static_cast<double>(ring - 1) * cell_;
      if (ring > 0 && best <= reach * reach) return std::sqrt(best);
      visit_ring(center, ring, [&](std::int32_t i, const Vec3& q) {
        const double d2 = glm::dot(p - q, p - q);
        if (d2 < best && counts(i)) best = d2;
      });
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double d2 = glm::dot(p - points_[i], p - points_[i]);
      if (d2 < best && counts(static_cast<std::int32_t>(i))) best = d2;
    }
    return std::sqrt(best);
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(Vec3 p) const {
    const Vec3 q = glm::floor(p / cell_);
    return {static_cast<std::int64_t>(q.x), static_cast<std::int64_t>(q.y),
            static_cast<std::int64_t>(q.z)};
  }
  std::size_t bucket(const Cell& c) const {
    std::uint64_t h = 0;
    for (const std::int64_t x : c) {
      h = (h + static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15ull;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h) & (head_.size() - 1);
  }
  void link(std::int32_t index) {
    std::int32_t& head = head_[bucket(cell_of(points_[static_cast<std::size_t>(index)]))];
    next_[static_cast<std::size_t>(index)] = head;
    head = index;
  }
  void rehash() {
    head_.assign(4 * head_.size(), -1);
    for (std::size_t i = 0; i < points_.size(); ++i) link(static_cast<std::int32_t>(i));
  }
  /// Points of other cells in the same bucket come along: callers look at distances anyway.
  template <class Visit>
  void visit(const Cell& c, Visit f) const {
    for (std::int32_t i = head_[bucket(c)]; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
      f(i, points_[static_cast<std::size_t>(i)]);
    }
  }
  template <class Visit>
  void visit_ring(const Cell& center, std::int64_t ring, Visit f) const {
    for (std::int64_t x = -ring; x <= ring; ++x) {
      for (std::int64_t y = -ring; y <= ring; ++y) {
        const bool inside = std::max(std::abs(x), std::abs(y)) < ring;
        const std::int64_t step = inside ? std::max<std::int64_t>(2 * ring, 1) : 1;
        for (std::int64_t z = -ring; z <= ring; z += step) {
          visit({center[0] + x, center[1] + y, center[2] + z}, f);
        }
      }
    }
  }

  double cell_;
  std::vector<Vec3> points_;
  std::vector<std::int32_t> head_, next_;
};

}  // namespace burin
