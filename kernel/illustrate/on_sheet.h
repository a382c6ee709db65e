#pragma once
// The drawing and the sheet that it stands on; internal to the module.

#include <burin/drawing/drawing.h>

#include "part_styles.h"

namespace burin::detail {

/// Cuts what runs off the sheet at its edge (with `clip`), and tells of a drawing that is empty,
/// off the sheet, cut, or no larger than a dot.
void settle_on_sheet(const PartStyles& part_styles, bool clip, Drawing& drawing);

/// Cuts an area at the edge of the sheet of a drawing; it may have no ring left.
void cut_at_sheet(Area& area, const Drawing& drawing);

}  // namespace burin::detail
