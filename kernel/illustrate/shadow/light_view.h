#pragma once
// A scene as the light sees it; internal to the module.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>

#include "occluders.h"

#include <optional>
#include <vector>

namespace burin::detail {

struct LightView {
  /// Looks from the light, which is far away, at all solid parts.
  Camera camera;
  /// Curves that the outlines of solid parts are made of, hidden ones too.
  std::vector<Curve3> outlines;
};

/// `light_direction`: from the model to the light, of any length. Nothing where no part is solid.
/// Throws Cancelled. Cost: that of the feature lines of a view.
std::optional<LightView> light_view(const Occluders& occluders, Vec3 light_direction,
                                    const RunContext& context);

}  // namespace burin::detail
