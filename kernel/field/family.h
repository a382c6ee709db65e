#pragma once
/// Which arm of a cross belongs to family 1.

#include "constraints.h"

#include <vector>

namespace burin::field {

/// For each wedge the line of family 1 (a unit complex number, the direction to the second power):
/// one of the two lines of its cross, chosen so that neighbours agree wherever the field has no odd
/// singularity between them, and otherwise near the target.
std::vector<Vec2> choose_family(const ProxyMesh& proxy, const WedgeGraph& graph,
                                const std::vector<Vec2>& crosses, const LabelTargets& targets,
                                const RunContext& context);

}  // namespace burin::field
