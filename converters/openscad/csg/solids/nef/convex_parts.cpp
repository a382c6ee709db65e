#include <burin/base/error.h>

#include "../hull3.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/convex_decomposition_3.h>
#include <fmt/format.h>

// The only unit with Nef polyhedra: it takes long to compile.
namespace burin::csg {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

class Builder : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  explicit Builder(const Solid& solid) : solid_(solid) {}
  void operator()(Polyhedron::HalfedgeDS& hds) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> b(hds);
    b.begin_surface(solid_.positions.size(), solid_.triangles.size());
    for (const Vec3& p : solid_.positions) b.add_vertex(Kernel::Point_3(p.x, p.y, p.z));
    for (const auto& t : solid_.triangles) {
      b.begin_facet();
      for (const std::uint32_t v : t) b.add_vertex_to_facet(v);
      b.end_facet();
    }
    b.end_surface();
  }

 private:
  const Solid& solid_;
};

/// The corners of one volume of a decomposition.
std::vector<Vec3> corners(Nef& nef, Nef::Volume_const_iterator volume) {
  Polyhedron p;
  nef.convert_inner_shell_to_polyhedron(volume->shells_begin(), p);
  std::vector<Vec3> out;
  for (auto v = p.points_begin(); v != p.points_end(); ++v) {
    out.emplace_back(CGAL::to_double(v->x()), CGAL::to_double(v->y()), CGAL::to_double(v->z()));
  }
  return out;
}

}  // namespace

std::vector<std::vector<Vec3>> convex_parts(const Solid& solid) {
  std::vector<std::vector<Vec3>> out;
  try {
    Polyhedron p;
    Builder builder(solid);
    p.delegate(builder);
    Nef nef(p);
    CGAL::convex_decomposition_3(nef);
    // The first volume is the outside.
    for (auto v = ++nef.volumes_begin(); v != nef.volumes_end(); ++v) {
      if (v->mark()) out.push_back(corners(nef, v));
    }
  } catch (const std::exception& error) {
    throw GeometryError(
        fmt::format("minkowski() of a solid that has no convex parts: {}", error.what()));
  }
  return out;
}

}  // namespace burin::csg
