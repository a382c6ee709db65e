#pragma once
// Components of a mesh, and small ones of organic data.

#include <burin/base/box.h>
#include <burin/base/disjoint_sets.h>

#include "exact_mesh.h"

#include <cstdint>
#include <vector>

namespace burin {

/// Which vertices belong together, and the box of each component by the name of its set.
struct MeshComponents {
  DisjointSets sets;
  std::vector<Box3> boxes;

  explicit MeshComponents(const ExactMesh& mesh);
};

/// Components with a diagonal below `limit` model mm of which a grid has seen one side: nonzero by
/// the name of their set. Triangles close such a component behind the surface, against the normals
/// at their corners, as those of a ball around one sample next to its rim.
std::vector<std::uint8_t> one_sided_components(const ExactMesh& mesh, MeshComponents& parts,
                                               double limit);

/// The largest diagonal of a component's box.
double largest_component(const ExactMesh& mesh);

/// Leaves out the components whose entry in `dropped`, by the name of their set, is not zero.
void drop_components(ExactMesh& mesh, MeshComponents& parts,
                     const std::vector<std::uint8_t>& dropped);

/// Leaves out the components whose boxes have a diagonal below `smallest` model mm; returns their
/// number.
std::size_t drop_specks(ExactMesh& mesh, double smallest);

}  // namespace burin
