#pragma once
// Level lines that run along a border of their surface.

#include "level_lines.h"
#include "view_raster.h"

#include <vector>

namespace burin::detail {

/// The border of a region is a stair of cells: a line that runs along it within a cell comes as a
/// piece for each step of the stair, and each piece would be a dash. Joins those of one number that
/// go on into one another over a missing stretch beside the border. Cost: a sort of the ends.
void join_along_borders(const ViewRaster& raster, const WaveGraph& graph,
                        std::vector<LevelLine>& lines, const RunContext& context);

}  // namespace burin::detail
