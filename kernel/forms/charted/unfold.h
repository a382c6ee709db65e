#pragma once
/// Triangles that lie face down, turned up by flipping edges.

#include <burin/forms/charted/raw_mesh.h>
#include <burin/mesh/topology.h>

#include "break_lines.h"

#include <cstddef>
#include <vector>

namespace burin {

inline std::size_t at(HalfEdge h) { return static_cast<std::size_t>(h); }

/// Where the middle of a curved border moves over a thin triangle, or the mesher left a fold,
/// triangles are turned in (u,v). Flips edges inside faces that make the smaller of two areas
/// greater until none is turned or nothing helps, and those (not along break lines) over which
/// slivers bend by more than 60 degrees, where that makes them flatter. Returns the triangles that
/// changed. Cost: 5 ns per triangle where none is turned.
std::vector<std::size_t> unfold(RawMesh& raw, std::vector<HalfEdge>& opposite, const Atlas& atlas,
                                const detail::BreakLines& lines);

}  // namespace burin
