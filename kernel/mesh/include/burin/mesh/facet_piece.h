#pragma once
/// Triangles that facets were divided into.

#include <burin/base/vec.h>

#include <array>
#include <cstddef>
#include <optional>

namespace burin {

/// Of a piece whose corners have these barycentric coordinates in its facet: the edge of the facet,
/// by its first corner, on which the edge from corner `k` of the piece lies; nothing inside.
inline std::optional<std::size_t> facet_edge(const std::array<Vec3, 3>& bary, std::size_t k) {
  for (std::size_t side = 0; side < 3; ++side) {
    const auto off = static_cast<int>(side);
    if (bary[k][off] == 0 && bary[(k + 1) % 3][off] == 0) return (side + 1) % 3;
  }
  return std::nullopt;
}

}  // namespace burin
