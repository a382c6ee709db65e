#pragma once
// Walls over an outline that bends; internal to the module.

#include "facets.h"
#include "revolution.h"

#include <cstdint>
#include <vector>

namespace burin::recognised {

/// Smooth surfaces through the corners of walls, and for each facet its own or -1.
struct OutlineWalls {
  std::vector<Patch> patches;
  std::vector<std::int32_t> of;
};

/// What an outline that is no row of circles and lines leaves when it is extruded: four facets and
/// more that meet one another in edges of one direction at the angles of one smooth curve
/// (`smooth_grids`), and all else in sharp edges. Rims may be cut in any way. Cost: linear in the
/// number of links.
OutlineWalls find_outline_walls(const TriMesh& mesh, const Facets& facets,
                                const RunContext& context);

}  // namespace burin::recognised
