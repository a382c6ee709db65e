#pragma once
// Small components of organic data.

#include "exact_mesh.h"

namespace burin {

/// The largest diagonal of a component's box.
double largest_component(const ExactMesh& mesh);

/// Leaves out the components whose boxes have a diagonal below `smallest` model mm; returns their
/// number.
std::size_t drop_specks(ExactMesh& mesh, double smallest);

}  // namespace burin
