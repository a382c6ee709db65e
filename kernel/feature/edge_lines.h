#pragma once
// Creases, contours on creases, and boundaries of one view.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/feature/feature.h>

#include "edge_chains.h"
#include "facing.h"

#include <span>
#include <vector>

namespace burin {

/// Cuts every chain where the facing of one of its sides changes and names the pieces.
std::vector<Curve3> edge_lines(const Facing& facing, std::span<const EdgeChain> chains,
                               std::int32_t part, const FeatureOptions& options,
                               const RunContext& context);

}  // namespace burin
