#pragma once
/// How far triangles lie from the surface that they stand for.

#include <burin/base/run_context.h>
#include <burin/forms/parametric/atlas.h>

namespace burin {

/// The largest distance between S at the (u,v) of a triangle's centre or of an edge's middle and
/// the same point of the triangle; on model edges between the edge and its chord. Cost: 0.2 us a
/// triangle.
double measure_tolerance(const ChartMesh& mesh, const Atlas& atlas, const RunContext& context);

}  // namespace burin
