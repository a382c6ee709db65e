#pragma once
// The shadow of a scene on an invisible ground under it; internal to the module.

#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>

#include "light_view.h"
#include "occluders.h"

#include <optional>

namespace burin::detail {

/// The area that solid parts darken on the plane through their lowest point, square to z; nothing
/// where light or viewer are not well above that plane. It lies below all parts. Its border is the
/// outline that the light sees, thrown along the light. Throws Cancelled. Cost: that of the
/// partition of the light's view.
std::optional<Area> ground_shadow(const Occluders& occluders, const LightView& light,
                                  const Camera& camera, const RunContext& context);

}  // namespace burin::detail
