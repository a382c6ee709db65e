#pragma once
/// The corners of every wedge.

#include <burin/base/groups.h>
#include <burin/mesh/proxy_mesh.h>

namespace burin::field {

/// For each wedge its corners as half-edges that start there, ascending.
Groups<HalfEdge> wedge_corners(const ProxyMesh& proxy);

}  // namespace burin::field
