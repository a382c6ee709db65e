#pragma once
// The bounding box of round surfaces, which bulge beyond the corners of their mesh; private to this
// module.

#include <burin/base/box.h>

#include "recognise.h"

namespace burin::recognised {

/// Adds to `box`, which holds the corners of `mesh` along `axes` (rows of the matrix that turns
/// them), the points of the round surfaces that stick out of it, to a chord of `tolerance` mm, and
/// 256 times finer around the farthest points. Only triangles that come near its sides are looked
/// at.
void add_outermost(Box3& box, const Mat3& axes, const TriMesh& mesh, const Recognised& round,
                   const Facets& facets, double tolerance, const RunContext& context);

}  // namespace burin::recognised
