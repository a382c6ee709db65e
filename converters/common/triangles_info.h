#pragma once
/// What `burin info` measures on triangles.

#include <burin/base/run_context.h>
#include <burin/converters/file_info.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/surface/scene.h>

namespace burin {

/// Sets `area` and `volume` of a part whose `bounds` and `boundary_edges` are known: of its
/// triangles, model mm. Taken about the middle of the bounds, so that a part far from the origin
/// loses no digits; the volume of an open part is 0.
void measure_triangles(const TriMesh& mesh, PartInfo& info);

/// What is told of a part that has no triangles of its own: of those that it is realised by, within
/// 1e-4 of its size. What they lack goes to `diagnostics`. Throws as `Form::realise`.
PartInfo measure_realised_part(const Part& part, Diagnostics& diagnostics, RunContext& context);

}  // namespace burin
