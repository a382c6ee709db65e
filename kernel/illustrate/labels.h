#pragma once
// Which parts are seen where on the sheet; internal to the module.

#include <burin/annotate/label_map.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>

#include "occluders.h"

namespace burin::detail {

/// What can be looked through apart; empty where nothing can.
struct Labels {
  LabelMap seen, glass;
};

/// Of the stretch of the sheet that has ink. Cost: a ray a pixel, two where parts can be looked
/// through. Throws Cancelled.
Labels label(const Drawing& drawing, const Occluders& occluders, const Camera& camera,
             const RunContext& context);

}  // namespace burin::detail
