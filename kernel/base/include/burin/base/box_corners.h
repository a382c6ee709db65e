#pragma once
/// The corners of a box in space.

#include <burin/base/box.h>

#include <array>
#include <cstddef>

namespace burin {

/// Bit 0 of an index is set where x is the greater one, bit 1 for y, bit 2 for z.
inline std::array<Vec3, 8> corners_of(const Box3& box) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {i & 1U ? box.max.x : box.min.x, i & 2U ? box.max.y : box.min.y,
                  i & 4U ? box.max.z : box.min.z};
  }
  return corners;
}

}  // namespace burin
