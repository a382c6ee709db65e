#pragma once
/// What `burin info` measures on triangles.

#include <burin/converters/file_info.h>
#include <burin/mesh/tri_mesh.h>

namespace burin {

/// Sets `area` and `volume` of a part whose `bounds` and `boundary_edges` are known: of its
/// triangles, model mm. Taken about the middle of the bounds, so that a part far from the origin
/// loses no digits; the volume of an open part is 0.
void measure_triangles(const TriMesh& mesh, PartInfo& info);

}  // namespace burin
