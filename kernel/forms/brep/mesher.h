#pragma once
/// OCCT's mesher, contained.

#include <burin/base/run_context.h>

#include "model_parts.h"

namespace burin {

/// Leaves triangulations on the faces, some times coarser than `tolerance` (refine.h does the
/// rest), and polygons on the edges that all their faces share. What
/// was there before is removed first, so that the result depends on the tolerance alone. Faces
/// without triangles are tried again by another algorithm, other tolerances and after mending.
/// Throws Cancelled.
void mesh_shape(ModelParts& parts, double tolerance, RunContext& context);

/// Removes all triangulations and polygons.
void clear_mesh(ModelParts& parts);

}  // namespace burin
