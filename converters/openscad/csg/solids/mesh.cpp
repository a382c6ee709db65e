#include "mesh.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace burin::csg {
namespace {

std::uint64_t directed(Id a, Id b) { return (std::uint64_t{a} << 32) | b; }

class Maker {
 public:
  Maker(Space& space, bool tangled) : space_(space) { mesh_.tangled = tangled; }

  void add(std::array<Id, 3> t, std::int32_t surface, bool merge) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    triangles_.push_back({t, surface, merge});
  }

  Mesh make() {
    pair();
    std::vector<std::uint32_t> order(triangles_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<double> areas(order.size());
    for (const std::uint32_t i : order) areas[i] = area(triangles_[i].corner);
    std::ranges::stable_sort(order,
                             [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
    for (const std::uint32_t i : order) {
      if (triangles_[i].facet == kNone) grow(i);
    }
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) outline(i);
    find_boxes(space_, mesh_);
    return std::move(mesh_);
  }

 private:
  struct Triangle {
    std::array<Id, 3> corner;
    std::int32_t surface = -1;
    bool merge = true;
    Id facet = kNone;
  };

  double area(const std::array<Id, 3>& t) const {
    return glm::length(
        glm::cross(space_.at(t[1]) - space_.at(t[0]), space_.at(t[2]) - space_.at(t[0])));
  }

  void pair() {
    side_.reserve(triangles_.size() * 3);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      const auto& c = triangles_[i].corner;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [at, fresh] = side_.try_emplace(directed(c[k], c[(k + 1) % 3]), i);
        if (!fresh) at->second = kNone, mesh_.tangled = true;
      }
    }
  }
  std::uint32_t across(Id a, Id b) const {
    const auto found = side_.find(directed(b, a));
    return found == side_.end() ? kNone : found->second;
  }

  bool on_line(const std::array<Id, 3>& t) {
    // Sure where the height is far above the errors.
    const Vec3 a = space_.at(t[0]), u = space_.at(t[1]) - a, v = space_.at(t[2]) - a;
    const double longest = std::max({glm::length(u), glm::length(v), glm::length(u - v)});
    if (glm::length(glm::cross(u, v)) > 1e-9 * longest * std::max(longest, 1e-3 * space_.size()))
      return false;
    const Exact plane =
        plane_through(space_.exact_point(t[0]), space_.exact_point(t[1]), space_.exact_point(t[2]));
    return plane.c[0] == 0 && plane.c[1] == 0 && plane.c[2] == 0;
  }

  /// A facet from triangle `seed` and what goes on in its plane.
  void grow(std::uint32_t seed) {
    if (on_line(triangles_[seed].corner)) {
      mesh_.tangled = true;
      return;
    }
    const auto [plane, along] = [&] {
      const auto& c = triangles_[seed].corner;
      return space_.plane(c[0], c[1], c[2]);
    }();
    const auto facet = static_cast<Id>(mesh_.facets.size());
    mesh_.facets.push_back({plane, along, triangles_[seed].surface, {}, {}});
    const auto turn_of = [&, p = plane](const auto& c) { return space_.turn(p, c[0], c[1], c[2]); };
    const int turn = turn_of(triangles_[seed].corner);
    triangles_[seed].facet = facet;
    for (const Id c : triangles_[seed].corner) space_.lies_in(c, plane);
    std::vector<std::uint32_t> open{seed};
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      if (!triangles_[i].merge) continue;
      const auto c = triangles_[i].corner;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t j = across(c[k], c[(k + 1) % 3]);
        if (j == kNone) continue;
        Triangle& next = triangles_[j];
        if (next.facet != kNone || next.surface != triangles_[i].surface) continue;
        bool flat = true;
        for (const Id corner : next.corner) flat = flat && space_.side(corner, plane) == 0;
        if (!flat || turn_of(next.corner) != turn) continue;
        for (const Id corner : next.corner) space_.lies_in(corner, plane);
        next.facet = facet;
        open.push_back(j);
      }
    }
  }

  /// Adds the sides of a triangle that end its facet.
  void outline(std::uint32_t i) {
    const Triangle& t = triangles_[i];
    if (t.facet == kNone) return;
    Facet& facet = mesh_.facets[t.facet];
    for (std::size_t k = 0; k < 3; ++k) {
      const Id a = t.corner[k], b = t.corner[(k + 1) % 3];
      const std::uint32_t j = across(a, b);
      Id other = facet.plane;
      if (j != kNone && triangles_[j].facet != kNone) {
        if (triangles_[j].facet == t.facet) continue;
        other = mesh_.facets[triangles_[j].facet].plane;
      }
      if (other == facet.plane) other = space_.plane_beside(a, b, facet.plane);
      facet.edges.push_back({a, b, space_.line(a, b, facet.plane, other)});
    }
  }

  Space& space_;
  Mesh mesh_;
  std::vector<Triangle> triangles_;
  std::unordered_map<std::uint64_t, std::uint32_t> side_;
};

/// Whether neighbouring triangles of it can lie in one plane: those of cones and spheres, whose
/// corners are rounded, do not; the walls of what is extruded straight do.
bool flat_strips(const Turned& t) {
  if (t.profile == Turned::Profile::Line) return t.a.x == t.b.x;
  if (t.profile == Turned::Profile::Circle || t.grid->rows != 2) return false;
  const PointGrid& g = *t.grid;
  const Vec3 up = g.point(1, 0) - g.point(0, 0);
  for (std::int32_t i = 1; i < g.columns; ++i) {
    if (g.point(1, i) - g.point(0, i) != up) return false;
  }
  return true;
}

}  // namespace

Mesh mesh_of(Space& space, const Solid& solid, Id matrix, bool mirrored,
             std::span<const std::int32_t> surfaces, bool tangled) {
  Maker maker(space, tangled);
  std::vector<char> flat;
  for (const Turned& t : solid.surfaces) flat.push_back(flat_strips(t));
  std::vector<Id> corner(solid.positions.size(), kNone);
  for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
    std::array<Id, 3> t;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = solid.triangles[i][k];
      if (corner[v] == kNone) corner[v] = space.corner(solid.positions[v], matrix);
      t[k] = corner[v];
    }
    if (mirrored) std::swap(t[1], t[2]);
    const std::int32_t s = solid.surface[i];
    maker.add(t, s < 0 ? -1 : surfaces[static_cast<std::size_t>(s)],
              s < 0 || flat[static_cast<std::size_t>(s)]);
  }
  return maker.make();
}

void find_boxes(const Space& space, Mesh& mesh) {
  mesh.box = {};
  for (Facet& f : mesh.facets) {
    f.box = {};
    for (const Edge& e : f.edges) {
      for (const Id p : {e.a, e.b}) {
        const Vec3 reach(2 * space.error(p) + 1e-15 * space.size());
        f.box.add(space.at(p) - reach);
        f.box.add(space.at(p) + reach);
      }
    }
    mesh.box.add(f.box);
  }
}

}  // namespace burin::csg
