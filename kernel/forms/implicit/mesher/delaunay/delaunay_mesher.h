#pragma once
// Graded triangles by Delaunay refinement.

#include "../mesher.h"

#include <optional>
#include <string>

namespace burin {

/// What refinement is going to do, from the coarse mesh of the survey; cheap.
struct DelaunayOutlook {
  double vertices = 0;  // that the tolerance needs, about
};
DelaunayOutlook delaunay_outlook(const Survey& survey, double tolerance, const RunContext& context);

/// Triangles whose size follows the curvature, creases protected, of at most `most_triangles`; what
/// of that is worth a word goes to `diagnostics`. nullopt, with a diagnostic, where no closed
/// surface of as many components as the survey's comes of it. Reports progress.
std::optional<ExactMesh> mesh_delaunay(const Survey& survey, double tolerance,
                                       std::size_t most_triangles, MeshCounts& counts,
                                       Diagnostics& diagnostics, RunContext& context);

}  // namespace burin
