#include "hull3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

namespace burin::csg {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

bool in_a_plane(std::span<const Kernel::Point_3> p) {
  std::size_t b = 1;
  while (b < p.size() && p[b] == p[0]) ++b;
  std::size_t c = b;
  while (c < p.size() && CGAL::collinear(p[0], p[b], p[c])) ++c;
  for (std::size_t d = c; d < p.size(); ++d) {
    if (!CGAL::coplanar(p[0], p[b], p[c], p[d])) return false;
  }
  return true;
}

}  // namespace

Solid convex_hull(std::span<const Vec3> points) {
  std::vector<Kernel::Point_3> p;
  p.reserve(points.size());
  for (const Vec3& v : points) p.emplace_back(v.x, v.y, v.z);
  if (p.size() < 4 || in_a_plane(p)) return {};
  Mesh mesh;
  CGAL::convex_hull_3(p.begin(), p.end(), mesh);
  Solid out;
  for (const auto v : mesh.vertices()) {
    const auto& q = mesh.point(v);
    out.positions.emplace_back(q.x(), q.y(), q.z());
  }
  for (const auto f : mesh.faces()) {
    std::vector<std::uint32_t> c;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) c.push_back(v);
    for (std::size_t k = 1; k + 1 < c.size(); ++k) {
      out.triangles.push_back({c[0], c[k], c[k + 1]});
      out.surface.push_back(-1);
    }
  }
  return out;
}

bool convex(const Solid& solid) {
  // Corners a rounding outside of a face do not count: hulls are made of them all the same.
  double size = 0;
  for (const Vec3& p : solid.positions) size = std::max(size, glm::length(p - solid.positions[0]));
  for (const auto& t : solid.triangles) {
    const Vec3 a = solid.positions[t[0]];
    const Vec3 n = glm::cross(solid.positions[t[1]] - a, solid.positions[t[2]] - a);
    const double limit = 1e-10 * size * glm::length(n);
    for (const Vec3& p : solid.positions) {
      if (glm::dot(n, p - a) > limit) return false;
    }
  }
  return true;
}

}  // namespace burin::csg
