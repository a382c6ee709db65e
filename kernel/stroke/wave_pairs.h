#pragma once
// Ends of lines that need not be.

#include "wave_phase.h"

#include <vector>

namespace burin::detail {

/// Takes pairs of opposite dislocations out of a phase, of which one line ends where another begins
/// not far off, and single ones right beside a border; then evens out by least squares how lines
/// share the space. Those stay that the field asks for. Cost: a search of some thousand triangles
/// for each dislocation, 120 passes over the links at most.
void cancel_pairs(const ViewRaster& raster, const WaveGraph& graph,
                  const std::vector<WaveAnchor>& anchors, WavePhase& phase,
                  const RunContext& context);

}  // namespace burin::detail
