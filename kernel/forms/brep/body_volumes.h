#pragma once
/// What the triangles of bodies enclose.

#include <burin/forms/charted/atlas.h>

#include <vector>

namespace burin {

/// The volume that the triangles of each body enclose; 0 for bodies that are not closed, or whose
/// sign is unsure because their triangles are too coarse.
std::vector<double> body_volumes(const ChartMesh& mesh, const std::vector<std::int32_t>& face_body,
                                 std::size_t bodies);

}  // namespace burin
