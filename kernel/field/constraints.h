#pragma once
/// What a smoothed field is asked to follow: curvature, creases, and the style's direction where
/// there is neither.

#include <burin/base/run_context.h>
#include <burin/field/field.h>

#include "flat_patches.h"
#include "wedge_graph.h"

#include <vector>

namespace burin::field {

/// For each wedge the line that family 1 should follow, as a direction to the second power in the
/// wedge's TangentBasis, times its weight.
struct LabelTargets {
  std::vector<Vec2> line;
  /// Length of `line` before any cancelling.
  std::vector<double> weight;
};

/// Sets mass and pull of `graph.crosses` and returns the targets of the labels.
LabelTargets set_constraints(const ProxyMesh& proxy, const std::vector<Frame>& frames,
                             const FlatPatches& flats, const SmoothedOptions& options,
                             WedgeGraph& graph, const RunContext& context);

}  // namespace burin::field
