#pragma once
// Components that an even grid misses, meshed in boxes of their own.

#include "hidden.h"
#include "mesher.h"

#include <vector>

namespace burin {

/// The places of a look's grid that belong together, as components in finer grids around them:
/// those that `survey.mesh` has not are added to it and to `survey.pieces`. False where some place
/// takes more than the budget.
bool add_hidden_pieces(Survey& survey, const std::vector<HiddenPlace>& places,
                       const GridLayout& layout, WorkBudget& budget, const RunContext& context);

/// The longest side of places that belong together and that the surface does not pass through, in
/// model mm: a singular place of it explains them.
double longest_unexplained(const Survey& survey, const std::vector<HiddenPlace>& places,
                           const GridLayout& layout);

/// Components of the first look that a mesh has lost, since they are smaller than its steps: each
/// is meshed in steps of its own and added. `tolerance`: model mm. False where that takes too much
/// work.
bool add_lost_pieces(ExactMesh& mesh, const Survey& survey, double tolerance,
                     const RunContext& context);

}  // namespace burin
