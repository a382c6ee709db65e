// CGAL's Mesh_3 behind refine.h. Nothing else belongs in here: it takes half a minute to compile.

#include "refine.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_3/Mesher_3.h>
#include <CGAL/Mesh_3/Protect_edges_sizing_field.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace burin {
namespace {

// CGAL 5 has optional and variant of Boost in its interfaces, CGAL 6 those of the standard library.
#if CGAL_VERSION_MAJOR >= 6
namespace cgal_std = std;
template <class T, class Variant>
const T* held(const Variant& v) {
  return std::get_if<T>(&v);
}
#else
namespace cgal_std = boost;
template <class T, class Variant>
const T* held(const Variant& v) {
  return cgal_std::get<T>(&v);
}
#endif

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Vec3 to_vec(const Point& p) {
  const Vec3 v(p.x(), p.y(), p.z());
  // Balls around points in one plane: bisection between them would never end.
  if (!std::isfinite(v.x + v.y + v.z)) throw std::runtime_error("a point is not finite");
  return v;
}
Point to_point(Vec3 v) { return {v.x, v.y, v.z}; }

// The names are those that CGAL's concept asks for.
// NOLINTBEGIN(readability-identifier-naming)
/// CGAL's concept MeshDomain_3: one body, its surface found by the field.
class Body {
 public:
  using R = Kernel;
  using FT = Kernel::FT;
  using Point_3 = Point;
  using Segment_3 = Kernel::Segment_3;
  using Ray_3 = Kernel::Ray_3;
  using Line_3 = Kernel::Line_3;
  using Has_features = CGAL::Tag_false;
  using Subdomain_index = int;
  using Surface_patch_index = std::pair<int, int>;
  using Subdomain = cgal_std::optional<Subdomain_index>;
  using Surface_patch = cgal_std::optional<Surface_patch_index>;
  using Index = CGAL::Mesh_3::internal::Index_generator<Subdomain_index, Surface_patch_index>::type;
  using Intersection = std::tuple<Point_3, Index, int>;

  Body(RefineField* field, const Box3& box)
      : field_(field),
        bounds_(box),
        box_(box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z) {}

  CGAL::Bbox_3 bbox() const { return box_.bbox(); }
  bool inside(const Point& p) const {
    const Vec3 v = to_vec(p);
    return v == glm::clamp(v, bounds_.min, bounds_.max) && field_->inside(v);
  }

  struct Is_in_domain {
    const Body& body;
    Subdomain operator()(const Point& p) const {
      return body.inside(p) ? Subdomain(1) : Subdomain();
    }
  };
  Is_in_domain is_in_domain_object() const { return {*this}; }

  struct Do_intersect_surface {
    const Body& body;
    Surface_patch operator()(const Segment_3& s) const {
      return body.inside(s.source()) != body.inside(s.target()) ? Surface_patch({0, 1})
                                                                : Surface_patch();
    }
    template <class Endless>
    Surface_patch operator()(const Endless& e) const {
      const auto s = body.clipped(e);
      return s ? (*this)(*s) : Surface_patch();
    }
  };
  Do_intersect_surface do_intersect_surface_object() const { return {*this}; }

  struct Construct_intersection {
    const Body& body;
    Intersection operator()(const Segment_3& s) const {
      if (body.inside(s.source()) == body.inside(s.target())) return Intersection();
      const Vec3 p = body.field_->crossing(to_vec(s.source()), to_vec(s.target()));
      return {to_point(p), Index(Surface_patch_index(0, 1)), 2};
    }
    template <class Endless>
    Intersection operator()(const Endless& e) const {
      const auto s = body.clipped(e);
      return s ? (*this)(*s) : Intersection();
    }
  };
  Construct_intersection construct_intersection_object() const { return {*this}; }

