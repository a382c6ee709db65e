#pragma once
// One stroke on each point of a coverage, as in the paper.

#include "placing.h"

namespace burin::detail {

/// Independent points, as many a paper mm2 as the ink of each family asks for.
/// @cite Elber1998
Coverage cover_points(const Picture& picture, const ViewRaster& raster, const RunContext& context);

/// Poisson discs of the same density, by dart throwing. @cite Cook1986
Coverage cover_discs(const Picture& picture, const ViewRaster& raster, const RunContext& context);

/// The dot of each point: a stroke too short to be one, with round ends.
std::vector<Family> place_dots(const Picture& picture, const ViewRaster& raster,
                               const std::vector<Seed>& seeds, int families,
                               const RunContext& context,
                               const std::function<void(double)>& progress);

/// The stroke of each point, as long to both sides, a third more or less by chance.
std::vector<Family> place_on_points(const Picture& picture, const ViewRaster& raster,
                                    const std::vector<Seed>& seeds, int families,
                                    const RunContext& context,
                                    const std::function<void(double)>& progress);

Placing::Load dots_load(const Picture& picture, double ink);
Placing::Load points_load(const Picture& picture, double ink);

}  // namespace burin::detail
