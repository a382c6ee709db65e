#pragma once
// Components that an even grid misses, found by what hides them.

#include "hidden.h"
#include "mesher.h"

#include <vector>

namespace burin {

/// The places of a look's grid that belong together, as components in finer grids around them:
/// those that `survey.mesh` has not are added to it and to `survey.pieces`, the least work first.
/// False where places that the mesh does not pass by take more than the budget.
bool add_hidden_pieces(Survey& survey, const std::vector<HiddenPlace>& places,
                       const GridLayout& layout, WorkBudget& budget, const RunContext& context);

/// The longest side in model mm of places that belong together and that the mesh does not explain:
/// those that no component of their length passes by, and those of which nothing could be told
/// where it does not pass.
double longest_missing(const Survey& survey, const HiddenPlaces& hidden, const GridLayout& layout);

}  // namespace burin
