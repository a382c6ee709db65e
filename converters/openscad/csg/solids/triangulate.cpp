#include "triangulate.h"

#include <burin/base/error.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <optional>

namespace burin::csg {
namespace {

using Rounded = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Decides with the space's own predicates: doubles where their bounds allow, else whole numbers.
class Exactly : public Rounded {
 public:
  // NOLINTBEGIN(readability-identifier-naming): CGAL's names
  struct Point_2 : Rounded::Point_2 {
    Point_2() = default;
    Point_2(Rounded::Point_2 rounded, Id point) : Rounded::Point_2(rounded), id(point) {}
    Id id = kNone;
    bool operator==(const Point_2& other) const { return id == other.id; }
    bool operator!=(const Point_2& other) const { return id != other.id; }
  };
  struct Place {
    Space* space = nullptr;
    Id plane = kNone;
    int axis(int k) const { return (space->main_axis(plane) + 1 + k) % 3; }
    int compare(int k, const Point_2& p, const Point_2& q) const {
      return space->compare(axis(k), p.id, q.id);
    }
  };
  template <int Axis>
  struct Less : Place {
    bool operator()(const Point_2& p, const Point_2& q) const { return compare(Axis, p, q) < 0; }
  };
  template <int Axis>
  struct Compare : Place {
    CGAL::Comparison_result operator()(const Point_2& p, const Point_2& q) const {
      return CGAL::enum_cast<CGAL::Comparison_result>(CGAL::sign(compare(Axis, p, q)));
    }
  };
  struct Orientation_2 : Place {
    CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const {
      return CGAL::enum_cast<CGAL::Orientation>(CGAL::sign(space->turn(plane, p.id, q.id, r.id)));
    }
  };
  struct Side_of_oriented_circle_2 : Place {
    CGAL::Oriented_side operator()(const Point_2& p, const Point_2& q, const Point_2& r,
                                   const Point_2& t) const {
      return CGAL::enum_cast<CGAL::Oriented_side>(
          CGAL::sign(space->in_circle(plane, {p.id, q.id, r.id}, t.id)));
    }
  };
  struct Construct_point_2 {
    const Point_2& operator()(const Point_2& p) const { return p; }
  };
  using Less_x_2 = Less<0>;
  using Less_y_2 = Less<1>;
  using Compare_x_2 = Compare<0>;
  using Compare_y_2 = Compare<1>;
  // NOLINTEND(readability-identifier-naming)

  Exactly(Space& space, Id plane) : place_{&space, plane} {}
  Construct_point_2 construct_point_2_object() const { return {}; }
  Less_x_2 less_x_2_object() const { return {place_}; }
  Less_y_2 less_y_2_object() const { return {place_}; }
  Compare_x_2 compare_x_2_object() const { return {place_}; }
  Compare_y_2 compare_y_2_object() const { return {place_}; }
  Orientation_2 orientation_2_object() const { return {place_}; }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {place_}; }

 private:
  Place place_;
};

template <typename K>
struct Kinds {
  using Corner = CGAL::Triangulation_vertex_base_with_info_2<Id, K>;
  using Face =
      CGAL::Constrained_triangulation_face_base_2<K,
                                                  CGAL::Triangulation_face_base_with_info_2<Id, K>>;
  using Data = CGAL::Triangulation_data_structure_2<Corner, Face>;
  // Rounding can make edges cross: it is then done again with exact numbers.
  using Type = CGAL::Constrained_Delaunay_triangulation_2<
      K, Data, CGAL::No_constraint_intersection_requiring_constructions_tag>;
};

Rounded::Point_2 place(const Rounded&, Space& space, Id point, int i, int j) {
  const Vec3 p = space.at(point);
  return {p[i], p[j]};
}
Exactly::Point_2 place(const Exactly& kernel, Space& space, Id point, int i, int j) {
  return {place(static_cast<const Rounded&>(kernel), space, point, i, j), point};
}

template <typename K>
std::optional<Triangulation> attempt(const K& kernel, Space& space, Id plane,
                                     std::span<const std::array<Id, 2>> edges) {
  using Cdt = typename Kinds<K>::Type;
  Cdt cdt(kernel);
  const int axis = space.main_axis(plane), i = (axis + 1) % 3, j = (axis + 2) % 3;
  std::vector<Id> ids;
  for (const auto& e : edges) ids.insert(ids.end(), e.begin(), e.end());
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<std::pair<typename K::Point_2, Id>> points;
  points.reserve(ids.size());
  for (const Id id : ids) points.emplace_back(place(kernel, space, id, i, j), id);
  cdt.insert(points.begin(), points.end());
  if (cdt.number_of_vertices() != ids.size()) return std::nullopt;
  std::vector<typename Cdt::Vertex_handle> handle(ids.size());
  const auto index = [&](Id id) {
    return static_cast<std::size_t>(std::ranges::lower_bound(ids, id) - ids.begin());
  };
  for (auto v = cdt.finite_vertices_begin(); v != cdt.finite_vertices_end(); ++v) {
    handle[index(v->info())] = v;
  }
  try {
    for (const auto& e : edges) cdt.insert_constraint(handle[index(e[0])], handle[index(e[1])]);
  } catch (const typename Cdt::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  for (const auto& e : edges) {
    typename Cdt::Face_handle f;
    int k = 0;
    if (!cdt.is_edge(handle[index(e[0])], handle[index(e[1])], f, k)) return std::nullopt;
  }
  Triangulation out;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    f->info() = static_cast<Id>(out.triangles.size());
    out.triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    auto& next = out.neighbor.emplace_back();
    auto& is_edge = out.is_edge.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto n = f->neighbor(static_cast<int>(k));
      next[k] = cdt.is_infinite(n) ? kNone : n->info();
      is_edge[k] = f->is_constrained(static_cast<int>(k));
    }
  }
  return out;
}

}  // namespace

namespace {

/// Whether rounding has turned no triangle over. One whose corners are on a line is none of the
/// edges' making and does no harm.
bool upright(Space& space, Id plane, const Triangulation& net) {
  return std::ranges::all_of(net.triangles, [&](const std::array<Id, 3>& t) {
    return space.turn(plane, t[0], t[1], t[2]) >= 0;
  });
}

}  // namespace

Triangulation triangulate(Space& space, Id plane, std::span<const std::array<Id, 2>> edges) {
  if (auto out = attempt(Rounded(), space, plane, edges); out && upright(space, plane, *out)) {
    return std::move(*out);
  }
  if (auto out = attempt(Exactly(space, plane), space, plane, edges)) return std::move(*out);
  throw GeometryError("edges of a facet cross");
}

}  // namespace burin::csg
