#include "probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

// Multiples of the occluder's resolution: distance from a plane within which a point lies on it.
// Covers vertices that went through single precision (STL) once in each part.
constexpr double kOnPlane = 4;
// Steps from triangle to triangle over smooth edges: the patch around a point on a fold, two rings
// of vertices wide.
constexpr int kFoldSteps = 4;
// Edges of both triangles within which a fold can lie in front of its own contour: its polygons and
// its contour, which runs where interpolated normals turn away, differ by about an edge along the
// line of sight.
constexpr double kFoldReach = 2;

// What a hit is judged by.
struct Origin {
  const Probe* probe;
  Vec3 point;
  std::int32_t part, face;
  double on_plane, error;
  // On a fold: a contour, or a point whose polygon faces away though its surface does not.
  bool fold;
};

double plane_distance(const TriMesh& mesh, std::uint32_t face, Vec3 p) {
  const Triangle& t = mesh.triangles[face];
  const Vec3 a = mesh.positions[t[0]];
  const Vec3 n = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
  const double length = glm::length(n);
  return length > 0 ? std::abs(glm::dot(n, p - a)) / length : 0;
}

double longest_edge(const TriMesh& mesh, std::uint32_t face) {
  double longest = 0;
  const Triangle& t = mesh.triangles[face];
  for (std::size_t i = 0; i < 3; ++i) {
    longest =
        std::max(longest, glm::distance(mesh.positions[t[i]], mesh.positions[t[(i + 1) % 3]]));
  }
  return longest;
}

// Whether `to` is among the triangles within kFoldSteps of `from`.
bool near_on_surface(const ProxyMesh& proxy, std::uint32_t from, std::uint32_t to) {
  std::array<std::uint32_t, 64> seen;  // steps 1 to 4 reach at most 3 + 6 + 12 + 24 others
  std::size_t count = 0, begin = 0;
  seen[count++] = from;
  for (int step = 0; step < kFoldSteps; ++step) {
    const std::size_t end = count;
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t h = 3 * std::size_t{seen[i]} + k;
        if (proxy.edge_kind[h] != EdgeKind::Smooth) continue;
        const std::uint32_t next = face_of(proxy.topology.opposite[h]);
        if (next == to) return true;
        if (std::find(seen.begin(), seen.begin() + count, next) == seen.begin() + count) {
          seen[count++] = next;
        }
      }
    }
    begin = end;
  }
  return false;
}

bool hides(const Origin& o, const Hit& hit) {
  const bool own_part = hit.where.part == o.part && o.face >= 0;
  if (own_part && static_cast<std::int32_t>(hit.where.face) == o.face) return false;
  const ProxyMesh& proxy = *o.probe->proxy(hit.where.part);
  const double distance = plane_distance(proxy.mesh, hit.where.face, o.point);
  const double error =
      o.probe->chord_error(hit.where.part, static_cast<std::int32_t>(hit.where.face));
  if (distance <= o.on_plane + o.error + error) return false;
  if (!own_part || !o.fold) return true;
  const auto own = static_cast<std::uint32_t>(o.face);
  const double reach =
      kFoldReach * (longest_edge(proxy.mesh, own) + longest_edge(proxy.mesh, hit.where.face));
  return hit.distance > reach || !near_on_surface(proxy, own, hit.where.face);
}

bool on_fold(const Curve3& curve, const ProxyMesh* proxy, std::int32_t face, Vec3 view) {
  if (!proxy || face < 0 || proxy->edge_kind.empty()) return false;
  if (curve.kind == LineClass::Contour) return true;
  return (curve.kind == LineClass::Stroke || curve.kind == LineClass::Pattern) &&
         glm::dot(proxy->mesh.normal(static_cast<std::uint32_t>(face)), view) < 0;
}

}  // namespace

const ProxyMesh* Probe::proxy(std::int32_t part) const {
  const auto i = static_cast<std::size_t>(part);
  return part >= 0 && i < proxies_.size() ? proxies_[i] : nullptr;
}

double Probe::chord_error(std::int32_t part, std::int32_t face) const {
  const ProxyMesh* p = proxy(part);
  if (!p || face < 0 || p->wedges.empty()) return 0;
  // k h^2 / 8 of each edge h, where k h^2 / 2 is how far the edge leaves the tangent plane at
  // either end. The smaller of both: what bends at one end only is not bent along the edge. A
  // diagonal of a cylinder's long facet has the sagitta of the facet.
  double largest = 0;
  const Triangle& w = p->wedges[static_cast<std::size_t>(face)];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = w[i], b = w[(i + 1) % 3];
    const Vec3 edge = p->wedge_position(b) - p->wedge_position(a);
    const double at_a = glm::dot(p->wedge_normal[a], edge),
                 at_b = glm::dot(p->wedge_normal[b], edge);
    if ((at_a < 0) == (at_b > 0))
      largest = std::max(largest, std::min(std::abs(at_a), std::abs(at_b)));
  }
  return largest / 4;
}

bool Probe::visible(const Curve3& curve, std::size_t segment, double t) const {
  const std::size_t after = curve.next(segment);
  const Vec3 p = glm::mix(curve.points[segment], curve.points[after], t);
  const Vec3 view = camera_.to_viewer(p);
  const std::int32_t face = curve.faces.empty() ? -1 : curve.faces[segment];
  const double resolution = occluder_.resolution();
  const Origin origin{this,
                      p,
                      curve.source.part,
                      face,
                      kOnPlane * resolution,
                      chord_error(curve.source.part, face),
                      on_fold(curve, proxy(curve.source.part), face, view)};
  Vec3 start = p;
  if (!curve.normals.empty()) {
    Vec3 n = normalize_or(glm::mix(curve.normals[segment], curve.normals[after], t), Vec3(0));
    const ProxyMesh* own = proxy(curve.source.part);
    const bool sheet = own && face >= 0 && !own->topology.face_component.empty() &&
                       !own->closed(static_cast<std::uint32_t>(face));
    if (sheet && glm::dot(n, view) < 0) n = -n;  // an open sheet is seen from both sides
    start += n * (origin.error + resolution);
  }
  const Origin* o = &origin;
  return !occluder_.occluded_by(start, view, 2 * resolution, camera_.distance_to_viewer(start),
                                [o](const Hit& hit) { return hides(*o, hit); });
}

bool Probe::paper_covered(Vec2 paper) const {
  ViewRay ray = camera_.ray(paper);
  if (!camera_.perspective()) {
    ray.origin -= ray.direction * (2 * occluder_.diagonal() + occluder_.resolution());
  }
  return occluder_.occluded(ray.origin, ray.direction, 0, std::numeric_limits<double>::infinity());
}

}  // namespace burin
