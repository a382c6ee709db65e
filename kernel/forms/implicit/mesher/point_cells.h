#pragma once
// Points near a place.

#include <burin/base/vec.h>

#include "grid.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace burin {

/// Points by cubes of space, whose side is the reach of `any_near`.
class PointCells {
 public:
  PointCells(const std::vector<Vec3>& points, double side) : points_(points), side_(side) {
    cells_.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      cells_.emplace_back(key(cell(points[i])), i);
    }
    std::ranges::sort(cells_);
  }

  /// Whether one for which `wanted` holds is nearer than `side`.
  template <class Wanted>
  bool any_near(Vec3 p, const Wanted& wanted) const {
    if (points_.empty()) return false;
    const glm::ivec3 middle = cell(p);
    // Three cells beside each other along x have names that follow one another.
    for (int k = 0; k < 9; ++k) {
      const Cell first = middle + Cell(-1, k % 3 - 1, k / 3 - 1);
      const std::uint64_t last = key(first + Cell(2, 0, 0));
      auto it = std::ranges::lower_bound(cells_, std::pair(key(first), std::uint32_t{0}));
      for (; it != cells_.end() && it->first <= last; ++it) {
        if (glm::distance(points_[it->second], p) < side_ && wanted(it->second)) return true;
      }
    }
    return false;
  }
  bool any_near(Vec3 p) const {
    return any_near(p, [](std::uint32_t) { return true; });
  }

 private:
  Cell cell(Vec3 p) const { return Cell(glm::floor((p - points_.front()) / side_)); }
  static std::uint64_t key(Cell c) {
    constexpr int kMiddle = 1 << 20;
    return name_of(c + kMiddle);
  }

  const std::vector<Vec3>& points_;
  double side_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> cells_;  // by their names
};

}  // namespace burin
