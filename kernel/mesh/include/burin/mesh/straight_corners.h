#pragma once
/// Corners that stand in the middle of straight edges.

#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

struct StraightCornerOptions {
  /// Degrees: what bends by more is not round.
  double crease_angle = 30;
  /// Of the largest coordinate: how far corners, and the lines beside them, may be off. A text file
  /// of six digits moves both by half a unit of its last one.
  double digits = 1e-5;
};

/// Takes away corners in the middle of a straight edge between two flat faces, where what is round
/// at the ends of that edge would bulge beyond it: a program that cut facets left them there, and
/// they are off the round surface that the other corners lie on. The shape stays as it is, within
/// the digits. `of`, where given, has a number for each triangle, which it keeps. Returns how many
/// were taken away; other corners and triangles keep their order. Cost: a pass over the corners.
std::size_t remove_straight_corners(TriMesh& mesh, const StraightCornerOptions& options,
                                    const RunContext& context,
                                    std::vector<std::int32_t>* of = nullptr);

}  // namespace burin
