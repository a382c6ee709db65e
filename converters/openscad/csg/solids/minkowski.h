#pragma once
// Minkowski sums; for csg/solids alone.

#include <burin/base/run_context.h>

#include "../solid.h"

#include <vector>

namespace burin::csg {

/// Convex solids whose union is the sum of two solids: of every pair of convex parts the hull of
/// the sums of their corners.
std::vector<Solid> minkowski_pieces(const Solid& a, const Solid& b, RunContext& context);

}  // namespace burin::csg
