#pragma once
// Lines at whole steps of what a field keeps, as contour lines of a map; internal to the module.

#include "wave_phase.h"

#include <numbers>

namespace burin::detail {

constexpr double kTurn = 2 * std::numbers::pi;

/// The step between lines: that of the options, or, where it is 0, of 1, 2 or 5 times a power of
/// ten the one at which lines are on average about `spacing_min` apart on paper. Throws UsageError
/// where lines would be less than 0.05 mm apart on average; 0 where no level is seen.
double level_step(const Picture& picture, const ViewRaster& raster, const RunContext& context);

/// The phase that makes a turn a step of the picture: its lines are those levels. Gives the graph
/// the waves of that phase.
WavePhase level_phase(const Picture& picture, const ViewRaster& raster, WaveGraph& graph,
                      const RunContext& context);

}  // namespace burin::detail
