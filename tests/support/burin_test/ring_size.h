#pragma once
/// What rings enclose.

#include <burin/base/vec.h>
#include <burin/drawing/drawing.h>

#include <cstddef>
#include <span>

namespace burin::test {

/// Negative of a ring that runs clockwise.
inline double signed_area(std::span<const Vec2> ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += cross2(ring[i], ring[(i + 1) % ring.size()]);
  return 0.5 * sum;
}

/// mm^2 of paper; rings within rings are holes.
inline double signed_area(const Area& area) {
  double sum = 0;
  for (const auto& ring : area.rings) sum += signed_area(ring);
  return sum;
}

}  // namespace burin::test
