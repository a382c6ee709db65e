#pragma once
// Tips of cones.

#include "exact_mesh.h"

namespace burin {

/// Puts a vertex onto each tip of the surface, where the tangent planes around meet in a point of
/// f = 0, and joins it to the triangles around. It has no normal, and contours pass through it.
void place_tips(ExactMesh& mesh, const ImplicitFunction& f, const Nets& nets);

}  // namespace burin
