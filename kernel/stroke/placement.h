#pragma once
// Evenly spaced strokes of one family: from the coverage, then beside each stroke that was placed.

#include "picture.h"
#include "sample_grid.h"
#include "seeds.h"
#include "tracer.h"
#include "view_raster.h"

#include <vector>

namespace burin::detail {

struct Family {
  std::vector<TracedStroke> strokes;
  SampleGrid grid;
};

/// The strokes of `families` families (1 or 2), one entry each. Strokes of different parts or
/// smooth regions never meet (see same_sheet), nor do those of different families: each region of
/// each family is placed by itself, at the same time where cores are free, in the order of its
/// seeds. `progress` is called with the share of the seeds that is done, from the calling thread.
/// @cite Jobard1997
std::vector<Family> place_families(const Picture& picture, const ViewRaster& raster,
                                   const std::vector<Seed>& seeds, int families,
                                   const RunContext& context,
                                   const std::function<void(double)>& progress);

}  // namespace burin::detail
