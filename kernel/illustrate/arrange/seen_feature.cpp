#include "seen_feature.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin::detail {
namespace {

constexpr std::size_t kRays = 24;

/// Whether a ray from a place meets a triangle before it gets away.
bool is_met(const TriMesh& mesh, std::uint32_t triangle, Vec3 from, Vec3 way) {
  const Triangle& t = mesh.triangles[triangle];
  const Vec3 a = mesh.positions[t[0]] - from, b = mesh.positions[t[1]] - from,
             c = mesh.positions[t[2]] - from;
  // The signs of the volumes with the three sides.
  const double u = glm::dot(glm::cross(a, b), way), v = glm::dot(glm::cross(b, c), way),
               w = glm::dot(glm::cross(c, a), way);
  if (!((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))) return false;
  const Vec3 normal = glm::cross(b - a, c - a);
  return glm::dot(a, normal) * glm::dot(way, normal) > 0;
}

/// A place just off the surface, and whether what is there is turned to the viewer.
struct Place {
  Vec3 at{0};
  Vec3 normal{0};
};

Place off_middle(const TriMesh& mesh, std::uint32_t triangle, double off) {
  const Triangle& t = mesh.triangles[triangle];
  const Vec3 normal = mesh.normal(triangle);
  return {(mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0 + off * normal,
          normal};
}

/// Off a face at its middles; off an edge on the side to which both of its faces turn.
std::vector<Place> places_of(const ProxyMesh& proxy, const Feature& feature, FeatureRow::Kind kind,
                             double off) {
  const TriMesh& mesh = proxy.mesh;
  std::vector<Place> out;
  if (kind == FeatureRow::Kind::Face) {
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      if (!proxy.is_cut(i) && proxy.face_source(i) == feature.number) {
        out.push_back(off_middle(mesh, i, off));
      }
    }
    return out;
  }
  for (HalfEdge h = 0; h < static_cast<HalfEdge>(proxy.source_edge.size()); ++h) {
    if (proxy.source_edge[static_cast<std::size_t>(h)] != feature.number) continue;
    const HalfEdge other = proxy.topology.opposite[static_cast<std::size_t>(h)];
    const Vec3 own = mesh.normal(face_of(h)),
               both = own + (other == kNoHalfEdge ? Vec3(0) : mesh.normal(face_of(other)));
    const Vec3 middle =
        0.5 * (mesh.positions[origin(mesh, h)] + mesh.positions[origin(mesh, next_in_face(h))]);
    out.push_back({middle + off * normalize_or(both, own), own});
  }
  return out;
}

}  // namespace

bool shows_place(const Surface& surface, Vec3 place, Vec3 to_viewer) {
  const TriMesh& mesh = surface.proxy().mesh;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (is_met(mesh, i, place, to_viewer)) return false;
  }
  return true;
}

bool shows_feature(const Surface& surface, const Feature& feature, FeatureRow::Kind kind,
                   Vec3 to_viewer) {
  if (kind == FeatureRow::Kind::Point) return true;
  const ProxyMesh& proxy = surface.proxy();
  const TriMesh& mesh = proxy.mesh;
  // Off the face by more than its triangles are off the surface.
  const double off = 1e-3 * mesh.bounds().diagonal();
  constexpr double kTurnedAway = -1e-6;  // cosine: faces that are seen from their edge count
  const std::vector<Place> places = places_of(proxy, feature, kind, off);
  const std::size_t step = std::max<std::size_t>(1, places.size() / kRays);
  for (std::size_t k = 0; k < places.size(); k += step) {
    if (glm::dot(places[k].normal, to_viewer) < kTurnedAway) continue;
    if (shows_place(surface, places[k].at, to_viewer)) return true;
  }
  return false;
}

}  // namespace burin::detail
