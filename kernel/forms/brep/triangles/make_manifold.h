#pragma once
/// Triangles of a shape whose edges may have three faces, made manifold.

#include <burin/forms/charted/refine.h>

#include <vector>

namespace burin {

/// Pairs half-edges and splits vertices so that every edge has at most two triangles, turned alike,
/// and every vertex one fan (sheets that touch at a point alone are parted there): where more meet
/// at an edge, those of one body (`face_body`, a number for each face) stay together, others
/// get vertices of their own. Both sides of what stays together agree on `border`. Cost: 40 ns a
/// triangle.
ManifoldPairs make_manifold(ChartMesh& mesh, const std::vector<std::int32_t>& face_body);

}  // namespace burin
