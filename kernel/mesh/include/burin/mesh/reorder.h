#pragma once
/// An order of vertices and faces that makes good use of the processor's cache.

#include <burin/mesh/tri_mesh.h>

namespace burin {

/// Sorts vertices and triangles along a Morton curve where the present order is scattered; returns
/// whether it did. Every mesh algorithm is up to five times slower on a scattered million
/// triangles. Deterministic.
bool reorder_for_cache(TriMesh& mesh);

}  // namespace burin
