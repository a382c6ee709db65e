#pragma once

#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>

#include <cstdint>

namespace burin {

/// Pairs of triangles that meet elsewhere than at the corners and edges they share, decided exactly
/// by position (so parts of a surface that repair took apart and that only touch count too where
/// they cross). @cite CGAL
std::int64_t count_self_intersections(const TriMesh& mesh, const RunContext& context);

}  // namespace burin
