#include "primitives.h"

#include <burin/base/error.h>
#include <burin/repair/polygons.h>

#include "../at_node.h"
#include "../fragments.h"
#include "places.h"
#include "rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace burin::csg {
namespace {

using std::numbers::pi;

void add(Solid& solid, std::uint32_t a, std::uint32_t b, std::uint32_t c,
         std::int32_t surface = -1) {
  solid.triangles.push_back({a, b, c});
  solid.surface.push_back(surface);
}
void add_quad(Solid& solid, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  add(solid, a, b, c);
  add(solid, a, c, d);
}

/// A polygon of consecutive points about its first.
void add_fan(Solid& solid, std::uint32_t first, std::uint32_t n, bool up, std::int32_t surface) {
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    add(solid, first, first + (up ? i : i + 1), first + (up ? i + 1 : i), surface);
  }
}

bool positive(double v) { return v > 0 && std::isfinite(v); }

Solid cube(const Node& node) {
  std::vector<double> size = node.numbers("size");
  if (size.size() != 3 || !std::ranges::all_of(size, positive)) return {};
  const Vec3 whole(size[0], size[1], size[2]);
  const bool center = node.truth("center", false);
  const Vec3 low = center ? -whole / 2.0 : Vec3(0), high = center ? whole / 2.0 : whole;
  Solid out;
  for (unsigned i = 0; i < 8; ++i) {
    out.positions.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                               (i & 4) != 0 ? high.z : low.z);
  }
  add_quad(out, 0, 2, 3, 1);
  add_quad(out, 4, 5, 7, 6);
  add_quad(out, 0, 1, 5, 4);
  add_quad(out, 1, 3, 7, 5);
  add_quad(out, 3, 2, 6, 7);
  add_quad(out, 2, 0, 4, 6);
  return out;
}

void add_ring(Solid& solid, double r, double z, int n) {
  for (int i = 0; i < n; ++i) {
    const Vec2 p = r * corner(i, n);
    solid.positions.emplace_back(p.x, p.y, z);
  }
}

Solid sphere(const Node& node) {
  const double r = node.number("r", 1);
  if (!positive(r)) return {};
  const int n = fragments(r, fineness_of(node));
  const int rings = (n + 1) / 2;
  Solid out;
  std::int32_t surface = -1;
  if (n >= kFewestRound) {
    surface = 0;
    Turned t;
    t.step = 2 * pi / n;
    t.profile = Turned::Profile::Circle;
    t.radius = r;
    t.profile_step = pi / rings;
    out.surfaces.push_back(t);
  }
  // From the top; no ring is a pole.
  for (int k = 0; k < rings; ++k) {
    const Vec2 p = r * corner(2 * k + 1, 4 * rings);
    add_ring(out, p.y, p.x, n);
  }
  const auto count = static_cast<std::uint32_t>(n);
  add_fan(out, 0, count, true, surface);
  for (std::uint32_t k = 0; k + 1 < static_cast<std::uint32_t>(rings); ++k) {
    const std::uint32_t upper = k * count, lower = upper + count;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t j = (i + 1) % count;
      add(out, upper + i, lower + i, lower + j, surface);
      add(out, upper + i, lower + j, upper + j, surface);
    }
  }
  add_fan(out, (static_cast<std::uint32_t>(rings) - 1) * count, count, false, surface);
  return out;
}

Solid cylinder(const Node& node) {
  const double h = node.number("h", 1), r1 = node.number("r1", 1), r2 = node.number("r2", 1);
  if (!positive(h) || !(r1 >= 0 && r2 >= 0) || !positive(std::max(r1, r2))) return {};
  const int n = fragments(std::max(r1, r2), fineness_of(node));
  const double low = node.truth("center", false) ? -h / 2 : 0, high = low + h;
  Solid out;
  std::int32_t side = -1;
  if (n >= kFewestRound) {
    side = 0;
    Turned t;
    t.origin = {0, 0, low};
    t.step = 2 * pi / n;
    t.a = {r1, 0};
    t.b = {r2, h};
    out.surfaces.push_back(t);
  }
  const auto count = static_cast<std::uint32_t>(n);
  // A ring, or the one point that a cone ends in.
  const auto ring = [&](double r, double z) {
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    if (r > 0)
      add_ring(out, r, z, n);
    else
      out.positions.emplace_back(0, 0, z);
    return first;
  };
  const std::uint32_t bottom = ring(r1, low), top = ring(r2, high);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    const std::uint32_t top_i = r2 > 0 ? top + i : top;
    if (r1 > 0) add(out, bottom + i, bottom + j, top_i, side);
    if (r2 > 0) add(out, top_i, r1 > 0 ? bottom + j : bottom, top + j, side);
  }
  if (r1 > 0) add_fan(out, bottom, count, false, -1);
  if (r2 > 0) add_fan(out, top, count, true, -1);
  return out;
}

