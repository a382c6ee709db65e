// Planar faces with holes by CGAL's constrained Delaunay triangulation: the one unit here that sees
// CGAL.
#include <burin/base/error.h>

#include "kit.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <deque>

namespace burin::samples {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_tag>;

// How many constraints lie between a face and the outside.
void mark_nesting(Cdt& cdt) {
  for (auto f = cdt.all_faces_begin(); f != cdt.all_faces_end(); ++f) f->info() = -1;
  std::deque<std::pair<Cdt::Face_handle, int>> queue{{cdt.infinite_face(), 0}};
  while (!queue.empty()) {
    const auto [face, depth] = queue.front();
    queue.pop_front();
    if (face->info() >= 0) continue;
    face->info() = depth;
    for (int i = 0; i < 3; ++i) {
      const auto next = face->neighbor(i);
      if (next->info() >= 0) continue;
      if (cdt.is_constrained({face, i})) {
        queue.emplace_back(next, depth + 1);
      } else {
        queue.emplace_front(next, depth);
      }
    }
  }
}

Vec3 newell_normal(const Loop& loop) {
  Vec3 sum(0);
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += glm::cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  return glm::normalize(sum);
}

}  // namespace

void Builder::plane(const Loop& outer, const std::vector<Loop>& holes) {
  const Vec3 normal = newell_normal(outer), u = any_orthogonal(normal), v = glm::cross(normal, u);
  std::vector<Vec3> points;
  Cdt cdt;
  const auto insert = [&](const Loop& loop) {
    std::vector<Cdt::Vertex_handle> handles;
    for (const Vec3& p : loop) {
      handles.push_back(cdt.insert({glm::dot(p, u), glm::dot(p, v)}));
      handles.back()->info() = points.size();
      points.push_back(p);
    }
    for (std::size_t i = 0; i < handles.size(); ++i) {
      cdt.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
    }
  };
  insert(outer);
  for (const Loop& hole : holes) insert(hole);
  mark_nesting(cdt);
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    if (f->info() % 2 == 0) continue;
    triangle(points[f->vertex(0)->info()], points[f->vertex(1)->info()],
             points[f->vertex(2)->info()]);
  }
}

}  // namespace burin::samples
