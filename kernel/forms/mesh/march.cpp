#include "mesh_surface.h"

#include <cmath>

namespace burin {
namespace {

// A direction nearer to an edge than this angle (radians) runs along it: rounding must not decide
// on which side of the edge it goes on, nor end a walk along a crease at the crease.
constexpr double kAlong = 1e-12;
// Triangles crossed by one march, at the most: a walk round and round for ever ends with
// NotConverged.
constexpr long kMaxCrossings = 20'000'000;
// Crossings without progress in a row, as around a vertex; more of them mean a broken triangle.
constexpr int kMaxTurns = 10'000;

// The walk, laid out flat: a half-edge from `u` to `v` that bounds the present triangle, the place
// on it and the direction in the triangle's plane, along and across (inwards) the half-edge.
struct Walk {
  HalfEdge edge = kNoHalfEdge;
  double place = 0;
  Vec2 direction{1, 0};
};

// A triangle laid out with the origin of half-edge h at (0,0) and its tip at (length,0).
struct FlatTriangle {
  Vec3 u, along, across;  // unit axes of the triangle's plane, in space
  double length = 0;
  Vec2 apex{0};

  FlatTriangle(const TriMesh& mesh, HalfEdge h) {
    u = mesh.positions[origin(mesh, h)];
    const Vec3 e = mesh.positions[origin(mesh, next_in_face(h))] - u;
    const Vec3 a = mesh.positions[origin(mesh, prev_in_face(h))] - u;
    length = glm::length(e);
    along = length > 0 ? e / length : Vec3(0);
    apex.x = glm::dot(a, along);
    const Vec3 out = a - apex.x * along;
    apex.y = glm::length(out);
    across = apex.y > 0 ? out / apex.y : Vec3(0);
  }
  bool degenerate() const { return !(length > 0 && apex.y > 0); }
};

// Where a ray leaves a triangle: after which length, through which half-edge, how far along that.
struct Exit {
  double t = 0;
  HalfEdge edge = kNoHalfEdge;
  double place = 0;
  Vec2 direction{1, 0};  // along the edge left through, and outwards across it
  bool found = false;
};

Exit leave_through(HalfEdge edge, Vec2 from, Vec2 to, Vec2 p, Vec2 d) {
  Exit exit;
  const Vec2 e = to - from;
  const double length = glm::length(e);
  const double across = cross2(d, e);
  if (!(across > kAlong * length)) return exit;
  exit.found = true;
  exit.edge = edge;
  exit.t = std::max(0.0, cross2(from - p, e) / across);
  exit.place = std::clamp(cross2(from - p, d) / across, 0.0, 1.0) * length;
  exit.direction = {glm::dot(d, e) / length, across / length};
  // Rounding turns the direction by 1e-16 a triangle; a first-order correction keeps it a unit.
  exit.direction *= 1.5 - 0.5 * glm::dot(exit.direction, exit.direction);
  return exit;
}

// The ray from a point ON the half-edge, pointing inwards: it leaves by one of the other two edges.
Exit leave(const FlatTriangle& tri, const Walk& walk) {
  const Vec2 p(walk.place, 0), d = walk.direction, v(tri.length, 0);
  const bool left = cross2(d, tri.apex - p) >= 0;  // the apex lies left of the ray
  const HalfEdge next = next_in_face(walk.edge), prev = prev_in_face(walk.edge);
  const Exit exit =
      left ? leave_through(next, v, tri.apex, p, d) : leave_through(prev, tri.apex, Vec2(0), p, d);
  if (exit.found) return exit;
  return left ? leave_through(prev, tri.apex, Vec2(0), p, d)
              : leave_through(next, v, tri.apex, p, d);
}

// The ray from a point anywhere in the triangle with barycentric coordinates `b`.
Exit leave_from_inside(HalfEdge first, const FlatTriangle& tri, Vec3 b, Vec2 p, Vec2 d) {
  const Vec2 corner[3] = {Vec2(0), Vec2(tri.length, 0), tri.apex};
  Exit best;
  for (int k = 0; k < 3; ++k) {
    Exit exit = leave_through(first + k, corner[k], corner[(k + 1) % 3], p, d);
    if (!exit.found) continue;
    if (b[(k + 2) % 3] <= 0) exit.t = 0;  // on this very edge
    const bool turns_out_more = exit.t == best.t && exit.direction.y > best.direction.y;
    if (!best.found || exit.t < best.t || turns_out_more) best = exit;
  }
  return best;
}

Vec3 barycentric(const FlatTriangle& tri, Vec2 p) {
  const double w = p.y / tri.apex.y, v = (p.x - w * tri.apex.x) / tri.length;
  Vec3 b = glm::max(Vec3(1 - v - w, v, w), Vec3(0));
  return b / (b.x + b.y + b.z);
}

}  // namespace

MarchStep MeshSurface::march(const SurfacePoint& from, Vec3 tangent, double length) const {
  const TriMesh& mesh = proxy_.mesh;
  MarchStep step;
  step.end = from;
  HalfEdge first = static_cast<HalfEdge>(3 * from.triangle);
  // The end in the triangle of half-edge `h`, whose corners are those of the layout in cyclic
  // order.
  const auto finish = [&](HalfEdge h, const FlatTriangle& tri, Vec2 p, Vec2 d, MarchStop stop) {
    const Vec3 b = barycentric(tri, p);
    Vec3 bary;
    for (int k = 0; k < 3; ++k) bary[(h + k) % 3] = b[k];
    step.end = lift({face_of(h), bary});
    step.direction = tri.along * d.x + tri.across * d.y;
    step.stop = stop;
    return step;
  };

  FlatTriangle tri(mesh, first);
  Vec2 d(glm::dot(tangent, tri.along), glm::dot(tangent, tri.across));
  const double size = glm::length(d);
  // A tangent within 1e-9 radians of the normal has no direction in the plane.
  if (tri.degenerate() || !(size > 1e-9 * glm::length(tangent))) {
    step.stop = MarchStop::Singular;
    return step;
  }
  d /= size;
  Vec3 b = glm::max(from.coords, Vec3(0));
  b /= b.x + b.y + b.z;
  Vec2 p(b.y * tri.length + b.z * tri.apex.x, b.z * tri.apex.y);
  Exit exit = leave_from_inside(first, tri, b, p, d);
  HalfEdge entered = first;
  int turns = 0;
  for (long crossings = 0;; ++crossings) {
    const double rest = length - step.length;
    if (!exit.found) return finish(entered, tri, p, d, MarchStop::Singular);
    if (exit.t >= rest) {
      step.length = std::max(length, 0.0);
      return finish(entered, tri, p + std::max(rest, 0.0) * d, d, MarchStop::Completed);
    }
    step.length += exit.t;
    p += exit.t * d;
    turns = exit.t > 0 ? 0 : turns + 1;
    const HalfEdge other = proxy_.topology.opposite[static_cast<std::size_t>(exit.edge)];
    const EdgeKind kind = proxy_.edge_kind[static_cast<std::size_t>(exit.edge)];
    if (kind != EdgeKind::Smooth) {
      finish(entered, tri, p, d,
             kind == EdgeKind::Boundary ? MarchStop::Boundary : MarchStop::Crease);
      // Exactly on the edge, so that a walk that goes on outwards comes no step further.
      Vec3& b_end = step.end.coords;
      b_end[(exit.edge + 2) % 3] = 0;
      b_end /= b_end.x + b_end.y + b_end.z;
      return step;
    }
    if (crossings >= kMaxCrossings || turns > kMaxTurns) {
      return finish(entered, tri, p, d, MarchStop::NotConverged);
    }
    const FlatTriangle next(mesh, other);
    if (next.degenerate()) return finish(entered, tri, p, d, MarchStop::Singular);
    // Unfolded over the edge, which the neighbour runs along the other way.
    tri = next;
    entered = other;
    const Walk walk{other, tri.length - exit.place, {-exit.direction.x, exit.direction.y}};
    p = {walk.place, 0};
    d = walk.direction;
    exit = leave(tri, walk);
  }
}

}  // namespace burin
