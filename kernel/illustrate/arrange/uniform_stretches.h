#pragma once
// Stretches of a model over which its cross-section stays the same; internal to the module.

#include <burin/base/run_context.h>
#include <burin/base/vec.h>
#include <burin/surface/scene.h>

#include <vector>

namespace burin::detail {

/// Model mm along an axis.
struct UniformStretch {
  double low = 0, high = 0;
  /// Of what runs along it: the larger side of its box across the axis.
  double width = 0;
};

/// The stretches along `axis` (unit) in which no face of the parts turns towards the axis and no
/// edge ends or leaves its direction, ascending; none where there is nothing. `drawn`: one a part.
/// Cost: realising the parts, and a look at each triangle. Throws Cancelled.
std::vector<UniformStretch> uniform_stretches(const Scene& scene, const std::vector<bool>& drawn,
                                              const Vec3& axis, RunContext& context);

}  // namespace burin::detail
