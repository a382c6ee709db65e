#pragma once
// The lines of a motif on a surface; internal to the module.

#include "picture.h"
#include "tracer.h"

#include <vector>

namespace burin::detail {

/// The lines of a motif about a sample, `size` paper mm large where the surface is seen
/// square on: its x axis along the sample's tangent, turned to run to the right on paper, y to its
/// left for the viewer. Each point of the motif is the end of a straight march from the middle, as
/// long as it is far from it (the exponential map), so that the motif follows the surface and keeps
/// its size along it. A line ends where such a march meets a crease or border, where the surface
/// turns away and at the end of the sheet. `number` is that of the motif, for chance.
std::vector<TracedStroke> motif_strokes(const Picture& picture, const Motif& motif,
                                        std::int32_t part, int family, const StrokeSample& middle,
                                        double size, std::size_t number);

}  // namespace burin::detail
