#pragma once
/// From a polygon soup to a clean, oriented, manifold triangle mesh (CGAL polygon mesh processing
/// behind it).

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>

namespace burin {

struct RepairOptions {
  /// Join points with the same coordinates (exactly equal doubles).
  bool merge_duplicate_points = true;
};

/// Triangulates polygons, drops what no drawing can use (corners with NaN or infinite coordinates,
/// repeated corners, zero-area and duplicate faces), orients neighbouring faces alike and closed
/// components outwards, and splits vertices at non-manifold edges and vertices. Clean input passes
/// through a linear test and is not touched, the order of its faces and vertices kept. Each kind of
/// defect becomes one entry of `diagnostics` (codes "mesh.*"), with its count and what was done.
/// Throws GeometryError where no triangle is left. Cost: about 0.1 s for a clean million triangles;
/// 2 s for a broken one. @cite CGAL
TriMesh repair(PolygonSoup soup, const RepairOptions& options, Diagnostics& diagnostics,
               const RunContext& context);

}  // namespace burin
