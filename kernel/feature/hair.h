#pragma once
// Which creases are the noise of a scan.

#include "edge_chains.h"
#include "facing.h"

namespace burin {

/// Whether a chain of creases is hair: short, weak, and separating nothing (the same smooth region
/// on both its sides, or an island of a few triangles). Long or sharp creases never are.
bool is_hair(const Facing& facing, const EdgeChain& chain);

}  // namespace burin
