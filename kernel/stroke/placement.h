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

/// @cite Jobard1997
Family place_family(const Picture& picture, const ViewRaster& raster,
                    const std::vector<Seed>& seeds, int family, const RunContext& context,
                    const std::function<void(double)>& progress);

}  // namespace burin::detail
