#pragma once
/// A ChartMesh from the triangulations that OCCT's mesher left on the faces.

#include <burin/forms/charted/raw_mesh.h>

#include "model_parts.h"

#include <cstddef>
#include <cstdint>

namespace burin {

constexpr std::uint32_t kNone = 0xffffffffu;
inline std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Corners at vertices and on edges are shared by the faces that meet there; triangles that shrink
/// to nothing (at poles) are left out. `unmeshed` gets the faces without triangles. Where more than
/// two faces share an edge, the result is not yet manifold (see make_manifold.h). Normals and
/// on_contour are zero.
RawMesh build_chart_mesh(const ModelParts& parts, std::vector<std::int32_t>& unmeshed);

}  // namespace burin
