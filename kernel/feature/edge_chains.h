#pragma once
// The creases and boundaries of a part as chains that no view changes.

#include <burin/base/run_context.h>
#include <burin/mesh/proxy_mesh.h>

#include <vector>

namespace burin {

/// Half-edges head to tail, all of one kind. The chain's place in the list is its number in
/// SourceId::edge. Creases: the triangle of each half-edge lies to the left, its opposite to the
/// right.
struct EdgeChain {
  std::vector<HalfEdge> edges;
  EdgeKind kind = EdgeKind::Boundary;
  bool closed = false;
};

/// All creases and boundaries, in order of their first half-edge. Chains end where another crease
/// or boundary joins and where convex turns to concave. Linear.
std::vector<EdgeChain> chain_edges(const ProxyMesh& proxy, const RunContext& context);

}  // namespace burin
