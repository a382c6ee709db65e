#pragma once
// Faces so narrow that lines across them would be a fringe.

#include "wave_graph.h"

#include <cstdint>
#include <set>
#include <utility>

namespace burin::detail {

/// Faces of the model by part and number; for a mesh its smooth regions.
using FaceSet = std::set<std::pair<std::int32_t, std::int32_t>>;

/// Those that are narrower along the lines of family 1 than the shortest stroke is long, at least
/// twice as long across them, and on which those lines do not go on beyond the face in ink. Of each
/// face 32 cells are asked.
FaceSet narrow_faces(const Picture& picture, const ViewRaster& raster, const WaveGraph& graph,
                     const RunContext& context);

/// A field whose families have changed names on these faces: lines run along them.
Field turned(const Picture& picture, FaceSet faces);

}  // namespace burin::detail
