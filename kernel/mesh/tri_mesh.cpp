#include <burin/mesh/tri_mesh.h>

namespace burin {

namespace {

/// Twice the area times the normal.
Vec3 double_area_vector(const TriMesh& mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  const Vec3& a = mesh.positions[t[0]];
  return glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
}

}  // namespace

Box3 TriMesh::bounds() const {
  Box3 box;
  for (const Vec3& p : positions) box.add(p);
  return box;
}

Vec3 TriMesh::normal(std::uint32_t triangle) const {
  return normalize_or(double_area_vector(*this, triangle), Vec3(0));
}

double TriMesh::area(std::uint32_t triangle) const {
  return 0.5 * glm::length(double_area_vector(*this, triangle));
}

}  // namespace burin
