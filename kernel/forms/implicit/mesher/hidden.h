#pragma once
// Places that the samples of a grid do not show.

#include <burin/base/run_context.h>
#include <burin/forms/implicit/implicit_function.h>

#include "grid.h"

#include <vector>

namespace burin {

/// A cube in which the function has a sign that no corner of its cell of the grid has, as far as a
/// straight way there tells.
struct HiddenPlace {
  Cell cell{0};  // of the grid
  Box3 box;
};

struct HiddenPlaces {
  std::vector<HiddenPlace> places;
  /// Cubes of which nothing could be told: of the finest size, or where the budget ends.
  std::vector<HiddenPlace> doubtful;
  /// Whether all was searched; false where cubes larger than a cell, too many to name, were left
  /// out: those that the surface passes through if that does, else all of one size.
  bool whole = true;
};

/// Searches all cells of a grid within a box for them, down to a 32nd of a step. A component of
/// the surface that no sample hits has a place inside where the function is lowest (or, of a
/// hollow, highest): cubes where intervals prove that f is not zero, or that it never falls
/// in some direction, hold none; others are divided.
/// The work is counted, and ends within the budget: what is left then is not searched, cubes with
/// vertices of the `surface` that is known first.
HiddenPlaces find_hidden(const ImplicitFunction& f, const GridLayout& layout, const Box3& within,
                         const std::vector<Vec3>& surface, WorkBudget budget,
                         const RunContext& context);

}  // namespace burin
