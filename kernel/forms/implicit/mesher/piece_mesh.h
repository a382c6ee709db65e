#pragma once
// Meshes of pieces of a surface, in grids of their own.

#include "mesher.h"

#include <optional>
#include <vector>

namespace burin {

/// Steps from a point of the surface to the nearest vertex of a mesh that has it there.
constexpr double kNear = 0.8;
/// Steps across the smaller pieces, at least.
constexpr double kStepsAcross = 10;

/// The closed components of a surface that lie wholly in a box, in triangles of about `step` model
/// mm. Throws TooMuchWork where the budget does not hold them.
std::vector<ExactMesh> components_in(const Survey& survey, const Box3& box, double step,
                                     WorkBudget& budget, const RunContext& context);

/// One piece in triangles of about `step`: what lies in its box and comes nearest to its point.
/// Nothing where it leaves the box, grown some times as far as a share of the budget goes.
std::optional<ExactMesh> mesh_piece(const Survey& survey, const Component& piece, double step,
                                    WorkBudget& budget, const RunContext& context);

/// Adds a part to a mesh, whose steps then differ from place to place.
void append(ExactMesh& mesh, const ExactMesh& part);

}  // namespace burin