  Index index_from_surface_patch_index(const Surface_patch_index& i) const { return Index(i); }
  Index index_from_subdomain_index(const Subdomain_index& i) const { return Index(i); }
  Surface_patch_index surface_patch_index(const Index& i) const {
    return cgal_std::get<Surface_patch_index>(i);
  }
  Subdomain_index subdomain_index(const Index& i) const {
    return cgal_std::get<Subdomain_index>(i);
  }

 private:
  template <class Endless>
  cgal_std::optional<Segment_3> clipped(const Endless& e) const {
    const auto part = CGAL::intersection(e, box_);
    if (!part) return {};
    const auto* s = held<Segment_3>(*part);
    return s ? cgal_std::optional<Segment_3>(*s) : cgal_std::optional<Segment_3>();
  }

  RefineField* field_;
  Box3 bounds_;
  Kernel::Iso_cuboid_3 box_;
};
// NOLINTEND(readability-identifier-naming)

using Domain = CGAL::Mesh_domain_with_polyline_features_3<Body>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index,
                                                        Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
using Mesher = CGAL::Mesh_3::Mesher_3<Complex, Criteria, Domain>;
using Vertex = Complex::Vertex_handle;

struct Radius {
  using FT = Kernel::FT;
  RefineField* field;
  FT operator()(const Point& p, int, const Domain::Index&) const {
    return field->radius(to_vec(p));
  }
};
struct Edge {
  using FT = Kernel::FT;
  RefineField* field;
  FT operator()(const Point& p, int, const Domain::Index&) const { return field->edge(to_vec(p)); }
};

void add_features(Domain& domain, const RefineInput& input) {
  for (const Vec3& c : input.corners) domain.add_corner(to_point(c));
  std::vector<std::vector<Point>> curves;
  for (const auto& curve : input.curves) {
    std::vector<Point> points;
    for (const Vec3& p : curve) points.push_back(to_point(p));
    curves.push_back(std::move(points));
  }
  domain.add_features(curves.begin(), curves.end());
}

void protect(Complex& complex, const Domain& domain, RefineField& field, const RefineInput& input) {
  CGAL::Mesh_error_code code = CGAL::CGAL_MESH_3_NO_ERROR;
#if CGAL_VERSION_MAJOR >= 6
  // With a least size CGAL 6 gives each corner a ball of just that size, and the edges of a thin
  // plate hundreds of vertices. Without one the number of vertices ends what would not end.
  constexpr double kLeast = 0;
  CGAL::Mesh_3::Protect_edges_sizing_field<Complex, Domain, Edge> balls(
      complex, domain, Edge{&field}, kLeast, {}, input.most_vertices, &code);
#else
  CGAL::Mesh_3::Protect_edges_sizing_field<Complex, Domain, Edge> balls(
      complex, domain, Edge{&field}, input.least_edge, input.most_vertices, &code);
#endif
  balls(true);
}

void insert_seeds(Complex& complex, const RefineInput& input) {
  Triangulation& tr = complex.triangulation();
  auto hint = Triangulation::Cell_handle();
  for (const Vec3& s : input.seeds) {
    const auto point = tr.geom_traits().construct_weighted_point_3_object()(to_point(s));
    const Vertex v = tr.insert(point, hint);
    if (v == Vertex()) continue;  // within the ball of a curve's vertex
    complex.set_dimension(v, 2);
    complex.set_index(v, Domain::Index(Body::Surface_patch_index(0, 1)));
    hint = v->cell();
  }
}

RefinedMesh extract(const Complex& complex, const Domain& domain) {
  RefinedMesh mesh;
  const Triangulation& tr = complex.triangulation();
  std::unordered_map<const void*, std::uint32_t> names;
  names.reserve(tr.number_of_vertices());
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v) {
    names.emplace(&*v, static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(to_vec(v->point().point()));
    mesh.dimension.push_back(static_cast<std::uint8_t>(std::clamp(complex.in_dimension(v), 0, 2)));
  }
  const auto inside = [&](Triangulation::Cell_handle c) {
    return !tr.is_infinite(c) && domain.inside(tr.dual(c));
  };
  for (auto f = complex.facets_in_complex_begin(); f != complex.facets_in_complex_end(); ++f) {
    auto [cell, i] = *f;
    // Seen from the cell outside; these are the signs by which the facet is one of the surface.
    if (inside(cell)) {
      const auto mirror = tr.mirror_facet(*f);
      cell = mirror.first;
      i = mirror.second;
    }
    Triangle t;
    for (int k = 0; k < 3; ++k) {
      t[static_cast<std::size_t>(k)] =
          names.at(&*cell->vertex(Triangulation::vertex_triple_index(i, k)));
    }
    mesh.triangles.push_back(t);
  }
  // The order of cells in memory is that of their making, but let it not matter.
  for (Triangle& t : mesh.triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(mesh.triangles.begin(), mesh.triangles.end());
  return mesh;
}

bool is_manifold(const RefinedMesh& mesh) {
  // Each half-edge once, with its other half; and around a vertex one cycle of all its triangles.
  struct Half {
    std::uint32_t from, to, opposite;
  };
  std::vector<Half> halves;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) halves.push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3]});
  }
  const auto less = [](const Half& a, const Half& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  };
  std::sort(halves.begin(), halves.end(), less);
  const auto find = [&](std::uint32_t from, std::uint32_t to) {
    const Half wanted{from, to, 0};
    const auto it = std::lower_bound(halves.begin(), halves.end(), wanted, less);
    return it != halves.end() && it->from == from && it->to == to ? &*it : nullptr;
  };
  for (std::size_t i = 0; i < halves.size(); ++i) {
    if (i > 0 && !less(halves[i - 1], halves[i])) return false;
    if (!find(halves[i].to, halves[i].from)) return false;
  }
  for (std::size_t i = 0; i < halves.size();) {
    std::size_t end = i;
    while (end < halves.size() && halves[end].from == halves[i].from) ++end;
    std::size_t turns = 0;
    std::uint32_t to = halves[i].to;
    do {
      const Half* h = find(halves[i].from, to);
      if (!h) return false;
      to = h->opposite;
      ++turns;
    } while (to != halves[i].to && turns <= end - i);
    if (turns != end - i) return false;
    i = end;
  }
  return !mesh.triangles.empty();
}

