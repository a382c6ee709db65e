#pragma once
/// Triangles and polygons elsewhere.

#include <burin/base/placement.h>
#include <burin/mesh/tri_mesh.h>

namespace burin {

/// The same, every point where `by` takes it; where it mirrors, corners run the other way round, so
/// that they stay counter-clockwise.
TriMesh placed(TriMesh mesh, const Placement& by);
PolygonSoup placed(PolygonSoup soup, const Placement& by);

}  // namespace burin
