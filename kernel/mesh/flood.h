#pragma once
/// Connected components of triangles.

#include <burin/mesh/topology.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Labels triangles that half-edges with `crossable(h)` connect; labels count from 0 in order of
/// the first triangle. Returns the number of labels.
template <class Crossable>
std::int32_t flood(const std::vector<HalfEdge>& opposite, const Crossable& crossable,
                   std::vector<std::int32_t>& label) {
  const std::size_t faces = opposite.size() / 3;
  label.assign(faces, -1);
  std::vector<std::uint32_t> stack;
  std::int32_t count = 0;
  for (std::uint32_t seed = 0; seed < faces; ++seed) {
    if (label[seed] >= 0) continue;
    label[seed] = count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const HalfEdge first = static_cast<HalfEdge>(3 * stack.back());
      stack.pop_back();
      for (HalfEdge h = first; h < first + 3; ++h) {
        const HalfEdge o = opposite[static_cast<std::size_t>(h)];
        if (o == kNoHalfEdge || label[face_of(o)] >= 0 || !crossable(h)) continue;
        label[face_of(o)] = count;
        stack.push_back(face_of(o));
      }
    }
    ++count;
  }
  return count;
}

}  // namespace burin
