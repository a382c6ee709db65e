#include "triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>

namespace burin::detail {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Face = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<std::int32_t, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

}  // namespace

SheetMesh triangulate_sheet(std::span<const Vec2> points,
                            std::span<const std::array<std::uint32_t, 2>> segments) {
  std::vector<Kernel::Point_2> at;
  at.reserve(points.size());
  for (const Vec2& p : points) at.emplace_back(p.x, p.y);
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  ends.reserve(segments.size());
  for (const auto& [a, b] : segments) ends.emplace_back(a, b);
  Triangulation mesh;
  mesh.insert_constraints(at.begin(), at.end(), ends.begin(), ends.end());

  SheetMesh out;
  for (const auto& v : mesh.finite_vertex_handles()) {
    v->info() = static_cast<std::uint32_t>(out.points.size());
    out.points.emplace_back(v->point().x(), v->point().y());
  }
  for (const auto& f : mesh.all_face_handles()) f->info() = -1;
  std::int32_t count = 0;
  for (const auto& f : mesh.finite_face_handles()) f->info() = count++;
  for (const auto& f : mesh.finite_face_handles()) {
    auto& corners = out.triangles.emplace_back();
    auto& beyond = out.beyond.emplace_back();
    auto& constrained = out.constrained.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      corners[k] = f->vertex(i)->info();
      beyond[k] = f->neighbor(i)->info();
      constrained[k] = f->is_constrained(i);
    }
  }
  return out;
}

}  // namespace burin::detail
