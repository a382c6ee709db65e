#pragma once
// Rows of points in polyhedra, as loops in programs write them; for converters/openscad alone.

#include <burin/base/run_context.h>

#include "../solid.h"

#include <cstdint>
#include <vector>

namespace burin::csg {

/// The corners of each face.
using Faces = std::vector<std::vector<std::uint32_t>>;

struct FaceSurfaces {
  std::vector<Turned> surfaces;
  /// For each face its surface, or kMeantFlat.
  std::vector<std::int32_t> of;
};

/// Smooth surfaces among the faces of a polyhedron whose points stand row by row in its list, every
/// row of as many, with quadrangles (or pairs of triangles) between neighbouring rows: what sweeps,
/// skins and twists make. Cost: that of sorting the faces, once for each width of row, up to eight.
FaceSurfaces surfaces_by_rows(const std::vector<Vec3>& points, const Faces& faces, RunContext& run);

}  // namespace burin::csg
