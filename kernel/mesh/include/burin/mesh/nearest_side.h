#pragma once
/// Points beside a triangle.

#include <burin/mesh/tri_mesh.h>

namespace burin {

/// Barycentric coordinates of the place on the sides of a triangle that is nearest to p.
Vec3 nearest_side(const TriMesh& mesh, std::uint32_t triangle, Vec3 p);

}  // namespace burin
