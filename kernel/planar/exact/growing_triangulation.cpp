#include <burin/planar/growing_triangulation.h>

#include "constrained_delaunay.h"

#include <algorithm>
#include <utility>

namespace burin {
namespace {

/// A place in the mesh that was taken last; -1: not there yet.
struct Number {
  std::int32_t value = -1;
};

using Triangulation = ConstrainedDelaunay<Number, Number>;
using Corners = std::array<std::uint32_t, 3>;

/// With the least first.
Corners turned(Corners c) {
  std::rotate(c.begin(), std::ranges::min_element(c), c.end());
  return c;
}

}  // namespace

struct GrowingTriangulation::Impl {
  Triangulation mesh;
  /// What the numbers in `mesh` say.
  std::int32_t points = 0;
  std::vector<Corners> triangles;

  /// The number of a triangle that has still the corners which it had: faces are also turned over.
  std::int32_t same(const Triangulation::Face_handle& f, const Corners& corners) const {
    const std::int32_t number = f->info().value;
    if (number < 0 || static_cast<std::size_t>(number) >= triangles.size()) return -1;
    return turned(triangles[static_cast<std::size_t>(number)]) == turned(corners) ? number : -1;
  }
};

GrowingTriangulation::GrowingTriangulation() : impl_(std::make_unique<Impl>()) {}
GrowingTriangulation::~GrowingTriangulation() = default;

void GrowingTriangulation::add(std::span<const Vec2> points,
                               std::span<const std::array<std::uint32_t, 2>> segments) {
  std::vector<Triangulation::Point> at;
  at.reserve(points.size());
  for (const Vec2& p : points) at.emplace_back(p.x, p.y);
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  ends.reserve(segments.size());
  for (const auto& [a, b] : segments) ends.emplace_back(a, b);
  impl_->mesh.insert_constraints(at.begin(), at.end(), ends.begin(), ends.end());
}

PlanarMesh GrowingTriangulation::mesh() {
  Triangulation& mesh = impl_->mesh;
  PlanarMesh out;
  for (const auto& v : mesh.finite_vertex_handles()) {
    if (v->info().value < 0) v->info().value = impl_->points++;
  }
  out.points.resize(static_cast<std::size_t>(impl_->points));
  for (const auto& v : mesh.finite_vertex_handles()) {
    out.points[static_cast<std::size_t>(v->info().value)] = {v->point().x(), v->point().y()};
  }
  const std::size_t count = mesh.number_of_faces();
  out.triangles.reserve(count);
  out.before.reserve(count);
  out.beyond.reserve(count);
  out.constrained.reserve(count);
  for (const auto& f : mesh.all_face_handles()) {
    if (mesh.is_infinite(f)) {
      f->info().value = -1;
      continue;
    }
    Corners corners;
    for (int i = 0; i < 3; ++i) {
      corners[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(f->vertex(i)->info().value);
    }
    out.before.push_back(impl_->same(f, corners));
    f->info().value = static_cast<std::int32_t>(out.triangles.size());
    out.triangles.push_back(corners);
  }
  for (const auto& f : mesh.finite_face_handles()) {
    auto& beyond = out.beyond.emplace_back();
    auto& constrained = out.constrained.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      beyond[k] = f->neighbor(i)->info().value;
      constrained[k] = f->is_constrained(i);
    }
  }
  impl_->triangles = out.triangles;
  return out;
}

}  // namespace burin
