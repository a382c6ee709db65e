#include "near_places.h"

#include <algorithm>
#include <cmath>

namespace burin::detail {

NearPlaces::NearPlaces(std::span<const Vec3> places) {
  for (const Vec3& p : places) box_.add(p);
  const Vec3 size = box_.size();
  const double longest = std::max({size.x, size.y, size.z});
  // Along directions in which the places differ at all: a row, a layer or a block of cells.
  constexpr double kFlat = 1e-3;
  double product = 1;
  int directions = 0;
  for (int k = 0; k < 3; ++k) {
    if (size[k] <= kFlat * longest) continue;
    product *= size[k];
    ++directions;
  }
  if (directions > 0) {
    side_ = std::pow(product / static_cast<double>(places.size()), 1.0 / directions);
  }
  if (!(side_ > 0)) side_ = 1;
  for (std::size_t i = 0; i < places.size(); ++i) cells_[cell_of(places[i])].push_back(i);
  most_ = cell_of(box_.max);
}

NearPlaces::Cell NearPlaces::cell_of(Vec3 p) const {
  Cell cell{};
  for (int k = 0; k < 3; ++k) {
    // From the outside the nearest cells are those at the border.
    const double inside = std::clamp(p[k], box_.min[k], box_.max[k]);
    cell[static_cast<std::size_t>(k)] =
        static_cast<std::int64_t>(std::floor((inside - box_.min[k]) / side_));
  }
  return cell;
}

std::vector<std::size_t> NearPlaces::find(Vec3 at, std::size_t count) const {
  std::vector<std::size_t> found;
  const Cell middle = cell_of(at);
  const auto add = [&](const Cell& cell) {
    const auto known = cells_.find(cell);
    if (known == cells_.end()) return;
    for (const std::size_t i : known->second) {
      if (found.size() < 8 * count) found.push_back(i);
    }
  };
  const std::int64_t farthest = std::max({most_[0], most_[1], most_[2]}) + 1;
  bool enough = false;
  for (std::int64_t shell = 0; shell <= farthest && !enough; ++shell) {
    enough = found.size() >= count;
    const auto range = [&](std::size_t k) {
      return std::array{std::max<std::int64_t>(middle[k] - shell, 0),
                        std::min(middle[k] + shell, most_[k])};
    };
    const auto [x0, x1] = range(0);
    const auto [y0, y1] = range(1);
    const auto [z0, z1] = range(2);
    for (std::int64_t x = x0; x <= x1; ++x) {
      for (std::int64_t y = y0; y <= y1; ++y) {
        const bool side = std::abs(x - middle[0]) == shell || std::abs(y - middle[1]) == shell;
        for (std::int64_t z = z0; z <= z1; ++z) {
          // Inside the shell everything was looked at: on to its far side.
          if (!side && z > middle[2] - shell && z < middle[2] + shell) {
            z = std::min(middle[2] + shell, z1 + 1) - 1;
            continue;
          }
          add({x, y, z});
        }
      }
    }
  }
  return found;
}

}  // namespace burin::detail
