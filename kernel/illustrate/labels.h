#pragma once
// Which parts are seen where on the sheet; internal to the module.

#include <burin/annotate/label_map.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>

#include "occluders.h"

#include <optional>
#include <vector>

namespace burin::detail {

/// What can be looked through apart: what is seen first, then what is seen through that, and so on;
/// empty where nothing can.
struct Labels {
  LabelMap seen;
  std::vector<LabelMap> glass;
  /// What is seen of each part, within the drawn lines: of glass first, which lies over the rest.
  std::vector<Area> areas = {};
  /// Below all of them.
  std::optional<Area> shadow = {};
};

/// Of the stretch of the sheet that has ink. Cost: a ray a pixel and those of `partition`, and as
/// many more for each map of what can be looked through: as many as such parts hide each other
/// whole, one behind the other, 8 at the most. Throws Cancelled.
Labels label(const Drawing& drawing, const Occluders& occluders, const Camera& camera,
             const RunContext& context);

}  // namespace burin::detail
