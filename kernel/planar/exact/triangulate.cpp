#include <burin/planar/even_odd.h>
#include <burin/planar/triangulate.h>

#include "constrained_delaunay.h"

#include <limits>
#include <map>
#include <utility>

namespace burin {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct VertexInfo {
  std::uint32_t index = kNone;
};
struct FaceInfo {
  bool known = false;
  int winding = 0;
};

using Triangulation = ConstrainedDelaunay<VertexInfo, FaceInfo>;
using Vertex = Triangulation::Vertex_handle;

/// How often the edges wind around `p`: those that cross the ray to the right, upwards 1,
/// downwards -1.
int winding(Vec2 p, std::span<const Vec2> points, std::span<const DirectedEdge> edges) {
  int count = 0;
  for (const auto& [from, to] : edges) {
    const Vec2 &a = points[from], &b = points[to];
    if (crosses_ray(a, b, p)) count += b.y > a.y ? 1 : -1;
  }
  return count;
}

class Labels {
 public:
  Labels(Triangulation& triangulation, std::span<const Vec2> points,
         std::span<const DirectedEdge> edges)
      : triangulation_(triangulation), points_(points), edges_(edges) {}

  /// By counting edges from the outside in, which is exact; where edges meet inside others, by the
  /// place of each face.
  void find(const std::vector<Vertex>& handles) {
    for (const auto& [from, to] : edges_) {
      const std::uint32_t a = handles[from]->info().index, b = handles[to]->info().index;
      if (a != b) ++net_[{a, b}], --net_[{b, a}];
    }
    if (count_inwards()) return;
    for (const auto face : triangulation_.all_face_handles()) face->info() = {};
    for (const auto face : triangulation_.finite_face_handles()) {
      if (!face->info().known) spread(face);
    }
  }

 private:
  using Face = Triangulation::Face_handle;

  /// False where an edge of the triangulation is only a part of one that was given.
  bool count_inwards() {
    const Face outside = triangulation_.infinite_face();
    outside->info() = {true, 0};
    std::vector<Face> faces{outside};
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const Face next = faces[i]->neighbor(k);
        if (next->info().known) continue;
        int winding = faces[i]->info().winding;
        if (faces[i]->is_constrained(k)) {
          // The next face lies to the left of its own edge.
          const int j = next->index(faces[i]);
          const auto net = net_.find(
              {next->vertex(next->ccw(j))->info().index, next->vertex(next->cw(j))->info().index});
          if (net == net_.end()) return false;
          winding += net->second;
        }
        next->info() = {true, winding};
        faces.push_back(next);
      }
    }
    return true;
  }

  /// All faces up to the next edges are as its largest one, in the middle of which rounding says
  /// nothing.
  void spread(Face start) {
    std::vector<Face> faces{start};
    start->info().known = true;
    double largest = -1;
    Vec2 middle(0);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Face face = faces[i];
      const double area = triangulation_.triangle(face).area();
      if (area > largest) {
        largest = area;
        const auto c = CGAL::centroid(triangulation_.triangle(face));
        middle = {c.x(), c.y()};
      }
      for (int k = 0; k < 3; ++k) {
        const Face next = face->neighbor(k);
        if (face->is_constrained(k) || triangulation_.is_infinite(next)) continue;
        if (next->info().known) continue;
        next->info().known = true;
        faces.push_back(next);
      }
    }
    const int around = winding(middle, points_, edges_);
    for (const Face face : faces) face->info().winding = around;
  }

  Triangulation& triangulation_;
  std::span<const Vec2> points_;
  std::span<const DirectedEdge> edges_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> net_;  // edges from one to the other
};

}  // namespace

Triangulated triangulate(std::span<const Vec2> points, std::span<const DirectedEdge> edges) {
  Triangulation triangulation;
  std::vector<Vertex> handles;
  handles.reserve(points.size());
  Triangulation::Face_handle near;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto vertex = triangulation.insert({points[i].x, points[i].y}, near);
    if (vertex->info().index == kNone) vertex->info().index = i;
    near = vertex->face();
    handles.push_back(vertex);
  }
  for (const auto& [from, to] : edges) {
    if (handles[from] != handles[to]) triangulation.insert_constraint(handles[from], handles[to]);
  }
  Triangulated out;
  if (triangulation.dimension() < 2) return out;
  Labels(triangulation, points, edges).find(handles);
  for (const auto vertex : triangulation.finite_vertex_handles()) {
    if (vertex->info().index != kNone) continue;
    vertex->info().index = static_cast<std::uint32_t>(points.size() + out.added.size());
    out.added.emplace_back(vertex->point().x(), vertex->point().y());
  }
  for (const auto face : triangulation.finite_face_handles()) {
    if (face->info().winding <= 0) continue;
    out.triangles.push_back({face->vertex(0)->info().index, face->vertex(1)->info().index,
                             face->vertex(2)->info().index});
  }
  return out;
}

}  // namespace burin
