#pragma once
/// The triangles of an atlas at their place.

#include <burin/forms/charted/atlas.h>

#include <span>
#include <vector>

namespace burin {

/// Reverses the triangles of the faces that are marked, with all that belongs to their corners and
/// half-edges; `corners` may hold one more thing for each corner.
void turn_triangles(ChartMesh& mesh, const std::vector<std::uint8_t>& face_marked,
                    std::span<std::uint8_t> corners = {});

/// Positions and normals (where there are any) where `placement` takes them, triangles turned
/// where it mirrors. `tolerance` grows by the most that any length does: it stays a bound.
ChartMesh placed(const ChartMesh& mesh, const Placement& placement);

}  // namespace burin
