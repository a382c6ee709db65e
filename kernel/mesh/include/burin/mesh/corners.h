#pragma once
/// The corners at each vertex, or at each wedge, of triangles.

#include <burin/base/groups.h>
#include <burin/mesh/topology.h>

#include <vector>

namespace burin {

using Corners = Groups<HalfEdge>;

/// For each of `count` numbers that stand at the corners of `triangles` its corners, as half-edges
/// that start there, ascending.
Corners corners_at(const std::vector<Triangle>& triangles, std::size_t count);

}  // namespace burin
