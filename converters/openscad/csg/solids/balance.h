#pragma once
// Unions of many, as unions of what lies together; for csg/solids alone.

#include "boolean.h"

namespace burin::csg {

inline Box3 common(const Box3& a, const Box3& b) {
  return {glm::max(a.min, b.min), glm::min(a.max, b.max)};
}

/// For every node a box that holds whatever it can be.
std::vector<Box3> boxes_of(const Formula& formula, std::span<const Mesh> meshes);

/// The same formula, in which no union has more than a few children: what lies close together has
/// a node of its own, so that a place is asked of few boxes, not of all.
Formula balanced(const Formula& whole, std::span<const Box3> box);

}  // namespace burin::csg
