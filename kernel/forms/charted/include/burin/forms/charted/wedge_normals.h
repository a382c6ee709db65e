#pragma once
/// Exact normals at the corners of an atlas's triangles.

#include <burin/base/run_context.h>
#include <burin/forms/charted/atlas.h>

namespace burin {

/// Gives every corner the normal of its wedge: exact, and the mean of both faces where a smooth
/// edge joins them. Fills `normal`; `on_contour` is set where there is none (the tip of a cone) and
/// cleared elsewhere. Cost: an evaluation of S a corner of a face.
void set_wedge_normals(ChartMesh& mesh, const PlacedAtlas& atlas, const RunContext& context);

}  // namespace burin
