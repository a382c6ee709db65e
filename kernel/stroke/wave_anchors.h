#pragma once
// Lines along an edge begin half a gap from it.

#include "wave_phase.h"

namespace burin::detail {

/// What the phase is to be at the nodes beside creases and boundaries that run along the lines.
/// Cost: a few rays for each such node.
std::vector<WaveAnchor> wave_anchors(const Picture& picture, const ViewRaster& raster,
                                     const WaveGraph& graph, int family, const RunContext& context);

}  // namespace burin::detail
