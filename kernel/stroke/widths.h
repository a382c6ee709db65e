#pragma once
// The widths that make the strokes carry the tone.

#include "placement.h"

#include <vector>

namespace burin::detail {

/// Widths in paper mm for every sample of every stroke, `widths[family - 1][stroke][sample]`. First
/// guess: ink share times the measured distance to the neighbours; then corrected against the ink
/// of all strokes, blurred, on the raster.
using Widths = std::vector<std::vector<std::vector<double>>>;
Widths solve_widths(const Picture& picture, const ViewRaster& raster,
                    const std::vector<Family>& families, const RunContext& context);

}  // namespace burin::detail
