#pragma once
// How dense lines run: as the pen wants them, but for what would force lines to begin or end.

#include "wave_graph.h"

namespace burin::detail {

/// Scales the waves of a graph until they are nearly the gradient of a phase: along a line they may
/// grow or shrink as its neighbours converge or part, within bounds, over some `length` paper mm,
/// `ruled` times that on faces of which everybody knows how lines run. `spacing` is the style's, in
/// paper mm. Cost: some 300 passes over a quarter of the nodes.
/// @cite Ray2006
void make_integrable(const ViewRaster& raster, WaveGraph& graph, double spacing, double length,
                     double ruled, const RunContext& context);

}  // namespace burin::detail
