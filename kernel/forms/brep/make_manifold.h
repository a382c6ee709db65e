#pragma once
/// Triangles of a shape whose edges may have three faces, made manifold.

#include <burin/forms/parametric/atlas.h>
#include <burin/mesh/topology.h>

#include <vector>

namespace burin {

struct ManifoldPairs {
  /// For each half-edge the opposite one, or kNoHalfEdge.
  std::vector<HalfEdge> opposite;
  /// Half-edges (one of a pair) that have both ends in common with another pair: to be split, since
  /// their vertices alone do not tell them apart. Coarse triangles on two sides of a thin part
  /// have such.
  std::vector<HalfEdge> to_split;
};

/// Pairs half-edges and splits vertices so that every edge has at most two triangles, turned alike:
/// where more meet, those of one body (`face_body`, a number for each face) stay together, others
/// get vertices of their own. Both sides of what stays together agree on `border`. Cost: 40 ns a
/// triangle.
ManifoldPairs make_manifold(ChartMesh& mesh, const std::vector<std::int32_t>& face_body);

}  // namespace burin
