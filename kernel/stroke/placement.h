#pragma once
// Strokes at even distances: along the level lines of a phase.

#include "picture.h"
#include "sample_grid.h"
#include "tracer.h"
#include "view_raster.h"

#include <vector>

namespace burin::detail {

struct Family {
  std::vector<TracedStroke> strokes;
  SampleGrid grid;
};

/// The strokes of `families` families (1 or 2), one entry each: a phase is solved over all cells of
/// the picture for each family, then the lines of each smooth region are traced by themselves,
/// at the same time where cores are free. `progress` is called with the share that is done, from
/// the calling thread.
/// @cite Knoeppel2015
std::vector<Family> place_families(const Picture& picture, const ViewRaster& raster, int families,
                                   const RunContext& context,
                                   const std::function<void(double)>& progress);

}  // namespace burin::detail
