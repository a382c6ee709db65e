#pragma once
// Stretches of a line where a part has it; internal to the module.

#include <burin/base/curve.h>

#include "own_rays.h"

#include <functional>
#include <optional>
#include <vector>

namespace burin::detail {

/// Adds a line for each stretch between two parameters where `at` knows a place. Ends between two
/// of the `pieces` are halved down to rounding; stretches shorter than a piece may be missed.
/// Places without a triangle lie within a part: lines of those are hidden all along. `closes`: one
/// that is whole is closed. `like`: its kind and source.
void add_runs(double from, double to, int pieces,
              const std::function<std::optional<OwnPlace>(double)>& at, const Curve3& like,
              std::vector<Curve3>& out, bool closes = false);

}  // namespace burin::detail
