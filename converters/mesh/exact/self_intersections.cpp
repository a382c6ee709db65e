#include "../self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <array>

// The only unit of the converters that sees CGAL: compiled on its own, as its flags
// (-frounding-math) and cost would otherwise reach every other one.
namespace burin {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Corners = std::array<Point, 3>;

struct IdBox {
  using NT = double;
  using ID = std::size_t;
  std::array<double, 3> low, high;
  std::size_t triangle = 0;
  static int dimension() { return 3; }
  ID id() const { return triangle; }
  NT min_coord(int d) const { return low[static_cast<std::size_t>(d)]; }
  NT max_coord(int d) const { return high[static_cast<std::size_t>(d)]; }
};

Corners corners_of(const TriMesh& mesh, std::size_t t) {
  const auto point = [&](std::uint32_t v) {
    const Vec3& p = mesh.positions[v];
    return Point(p.x, p.y, p.z);
  };
  const Triangle& tri = mesh.triangles[t];
  return {point(tri[0]), point(tri[1]), point(tri[2])};
}

Kernel::Triangle_3 triangle(const Corners& c) { return {c[0], c[1], c[2]}; }

/// Two triangles with the common edge pq overlap where they lie in one plane on one side of it.
bool fold_over(const Point& p, const Point& q, const Point& a, const Point& b) {
  return CGAL::coplanar(p, q, a, b) && CGAL::coplanar_orientation(p, q, a, b) == CGAL::POSITIVE;
}

bool cross(const Corners& s, const Corners& t) {
  // Corners at the same place in both; `k` of s is `l` of t.
  int shared = 0;
  std::size_t k = 0, l = 0, s_sum = 0, t_sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (s[i] != t[j]) continue;
      ++shared;
      k = i, l = j, s_sum += i, t_sum += j;
    }
  }
  if (shared == 0) return CGAL::do_intersect(triangle(s), triangle(t));
  if (shared == 1) {
    const Kernel::Segment_3 far_s(s[(k + 1) % 3], s[(k + 2) % 3]),
        far_t(t[(l + 1) % 3], t[(l + 2) % 3]);
    return CGAL::do_intersect(far_s, triangle(t)) || CGAL::do_intersect(far_t, triangle(s));
  }
  if (shared == 2) {
    const std::size_t a = 3 - s_sum, b = 3 - t_sum;  // the corners that are not shared
    return fold_over(s[(a + 1) % 3], s[(a + 2) % 3], s[a], t[b]);
  }
  return true;
}

}  // namespace

std::int64_t count_self_intersections(const TriMesh& mesh, const RunContext& context) {
  std::vector<IdBox> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Box3 b;
    for (const std::uint32_t v : mesh.triangles[t]) b.add(mesh.positions[v]);
    boxes.push_back({{b.min.x, b.min.y, b.min.z}, {b.max.x, b.max.y, b.max.z}, t});
  }
  std::vector<const IdBox*> pointers;
  pointers.reserve(boxes.size());
  for (const IdBox& b : boxes) pointers.push_back(&b);
  context.check();
  std::int64_t count = 0;
  const auto meet = [&](const IdBox* a, const IdBox* b) {
    context.check();
    count += cross(corners_of(mesh, a->triangle), corners_of(mesh, b->triangle));
  };
  CGAL::box_self_intersection_d(pointers.begin(), pointers.end(), meet, std::ptrdiff_t{10});
  return count;
}

}  // namespace burin