/// The faces by those of their corners that are points of the list.
Faces faces_of(Evaluation& e, std::uint32_t node, const Value& list, std::size_t points) {
  Faces out;
  for (const Value& face : list.list) {
    auto& corners = out.emplace_back();
    for (const Value& v : face.list) {
      if (v.kind == Value::Kind::Number && v.number >= 0 &&
          v.number < static_cast<double>(points)) {
        corners.push_back(static_cast<std::uint32_t>(v.number));
      } else {
        report(e, node, "openscad.polyhedron_point",
               "a face of polyhedron() names a point that it does not have; the point is left out");
      }
    }
  }
  return out;
}

/// A face by the points that stand for its corners, none twice in a row; turned outwards, as
/// OpenSCAD's turn clockwise seen from outside.
std::vector<std::uint32_t> outline_of(const std::vector<std::uint32_t>& face,
                                      const std::vector<std::uint32_t>& number) {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t corner : face) {
    if (out.empty() || out.back() != number[corner]) out.push_back(number[corner]);
  }
  while (out.size() > 1 && out.front() == out.back()) out.pop_back();
  std::ranges::reverse(out);
  return out;
}

/// A quadrangle, which may not be flat, along its shorter diagonal, as OpenSCAD cuts it; false
/// where it has no such diagonal within.
bool cut_quad(const std::vector<Vec3>& p, const std::vector<std::uint32_t>& c,
              std::vector<Triangle>& out) {
  if (c.size() != 4) return false;
  const bool turn = glm::distance(p[c[1]], p[c[3]]) < glm::distance(p[c[0]], p[c[2]]);
  const std::array<std::uint32_t, 4> q =
      turn ? std::array{c[1], c[2], c[3], c[0]} : std::array{c[0], c[1], c[2], c[3]};
  const auto normal = [&](std::uint32_t a, std::uint32_t b, std::uint32_t d) {
    return glm::cross(p[b] - p[a], p[d] - p[a]);
  };
  if (!(glm::dot(normal(q[0], q[1], q[2]), normal(q[0], q[2], q[3])) > 0)) return false;
  out[0] = {q[0], q[1], q[2]};
  out[1] = {q[0], q[2], q[3]};
  return true;
}

/// The solid of faces whose corners stand for others of their place, each with what it stands for.
Solid over(const std::vector<Vec3>& points, const Faces& faces,
           const std::vector<std::uint32_t>& number, const FaceSurfaces& by_rows, RunContext& run) {
  Solid out;
  out.positions = points;
  out.surfaces = by_rows.surfaces;
  std::vector<Triangle> cut;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::vector<std::uint32_t> c = outline_of(faces[f], number);
    if (c.size() < 3) continue;
    cut.resize(c.size() - 2);
    if (!cut_quad(points, c, cut)) triangulate_polygon(points, c, cut, run);
    for (const Triangle& t : cut) add(out, t[0], t[1], t[2], by_rows.of[f]);
  }
  return out;
}

/// Faces may have corners of their own, as most libraries write them: closed is what is closed by
/// place. Open ones stay as they are.
Solid closed_by_place(const std::vector<Vec3>& points, const Faces& faces, RunContext& run) {
  const FaceSurfaces by_rows = surfaces_by_rows(points, faces, run);
  std::vector<std::uint32_t> number(points.size());
  std::iota(number.begin(), number.end(), 0U);
  Solid given = over(points, faces, number, by_rows, run);
  if (closed(given)) return given;
  number = by_place(points, kFineGrid);
  Solid welded = over(points, faces, number, by_rows, run);
  if (closed(welded)) return welded;
  // The digits of a tree may hold apart what was one point.
  const std::vector<std::uint32_t> near =
      by_place(points, open_corners(welded), last_digit(points));
  for (std::uint32_t& n : number) n = near[n];
  Solid joined = over(points, faces, number, by_rows, run);
  return closed(joined) ? joined : given;
}

Solid polyhedron(Evaluation& e, std::uint32_t at) {
  const Node& node = e.tree.nodes[at];
  const Value *list = node.argument("points"), *faces = node.argument("faces");
  if (!list || !faces) return {};
  std::vector<Vec3> points;
  for (const Value& v : list->list) {
    Vec3 p(0);
    const std::size_t n = std::min<std::size_t>(v.list.size(), 3);
    for (std::size_t i = 0; i < n; ++i) p[static_cast<int>(i)] = v.list[i].number;
    if (n < 2 || !std::isfinite(p.x + p.y + p.z)) {
      report(e, at, "openscad.polyhedron_point",
             "polyhedron() with a point that is none; it is left out");
      return {};
    }
    points.push_back(p);
  }
  return closed_by_place(points, faces_of(e, at, *faces, points.size()), e.run);
}

}  // namespace

Solid primitive(Evaluation& e, std::uint32_t at) {
  const Node& node = e.tree.nodes[at];
  return at_node(e, at, [&] {
    switch (node.module) {
      case Module::Cube:
        return cube(node);
      case Module::Sphere:
        return sphere(node);
      case Module::Cylinder:
        return cylinder(node);
      default:
        return polyhedron(e, at);
    }
  });
}

}  // namespace burin::csg
