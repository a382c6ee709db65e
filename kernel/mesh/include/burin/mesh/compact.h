#pragma once
/// Meshes without what none of their triangles has.

#include <burin/mesh/tri_mesh.h>

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace burin {

/// Drops positions without a triangle; the others stand in the order in which the triangles name
/// them. Cost: linear.
inline void compact(std::vector<Vec3>& positions, std::vector<Triangle>& triangles) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(positions.size(), kNone);
  std::vector<Vec3> used;
  for (Triangle& t : triangles) {
    for (std::uint32_t& v : t) {
      if (number[v] == kNone) {
        number[v] = static_cast<std::uint32_t>(used.size());
        used.push_back(positions[v]);
      }
      v = number[v];
    }
  }
  positions = std::move(used);
}

}  // namespace burin
