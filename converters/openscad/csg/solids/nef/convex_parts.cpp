#include <burin/base/disjoint_sets.h>
#include <burin/base/error.h>

#include "../hull3.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/convex_decomposition_3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

// The only unit with Nef polyhedra: it takes long to compile.
namespace burin::csg {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

class Builder : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  Builder(const std::vector<Vec3>& positions, const Triangles& triangles)
      : positions_(positions), triangles_(triangles) {}
  void operator()(Polyhedron::HalfedgeDS& hds) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> b(hds);
    b.begin_surface(positions_.size(), triangles_.size());
    for (const Vec3& p : positions_) b.add_vertex(Kernel::Point_3(p.x, p.y, p.z));
    for (const auto& t : triangles_) {
      b.begin_facet();
      for (const std::uint32_t v : t) b.add_vertex_to_facet(v);
      b.end_facet();
    }
    b.remove_unconnected_vertices();
    b.end_surface();
  }

 private:
  const std::vector<Vec3>& positions_;
  const Triangles& triangles_;
};

/// The surfaces that a solid is bounded by, each on its own.
std::vector<Triangles> shells(const Solid& solid) {
  DisjointSets sets(solid.positions.size());
  for (const auto& t : solid.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  std::map<std::uint32_t, Triangles> by_set;
  for (const auto& t : solid.triangles) by_set[sets.find(t[0])].push_back(t);
  std::vector<Triangles> out;
  for (auto& [set, triangles] : by_set) out.push_back(std::move(triangles));
  return out;
}

double volume(const std::vector<Vec3>& p, const Triangles& triangles) {
  double sum = 0;
  for (const auto& t : triangles) sum += glm::dot(p[t[0]], glm::cross(p[t[1]], p[t[2]])) / 6;
  return sum;
}

/// Of a closed surface that looks outwards.
Nef nef_of(const std::vector<Vec3>& positions, const Triangles& triangles) {
  Polyhedron p;
  Builder builder(positions, triangles);
  p.delegate(builder);
  if (!p.is_closed()) throw GeometryError("its surface is no manifold");
  return Nef(p);
}

/// Whole shells first, then what they hold: cavities look inwards.
Nef nef_of(const Solid& solid) {
  struct Shell {
    Triangles triangles;
    double volume = 0;
  };
  std::vector<Shell> all;
  for (Triangles& t : shells(solid)) {
    const double v = volume(solid.positions, t);
    all.push_back({std::move(t), v});
  }
  std::ranges::stable_sort(
      all, [](const Shell& a, const Shell& b) { return std::abs(a.volume) > std::abs(b.volume); });
  Nef out;
  for (Shell& shell : all) {
    if (shell.volume < 0) {
      for (auto& t : shell.triangles) std::swap(t[1], t[2]);
      out -= nef_of(solid.positions, shell.triangles);
    } else {
      out += nef_of(solid.positions, shell.triangles);
    }
  }
  return out;
}

bool is_less(const Vec3& a, const Vec3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// A lazy number gives another double before it was worked out exactly than after.
double rounded(const Kernel::FT& number) { return CGAL::to_double(CGAL::exact(number)); }

/// The corners of one volume of a decomposition, in the order of their coordinates: that of a Nef
/// polyhedron goes by addresses in memory.
std::vector<Vec3> corners(Nef& nef, Nef::Volume_const_iterator volume) {
  Polyhedron p;
  nef.convert_inner_shell_to_polyhedron(volume->shells_begin(), p);
  std::vector<Vec3> out;
  for (auto v = p.points_begin(); v != p.points_end(); ++v) {
    out.emplace_back(rounded(v->x()), rounded(v->y()), rounded(v->z()));
  }
  std::ranges::sort(out, is_less);
  return out;
}

}  // namespace

std::vector<std::vector<Vec3>> convex_parts(const Solid& solid) {
  std::vector<std::vector<Vec3>> out;
  try {
    Nef nef = nef_of(solid);
    CGAL::convex_decomposition_3(nef);
    // The first volume is the outside.
    for (auto v = ++nef.volumes_begin(); v != nef.volumes_end(); ++v) {
      if (v->mark()) out.push_back(corners(nef, v));
    }
  } catch (const std::exception& error) {
    throw GeometryError(
        fmt::format("minkowski() of a solid that has no convex parts: {}", error.what()));
  }
  std::ranges::sort(out, [](const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return std::ranges::lexicographical_compare(a, b, is_less);
  });
  return out;
}

}  // namespace burin::csg
