#pragma once
/// Colours of polygons, after repair.

#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/surface/face_colors.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace burin {

/// What a repaired mesh has of the colours that its polygons had.
struct PaintedMesh {
  /// As MeshForm takes them.
  std::shared_ptr<const std::vector<std::int32_t>> faces;
  PaintedFaces colors;
};

/// `colors`: by the polygons of `before`, of which `mesh` was made. Brings the triangles into the
/// order in which they are drawn. Polygons are found again by their corners, which repair leaves
/// where they are. Cost: that of `build_proxy`.
PaintedMesh paint_mesh(TriMesh& mesh, const PolygonSoup& before, const FaceColors& colors,
                       const RunContext& context);

}  // namespace burin
