#pragma once
/// Triangles the other way round.

#include <burin/forms/parametric/atlas.h>

#include <vector>

namespace burin {

/// Reverses the triangles of the faces that are marked, with all that belongs to their half-edges.
void turn_triangles(ChartMesh& mesh, const std::vector<std::uint8_t>& face_marked);

/// The volume that the triangles of each body enclose; 0 for bodies that are not closed.
std::vector<double> body_volumes(const ChartMesh& mesh, const std::vector<std::int32_t>& face_body,
                                 std::size_t bodies);

}  // namespace burin