RefinedMesh refine(const RefineInput& input, RefineField& field) {
  constexpr double kLeastAngle = 25;  // degrees; above 30 refinement need not end
  CGAL::get_default_random() = CGAL::Random(0);
  Domain domain(&field, input.box);
  add_features(domain, input);
  Complex complex;
  protect(complex, domain, field, input);
  insert_seeds(complex, input);
  const Criteria criteria(Criteria::Edge_criteria(std::numeric_limits<double>::max()),
                          Criteria::Facet_criteria(kLeastAngle, Radius{&field}, input.distance),
                          Criteria::Cell_criteria(0, 0));
  RefinedMesh mesh;
  // Asking for a manifold costs half as much again, and mostly it is one.
  for (const std::size_t topology : {std::size_t{0}, std::size_t{CGAL::MANIFOLD}}) {
    CGAL::Mesh_error_code code = CGAL::CGAL_MESH_3_NO_ERROR;
    Mesher(complex, domain, criteria, topology, input.most_vertices, &code).refine_mesh();
    mesh = extract(complex, domain);
    mesh.full = code == CGAL::CGAL_MESH_3_MAXIMAL_NUMBER_OF_VERTICES_REACHED;
    mesh.manifold = is_manifold(mesh);
    if (mesh.manifold || mesh.full) break;
    complex.clear_manifold_info();
  }
  return mesh;
}

}  // namespace

RefinedMesh refine_surface(const RefineInput& input, RefineField& field) {
  try {
    return refine(input, field);
  } catch (const CGAL::Failure_exception&) {
    throw std::runtime_error("creases lie over each other");
  }
}

}  // namespace burin
