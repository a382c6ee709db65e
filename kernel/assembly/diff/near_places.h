#pragma once
// Which of many places are near; internal to the module.

#include <burin/base/box.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace burin::detail {

/// Places in cells of about one each.
class NearPlaces {
 public:
  explicit NearPlaces(std::span<const Vec3> places);

  /// About `count` of the nearest places, and no more than eight times as many, in no order: all of
  /// the cells around, shell after shell, until there are enough and one shell more.
  std::vector<std::size_t> find(Vec3 at, std::size_t count) const;

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell_of(Vec3 p) const;

  Box3 box_;
  double side_ = 1;
  Cell most_{};
  std::map<Cell, std::vector<std::size_t>> cells_;
};

}  // namespace burin::detail
