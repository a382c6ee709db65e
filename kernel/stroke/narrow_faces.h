#pragma once
// Faces that are so narrow, or have ink in so narrow a strip, that lines across it would be a
// fringe.

#include "wave_graph.h"

#include <cstdint>
#include <set>
#include <utility>

namespace burin::detail {

/// Faces of the model by part and number; for a mesh its smooth regions.
using FaceSet = std::set<std::pair<std::int32_t, std::int32_t>>;

/// Those on which the ink, and what goes on from it beyond the face, is narrower along the lines of
/// family 1 than the shortest stroke is long, and at least twice as long across them. Of each face
/// 32 cells are asked.
FaceSet narrow_faces(const Picture& picture, const ViewRaster& raster, const WaveGraph& graph,
                     const RunContext& context);

/// A field whose families have changed names on these faces: lines run along them.
Field turned(const Picture& picture, FaceSet faces);

}  // namespace burin::detail
