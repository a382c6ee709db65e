#include "triangle_pairs.h"

#include <CGAL/Box_intersection_d/Box_with_handle_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Rational = CGAL::Exact_rational;
using ExactVec = std::array<Rational, 3>;
using Corners = std::array<Vec3, 3>;
using FaceBox = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const std::uint32_t*>;

Point to_cgal(const Vec3& p) { return {p.x, p.y, p.z}; }

ExactVec difference(const Vec3& to, const Vec3& from) {
  return {Rational(to.x) - Rational(from.x), Rational(to.y) - Rational(from.y),
          Rational(to.z) - Rational(from.z)};
}

ExactVec cross(const ExactVec& u, const ExactVec& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

Rational dot(const ExactVec& u, const ExactVec& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

/// The sign of a*d - b*c where each is a difference of two coordinates, rounded once; 2 where
/// rounding leaves it open.
int filtered_sign(double a, double b, double c, double d) {
  const double p = a * d, q = b * c;
  if (p == 0 && q == 0 && (a == 0 || d == 0) && (b == 0 || c == 0)) return 0;
  // Five roundings of half an ulp each.
  if (std::abs(p - q) <= 1e-15 * (std::abs(p) + std::abs(q))) return 2;
  return p > q ? 1 : -1;
}

/// The sign of dot(u x v, (e, e^2, e^3)) for u = u1 - u0, v = v1 - v0.
int moved_sign(const Vec3& u0, const Vec3& u1, const Vec3& v0, const Vec3& v1) {
  const Vec3 u = u1 - u0, v = v1 - v0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    int s = filtered_sign(u[j], u[k], v[j], v[k]);
    if (s == 2)
      s = CGAL::sign(cross(difference(u1, u0), difference(v1, v0))[static_cast<std::size_t>(i)]);
    if (s != 0) return s;
  }
  return 0;
}

int orientation(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  return CGAL::orientation(to_cgal(p), to_cgal(q), to_cgal(r), to_cgal(s));
}

/// The side of `plane` that `p` is on; `moved` is +1 where p belongs to mesh a, -1 where the plane
/// does.
int side(const Corners& plane, const Vec3& p, int moved) {
  const int s = orientation(plane[0], plane[1], plane[2], p);
  if (s != 0) return s;
  return moved * moved_sign(plane[0], plane[1], plane[0], plane[2]);
}

/// How the line a0 a1 (mesh a) passes the line b0 b1 (mesh b).
int passing(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const int s = orientation(a0, a1, b0, b1);
  return s != 0 ? s : moved_sign(a0, a1, b0, b1);
}

/// Share of the edge p q at which it meets `plane`, whose sides p and q lie on.
double meeting_share(const Corners& plane, const Vec3& p, const Vec3& q) {
  const Vec3 n = glm::cross(plane[1] - plane[0], plane[2] - plane[0]);
  const double dp = glm::dot(n, p - plane[0]), dq = glm::dot(n, q - plane[0]);
  const double size = glm::length(p - plane[0]) + glm::length(q - plane[0]);
  // Both distances have an error of some 1e-15 of this size: where their difference is not far
  // above it, exact arithmetic has to find the place.
  if (std::abs(dp - dq) > 1e-9 * glm::length(n) * size) {
    return std::clamp(dp / (dp - dq), 0.0, 1.0);
  }
  const ExactVec m = cross(difference(plane[1], plane[0]), difference(plane[2], plane[0]));
  const Rational ep = dot(m, difference(p, plane[0])), eq = dot(m, difference(q, plane[0]));
  if (ep == eq) return 0;
  return std::clamp(CGAL::to_double(Rational(ep / (ep - eq))), 0.0, 1.0);
}

/// One mesh and one of its triangles.
struct Face {
  const ProxyMesh* proxy;
  std::uint32_t index;
  Corners corners;

  Face(const ProxyMesh& p, std::uint32_t f) : proxy(&p), index(f) {
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = p.mesh.positions[p.mesh.triangles[f][k]];
    }
  }
};

