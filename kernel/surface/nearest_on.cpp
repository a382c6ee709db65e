#include <burin/surface/nearest_on.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

// Steps of the method of Gauss and Newton. A chord is so much nearer to its surface than the
// surface bends that two do; more are for charts of which (u,v) run unevenly.
constexpr int kMostSteps = 6;
// Of the tolerance: so near the point is the place, as it is on planes.
constexpr double kSame = 1e-3;
// Of a triangle: a step that is shorter is the last one.
constexpr double kShort = 1e-3;
// Of a triangle: over that much of it the derivatives of `lift` are taken.
constexpr double kBeside = 0.01;
// How far beyond its triangle a place may be, in its sizes. The nearest one lies in it or next to
// it, so what is farther was led astray, as by the triangles of a fold.
constexpr double kFarthest = 1;
// Square of the sine between two directions that are one: a chart ends there in a point.
constexpr double kOneDirection = 1e-12;

/// The step in barycentric coordinates that takes `at` to the place of the tangent plane nearest to
/// `target`; nothing where there is no such plane.
std::optional<Vec3> step_to(const Surface& surface, const ProxyPoint& place, Vec3 at, Vec3 target) {
  const Vec3 first(-1, 1, 0), second(-1, 0, 1);
  const auto along = [&](Vec3 way) {
    return (surface.lift({place.face, place.bary + kBeside * way}).position - at) / kBeside;
  };
  const Vec3 u = along(first), v = along(second), to = target - at;
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v);
  const double det = uu * vv - uv * uv;
  if (!(det > kOneDirection * uu * vv)) return std::nullopt;
  const double tu = glm::dot(to, u), tv = glm::dot(to, v);
  return ((tu * vv - tv * uv) * first + (tv * uu - tu * uv) * second) / det;
}

}  // namespace

SurfacePoint nearest_on(const Surface& surface, const ProxyPoint& place) {
  const ProxyMesh& proxy = surface.proxy();
  const Vec3 target = proxy.position(place.face, place.bary);
  const auto off = [&](const SurfacePoint& p) { return glm::distance(p.position, target); };
  ProxyPoint there = place;
  SurfacePoint best = surface.lift(there);
  for (int i = 0; i < kMostSteps && off(best) > kSame * proxy.tolerance; ++i) {
    const auto step = step_to(surface, there, best.position, target);
    if (!step) break;
    there.bary += *step;
    const Vec3& b = there.bary;
    if (!(std::min({b.x, b.y, b.z}) >= -kFarthest)) break;
    const SurfacePoint next = surface.lift(there);
    if (!(off(next) < off(best))) break;
    best = next;
    if (std::max({std::abs(step->x), std::abs(step->y), std::abs(step->z)}) < kShort) break;
  }
  return best;
}

}  // namespace burin
