#pragma once
// Which parts are seen where on the sheet; internal to the module.

#include <burin/annotate/label_map.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>

#include "occluders.h"
#include "regions.h"

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

struct LabelRequest {
  /// Whether maps are wanted: `Labels::seen`, and `glass`.
  bool maps = true;
  /// What the areas of solid parts are parted by; absent: by the lines that are drawn, into parts.
  std::optional<RegionOptions> regions{};
  /// Of the view, for regions.
  SeenLines lines{};
};

/// Of the stretch of the sheet that has ink. Cost: a ray a pixel and those of `partition`, and as
/// many more for each map of what can be looked through: as many as such parts hide each other
/// whole, one behind the other, 8 at the most. Throws Cancelled.
Labels label(const Drawing& drawing, const Occluders& occluders, const Camera& camera,
             const LabelRequest& wanted, const RunContext& context);

}  // namespace burin::detail