/// The piercings of `edges`' edges through `plane`, added to `out`.
void pierce(const Face& edges, const Face& plane, const std::array<int, 3>& sides, bool edge_of_b,
            std::vector<Piercing>& out) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    if (sides[k] == sides[l]) continue;
    int turn = 0;
    bool inside = true;
    for (std::size_t j = 0; j < 3 && inside; ++j) {
      const Vec3 &p = edges.corners[k], &q = edges.corners[l];
      const Vec3 &r = plane.corners[j], &s = plane.corners[(j + 1) % 3];
      // orientation(p,q,r,s) = orientation(r,s,p,q)
      const int t = edge_of_b ? passing(r, s, p, q) : passing(p, q, r, s);
      inside = t != 0 && (turn == 0 || t == turn);
      turn = t;
    }
    if (!inside) continue;
    const auto h = static_cast<HalfEdge>(3 * edges.index + k);
    const HalfEdge o = edges.proxy->topology.opposite[static_cast<std::size_t>(h)];
    Piercing piercing;
    piercing.edge_of_b = edge_of_b;
    piercing.edge = o == kNoHalfEdge ? h : std::min(h, o);
    piercing.face = plane.index;
    // From the same end whichever triangle asks.
    const bool swapped = piercing.edge != h;
    const Vec3 &p = edges.corners[swapped ? l : k], &q = edges.corners[swapped ? k : l];
    piercing.position = p + meeting_share(plane.corners, p, q) * (q - p);
    out.push_back(piercing);
  }
}

/// Whether the corners of `face` lie on both sides of the plane of `plane`.
bool straddles(const Face& face, const Face& plane, int moved, std::array<int, 3>& sides) {
  for (std::size_t k = 0; k < 3; ++k) sides[k] = side(plane.corners, face.corners[k], moved);
  return sides[0] != sides[1] || sides[0] != sides[2];
}

void test_pair(const Face& a, const Face& b, std::vector<PairSegment>& out) {
  std::array<int, 3> sides_a{}, sides_b{};
  if (!straddles(a, b, +1, sides_a) || !straddles(b, a, -1, sides_b)) return;
  std::vector<Piercing> piercings;
  pierce(a, b, sides_a, false, piercings);
  pierce(b, a, sides_b, true, piercings);
  if (piercings.size() == 2) out.push_back({a.index, b.index, piercings[0], piercings[1]});
}

std::vector<FaceBox> boxes(const ProxyMesh& proxy, std::span<const std::uint32_t> faces) {
  std::vector<FaceBox> out;
  out.reserve(faces.size());
  for (const std::uint32_t& f : faces) {
    CGAL::Bbox_3 box;
    for (const std::uint32_t v : proxy.mesh.triangles[f]) {
      box += to_cgal(proxy.mesh.positions[v]).bbox();
    }
    out.emplace_back(box, &f);
  }
  return out;
}

}  // namespace

std::vector<PairSegment> intersect_triangles(const ProxyMesh& a,
                                             std::span<const std::uint32_t> faces_a,
                                             const ProxyMesh& b,
                                             std::span<const std::uint32_t> faces_b,
                                             const RunContext& context) {
  std::vector<FaceBox> boxes_a = boxes(a, faces_a), boxes_b = boxes(b, faces_b);
  std::vector<PairSegment> out;
  std::size_t count = 0;
  CGAL::box_intersection_d(boxes_a.begin(), boxes_a.end(), boxes_b.begin(), boxes_b.end(),
                           [&](const FaceBox& x, const FaceBox& y) {
                             if (++count % 1024 == 0) context.check();
                             test_pair(Face(a, *x.handle()), Face(b, *y.handle()), out);
                           });
  std::ranges::sort(out, {}, [](const PairSegment& s) { return std::pair(s.face_a, s.face_b); });
  return out;
}

}  // namespace burin
