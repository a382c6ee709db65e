#pragma once
// Components of a first look that a mesh has lost.

#include "mesher.h"

namespace burin {

/// Components of the first look that a mesh has lost, since they are smaller than its steps: each
/// is meshed in steps of its own and added. `tolerance`: model mm. False where one was not meshed:
/// it takes more than the budget, or is part of a wall as thin as a cell.
bool add_lost_pieces(ExactMesh& mesh, const Survey& survey, double tolerance, WorkBudget budget,
                     const RunContext& context);

}  // namespace burin
