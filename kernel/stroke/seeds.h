#pragma once
// The coverage that the strokes start from: points uniform in the picture, thinned on paper,
// measured.

#include "picture.h"
#include "view_raster.h"

#include <vector>

namespace burin::detail {

struct Seed {
  std::int32_t part = -1;
  SurfacePoint point;
};

struct Coverage {
  std::vector<Seed> seeds;
  /// Paper mm: no seen place that wants ink is farther from its nearest seed than this (Definition
  /// 1 of the paper, measured at the cells of the raster).
  double delta = 0;
  /// Parts for which fewer candidates were tried than their area asks for.
  std::int64_t thinned_parts = 0;
};

Coverage cover_picture(const Picture& picture, const ViewRaster& raster, const RunContext& context);

}  // namespace burin::detail
