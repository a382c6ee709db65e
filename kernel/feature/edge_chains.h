#pragma once
// The creases and boundaries of a part as chains that no view changes.

#include <burin/base/run_context.h>
#include <burin/feature/feature.h>
#include <burin/mesh/proxy_mesh.h>

#include <cstddef>
#include <span>
#include <vector>

namespace burin {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Half-edges head to tail, all of one kind. Creases: the triangle of each half-edge lies to the
/// left, its opposite to the right.
struct EdgeChain {
  std::vector<HalfEdge> edges;
  EdgeKind kind = EdgeKind::Boundary;
  bool closed = false;
  /// For SourceId::edge: the edge of the input that all of the chain lies on (-1 = none), or where
  /// the proxy knows none, the chain's place in the list.
  std::int32_t source = -1;
  /// Of kind Smooth: where a face meets itself.
  bool seam = false;
  /// Of kind Smooth: where triangles face different ways in one view, and nothing else is drawn.
  bool fold = false;
};

/// Whether `chain_edges` has an edge.
bool is_chained(const ProxyMesh& proxy, HalfEdge half_edge, const FeatureOptions& options);

/// All creases and boundaries, and what `options` ask for of the smooth edges of the input, in
/// order of their edge of the input, then of their first half-edge. Chains end where convex turns
/// to concave and where another line of the same edge of the input joins (without a source: any
/// other crease or boundary). Linear.
std::vector<EdgeChain> chain_edges(const ProxyMesh& proxy, const FeatureOptions& options,
                                   const RunContext& context);

/// Chains of folds (`Facing::folds`), which belong to one view and have no source. Linear.
std::vector<EdgeChain> chain_folds(const ProxyMesh& proxy, std::span<const HalfEdge> folds);

}  // namespace burin
