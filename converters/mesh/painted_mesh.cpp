#include "painted_mesh.h"

#include <burin/forms/mesh/mesh_form.h>
#include <burin/mesh/reorder.h>
#include <burin/repair/weld.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>

namespace burin {
namespace {

/// The polygons of a soup by their corners.
class PolygonsByCorner {
 public:
  PolygonsByCorner(const TriMesh& mesh, const PolygonSoup& soup, const RunContext& context)
      : soup_(soup), first_of_mesh_(soup.positions.size()) {
    std::vector<Vec3> points = soup.positions;
    points.insert(points.end(), mesh.positions.begin(), mesh.positions.end());
    Weld welded = weld(points, context);
    vertex_ = std::move(welded.vertex);
    first_.assign(welded.first.size() + 1, 0);
    for (const std::uint32_t i : soup.indices) ++first_[vertex_[i] + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    polygons_.resize(soup.indices.size());
    std::vector<std::size_t> next = first_;
    for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
      for (const std::uint32_t i : corners(p)) polygons_[next[vertex_[i]]++] = p;
    }
  }

  /// The first polygon that has all corners of a triangle of the mesh; -1: none has.
  std::ptrdiff_t of(const Triangle& triangle) const {
    const std::uint32_t a = at(triangle[0]), b = at(triangle[1]), c = at(triangle[2]);
    for (std::size_t i = first_[a]; i < first_[a + 1]; ++i) {
      if (holds(polygons_[i], b) && holds(polygons_[i], c)) {
        return static_cast<std::ptrdiff_t>(polygons_[i]);
      }
    }
    return -1;
  }

 private:
  std::span<const std::uint32_t> corners(std::size_t polygon) const {
    const std::size_t begin = soup_.offsets[polygon];
    return std::span(soup_.indices).subspan(begin, soup_.offsets[polygon + 1] - begin);
  }
  std::uint32_t at(std::uint32_t of_mesh) const { return vertex_[first_of_mesh_ + of_mesh]; }
  bool holds(std::size_t polygon, std::uint32_t vertex) const {
    return std::ranges::any_of(corners(polygon),
                               [&](std::uint32_t i) { return vertex_[i] == vertex; });
  }

  const PolygonSoup& soup_;
  std::size_t first_of_mesh_;
  std::vector<std::uint32_t> vertex_;
  /// For each vertex where its polygons begin in `polygons_`.
  std::vector<std::size_t> first_, polygons_;
};

}  // namespace

PaintedMesh paint_mesh(TriMesh& mesh, const PolygonSoup& before, const FaceColors& colors,
                       const RunContext& context) {
  reorder_for_cache(mesh);
  const PolygonsByCorner polygons(mesh, before, context);
  std::vector<std::int32_t> color;
  color.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    color.push_back(colors.at(static_cast<std::int32_t>(polygons.of(t))));
  }
  PaintedMesh out;
  const std::vector<std::int32_t> faces = number_faces(mesh, color, context);
  const auto count = static_cast<std::size_t>(*std::ranges::max_element(faces)) + 1;
  std::vector<std::string> color_of(count);
  std::vector<double> area(count, 0);
  for (std::uint32_t t = 0; t < faces.size(); ++t) {
    const auto f = static_cast<std::size_t>(faces[t]);
    if (color[t] >= 0) color_of[f] = colors.colors[static_cast<std::size_t>(color[t])];
    area[f] += mesh.area(t);
  }
  out.colors = painted_faces(color_of, area);
  if (out.colors.faces) out.faces = std::make_shared<const std::vector<std::int32_t>>(faces);
  return out;
}

}  // namespace burin
