#include "hull3.h"

#include <burin/base/disjoint_sets.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <map>
#include <set>

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

/// The corners and flat faces of a hull. Where more than three corners lie in a plane, or three on
/// a line, CGAL's choice of triangles goes by addresses in memory; these do not.
class FlatFaces {
 public:
  explicit FlatFaces(const Mesh& mesh) : mesh_(mesh), sets_(mesh.number_of_faces()) {
    for (const auto e : mesh_.edges()) {
      const auto h = mesh_.halfedge(e), o = mesh_.opposite(h);
      if (CGAL::coplanar(at(mesh_.source(h)), at(mesh_.target(h)), at(mesh_.target(mesh_.next(h))),
                         at(mesh_.target(mesh_.next(o))))) {
        sets_.join(mesh_.face(h), mesh_.face(o));
      }
    }
  }

  Solid solid() {
    Solid out;
    const std::vector<Vertex> corners = find_corners();
    for (const Vertex v : corners) out.positions.emplace_back(at(v).x(), at(v).y(), at(v).z());
    for (const Face& face : faces(corners)) {
      for (std::size_t k = 1; k + 1 < face.size(); ++k) {
        out.triangles.push_back({face[0], face[k], face[k + 1]});
        out.surface.push_back(-1);
      }
    }
    return out;
  }

 private:
  using Vertex = Mesh::Vertex_index;
  using Face = std::vector<std::uint32_t>;

  const Kernel::Point_3& at(Vertex v) const { return mesh_.point(v); }
  std::uint32_t plane(Mesh::Halfedge_index h) { return sets_.find(mesh_.face(h)); }

  /// Those at which three planes meet, in the order of their coordinates.
  std::vector<Vertex> find_corners() {
    std::vector<Vertex> out;
    for (const Vertex v : mesh_.vertices()) {
      std::set<std::uint32_t> planes;
      for (const auto h : mesh_.halfedges_around_target(mesh_.halfedge(v))) planes.insert(plane(h));
      if (planes.size() > 2) out.push_back(v);
    }
    std::ranges::sort(out, [&](Vertex v, Vertex w) { return at(v) < at(w); });
    return out;
  }

  /// Each begins at its first corner.
  std::vector<Face> faces(const std::vector<Vertex>& corners) {
    std::map<Vertex, std::uint32_t> number;
    for (const Vertex v : corners) number.emplace(v, static_cast<std::uint32_t>(number.size()));
    std::map<std::uint32_t, std::map<Vertex, Vertex>> borders;
    for (const auto h : mesh_.halfedges()) {
      if (plane(h) == plane(mesh_.opposite(h))) continue;
      borders[plane(h)].emplace(mesh_.source(h), mesh_.target(h));
    }
    std::vector<Face> out;
    for (const auto& [plane, next] : borders) {
      Face face;
      Vertex v = next.begin()->first;
      for (std::size_t i = 0; i < next.size(); ++i, v = next.at(v)) {
        if (const auto it = number.find(v); it != number.end()) face.push_back(it->second);
      }
      std::rotate(face.begin(), std::ranges::min_element(face), face.end());
      out.push_back(std::move(face));
    }
    std::ranges::sort(out);
    return out;
  }

  const Mesh& mesh_;
  DisjointSets sets_;
};

}  // namespace

Solid convex_hull(std::span<const Vec3> points) {
  std::vector<Kernel::Point_3> p;
  p.reserve(points.size());
  for (const Vec3& v : points) p.emplace_back(v.x, v.y, v.z);
  if (p.size() < 4 || in_a_plane(p)) return {};
  Mesh mesh;
  CGAL::convex_hull_3(p.begin(), p.end(), mesh);
  return FlatFaces(mesh).solid();
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
