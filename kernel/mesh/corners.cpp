#include <burin/mesh/corners.h>

#include <array>

namespace burin {

Corners corners_at(const std::vector<Triangle>& triangles, std::size_t count) {
  return grouped(
      count, triangles.size(), [&](std::size_t t) { return triangles[t]; },
      [](std::size_t t) {
        const auto h = static_cast<HalfEdge>(3 * t);
        return std::array{h, h + 1, h + 2};
      });
}

}  // namespace burin
