#pragma once
// Width, depth and height of what a sheet shows; internal to the module.

#include <burin/annotate/dimensions.h>
#include <burin/arrange/illustration.h>
#include <burin/base/box.h>
#include <burin/surface/scene.h>

#include "sheet_dimensions.h"

#include <array>
#include <span>
#include <vector>

namespace burin::detail {

/// Of width, depth and height.
using OverallShares = std::array<bool, 3>;

/// Gives each of the three to the first view of the lowest rank that shows it square to the sheet,
/// else to the first that shows it at all; one a view. Tells of those that no view shows, and of
/// those that cuts or parts that came apart have made another one. `drawn`: what is drawn.
std::vector<OverallShares> share_overall(Scene& scene, const Illustration& illustration,
                                         const Box3& drawn, std::span<const SheetView> views);

/// Those of a view.
std::vector<Dimension> overall_of_view(const Box3& drawn, const Mat3& axes,
                                       const OverallShares& shares, const DimensionOptions& style);

}  // namespace burin::detail
