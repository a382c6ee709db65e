#pragma once
/// Triangles split until they are near enough to the surface.

#include <burin/base/run_context.h>

#include "make_manifold.h"
#include "raw_mesh.h"

namespace burin {

/// Splits edges in the middle, on both sides alike, until S is within `tolerance` of every edge and
/// of every triangle's centre (tangential deviations count a quarter). New vertices lie on the
/// surface, those on model edges on the edge. The mesher's own control of the inside of faces does
/// the same at many times the cost. Deterministic. Sets mesh.tolerance to what was measured
/// last, deviations along the triangles in full. Edges that `pairs` names are split in any case.
/// Cost: 1 us a triangle that comes out.
void refine(RawMesh& raw, ManifoldPairs pairs, const Atlas& atlas, double tolerance,
            const RunContext& context);

}  // namespace burin
