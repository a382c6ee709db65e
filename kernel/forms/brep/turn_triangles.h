#pragma once
/// Triangles the other way round.

#include <burin/forms/charted/atlas.h>

#include <span>
#include <vector>

namespace burin {

/// Reverses the triangles of the faces that are marked, with all that belongs to their corners and
/// half-edges; `corners` may hold one more thing for each corner.
void turn_triangles(ChartMesh& mesh, const std::vector<std::uint8_t>& face_marked,
                    std::span<std::uint8_t> corners = {});

/// The volume that the triangles of each body enclose; 0 for bodies that are not closed, or whose
/// sign is unsure because their triangles are too coarse.
std::vector<double> body_volumes(const ChartMesh& mesh, const std::vector<std::int32_t>& face_body,
                                 std::size_t bodies);

}  // namespace burin
