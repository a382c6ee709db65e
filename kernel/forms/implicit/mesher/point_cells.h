#pragma once
// Points near a place.

#include <burin/base/vec.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace burin {

/// Points by cubes of space, whose side is the reach of `any_near`.
class PointCells {
 public:
  PointCells(const std::vector<Vec3>& points, double side) : points_(points), side_(side) {
    for (std::uint32_t i = 0; i < points.size(); ++i) cells_[key(cell(points[i]))].push_back(i);
  }

  /// Whether one for which `wanted` holds is nearer than `side`.
  template <class Wanted>
  bool any_near(Vec3 p, const Wanted& wanted) const {
    if (points_.empty()) return false;
    const glm::ivec3 middle = cell(p);
    for (int k = 0; k < 27; ++k) {
      const auto it = cells_.find(key(middle + Cell(k % 3, k / 3 % 3, k / 9) - 1));
      if (it == cells_.end()) continue;
      for (const std::uint32_t i : it->second) {
        if (glm::distance(points_[i], p) < side_ && wanted(i)) return true;
      }
    }
    return false;
  }
  bool any_near(Vec3 p) const {
    return any_near(p, [](std::uint32_t) { return true; });
  }

 private:
  using Cell = glm::ivec3;
  Cell cell(Vec3 p) const { return Cell(glm::floor((p - points_.front()) / side_)); }
  static std::uint64_t key(Cell c) {
    const auto part = [](int v) { return static_cast<std::uint64_t>(v) & 0x1fffff; };
    return part(c.x) | (part(c.y) << 21) | (part(c.z) << 42);
  }

  const std::vector<Vec3>& points_;
  double side_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace burin
