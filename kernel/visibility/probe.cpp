#include "probe.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

// Multiples of the occluder's resolution: distance from a plane within which a point lies on it.
// Covers vertices that went through single precision (STL) once in each part.
constexpr double kOnPlane = 4;
// Multiples of the chord error within which the ring of triangles around a point on a fold lies in
// front of it: the ring reaches 1.5 edges far, so its planes pass at most k (1.5 h)^2 / 2 = 9 (k
// h^2 / 8) from the point.
constexpr double kFoldDepth = 9;

// What a hit is judged by.
struct Origin {
  const Probe* probe;
  Vec3 point;
  std::int32_t part, face;
  double on_plane, error;
};

bool share_corner(const Triangle& a, const Triangle& b) {
  for (const std::uint32_t i : a) {
    if (std::find(b.begin(), b.end(), i) != b.end()) return true;
  }
  return false;
}

double plane_distance(const TriMesh& mesh, std::uint32_t face, Vec3 p) {
  const Triangle& t = mesh.triangles[face];
  const Vec3 a = mesh.positions[t[0]];
  const Vec3 n = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
  const double length = glm::length(n);
  return length > 0 ? std::abs(glm::dot(n, p - a)) / length : 0;
}

bool hides(const Origin& o, const Hit& hit) {
  const bool own_part = hit.where.part == o.part && o.face >= 0;
  if (own_part && static_cast<std::int32_t>(hit.where.face) == o.face) return false;
  const ProxyMesh& proxy = *o.probe->proxy(hit.where.part);
  const double distance = plane_distance(proxy.mesh, hit.where.face, o.point);
  const double error =
      o.probe->chord_error(hit.where.part, static_cast<std::int32_t>(hit.where.face));
  if (distance <= o.on_plane + o.error + error) return false;
  return !own_part || distance > o.on_plane + kFoldDepth * std::max(o.error, error) ||
         !share_corner(proxy.mesh.triangles[hit.where.face],
                       proxy.mesh.triangles[static_cast<std::size_t>(o.face)]);
}

}  // namespace

const ProxyMesh* Probe::proxy(std::int32_t part) const {
  const auto i = static_cast<std::size_t>(part);
  return part >= 0 && i < proxies_.size() ? proxies_[i] : nullptr;
}

double Probe::chord_error(std::int32_t part, std::int32_t face) const {
  const ProxyMesh* p = proxy(part);
  if (!p || face < 0 || p->wedge_sagitta.empty()) return 0;
  double largest = 0;
  for (const std::uint32_t w : p->wedges[static_cast<std::size_t>(face)]) {
    largest = std::max(largest, static_cast<double>(p->wedge_sagitta[w]));
  }
  return largest;
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
                      chord_error(curve.source.part, face)};
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
