#pragma once
/// Triangles that lie face down, turned up by flipping edges.

#include <burin/mesh/topology.h>

#include "raw_mesh.h"

#include <vector>

namespace burin {

/// Where the middle of a curved border moves over a thin triangle, or the mesher left a fold,
/// triangles are turned in (u,v). Flips edges inside faces that make the smaller of two areas
/// greater until none is turned or nothing helps, and those over which slivers bend by more than 60
/// degrees, where that makes them flatter. Returns the triangles that changed. Cost: 5 ns a
/// triangle where none is turned.
std::vector<std::size_t> unfold(RawMesh& raw, std::vector<HalfEdge>& opposite, const Atlas& atlas);

}  // namespace burin
