#pragma once
/// OCCT's mesher, contained.

#include <burin/base/run_context.h>

#include "model_parts.h"

#include <vector>

namespace burin {

/// Leaves triangulations on the faces, some times coarser than `tolerance` (refine.h does the
/// rest), and polygons on the edges that all their faces share. What
/// was there before is removed first, so that the result depends on the tolerance alone. Faces
/// without triangles are tried again by another algorithm, other tolerances and after mending.
/// Returns the faces, by their numbers, that have a chart and yet no triangles, or not all of them.
/// Throws Cancelled.
std::vector<std::int32_t> mesh_shape(ModelParts& parts, double tolerance, RunContext& context);

/// A face meshed by itself, its nodes shared with nobody: with other tolerances, and after mending
/// its wires. Empty where all of that fails.
LooseTriangles mesh_alone(const ModelParts& parts, std::int32_t face, double tolerance,
                          RunContext& context);

/// The triangles that a face has, turned like the forward face; `number` is what they are given as
/// their face.
LooseTriangles triangles_on(const TopoDS_Face& face, std::int32_t number);

/// Removes all triangulations and polygons.
void clear_mesh(ModelParts& parts);

}  // namespace burin
