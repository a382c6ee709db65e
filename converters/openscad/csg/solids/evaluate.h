#pragma once
// What a tree comes to; for csg/solids alone.

#include "../flat/flat.h"

#include <functional>
#include <span>
#include <vector>

namespace burin::csg {

/// The solids that nodes stand for, each where its own arguments put it (matrices above it do not
/// count), nodes marked `%` below it left out. A node of two dimensions or of none gives an empty
/// solid. Subtrees of one text are worked out once. `share` is told what part is
/// done, one call at a time, while `e.doing` says what of. Throws
/// InputError for what a tree may not ask for, GeometryError where a cut fails.
std::vector<Solid> evaluate(Evaluation& e, std::span<const std::uint32_t> nodes,
                            const std::function<void(double)>& share);

}  // namespace burin::csg
