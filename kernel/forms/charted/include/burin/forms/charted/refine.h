#pragma once
/// Triangles split until they are near enough to the surface.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/forms/charted/raw_mesh.h>
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

struct RefineOptions {
  /// Model mm between S and the middle of every edge and triangle.
  double tolerance = 0.01;
  /// Deviations along a triangle (of edges of the model: along the edge) count so many times less.
  double along = 4;
  /// Triangles at the most: the edges that are farthest off are split first.
  std::size_t most = 1'000'000;
};

/// Splits edges, on both sides alike, until S is within the tolerance of every edge and of every
/// triangle's centre: in the middle, or (what some halvings did not bring near) where the edge
/// crosses a line at which S has no first derivative (Chart::breaks), so that edges come to lie
/// along it. New vertices lie on the
/// surface, those on model edges on the edge. Deterministic. Sets mesh.tolerance to what was
/// measured last, deviations along the triangles in full. Edges that `pairs` names are split in any
/// case. Returns false where `most` ended it. Cost: 1 us per triangle of the result.
bool refine(RawMesh& raw, ManifoldPairs pairs, const Atlas& atlas, const RefineOptions& options,
            const RunContext& context);

/// The most triangles that a part of this size (its diagonal) gets at a tolerance in model mm; more
/// would not be seen. At the usual tolerance, 0.05 mm of paper, these are 2,500 per cm2 of the
/// square over half the diagonal. Never over 600,000.
std::size_t triangle_bound(double size, double tolerance);

/// Says that `most` ended a refinement: surface.triangles_bounded.
void add_triangles_bounded(Diagnostics& diagnostics, std::size_t triangles, double distance,
                           double tolerance);

}  // namespace burin
