#include <burin/base/nearest_along.h>
#include <burin/measure/feature.h>
#include <burin/mesh/nearest_side.h>
#include <burin/surface/face_samples.h>
#include <burin/surface/turned_faces.h>

#include "fit.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace burin {
namespace {

using detail::Sample;

/// Frames of a face that are asked, about.
constexpr std::size_t kFrames = 100;

std::vector<Vec3> corners_of(const TriMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  std::set<std::uint32_t> vertices;
  for (const std::uint32_t t : triangles) {
    vertices.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
  }
  std::vector<Vec3> out;
  for (const std::uint32_t v : vertices) out.push_back(mesh.positions[v]);
  return out;
}

double distance_to_triangle(const TriMesh& mesh, std::uint32_t triangle, Vec3 p) {
  const Triangle& t = mesh.triangles[triangle];
  const Vec3 n = mesh.normal(triangle);
  bool above = n != Vec3(0);
  for (std::size_t k = 0; k < 3 && above; ++k) {
    const Vec3 a = mesh.positions[t[k]], b = mesh.positions[t[(k + 1) % 3]];
    above = glm::dot(glm::cross(b - a, p - a), n) >= 0;
  }
  if (above) return std::abs(glm::dot(p - mesh.positions[t[0]], n));
  const Vec3 bary = nearest_side(mesh, triangle, p);
  Vec3 nearest(0);
  for (int k = 0; k < 3; ++k) nearest += bary[k] * mesh.positions[t[static_cast<std::size_t>(k)]];
  return glm::distance(p, nearest);
}

/// Whether normals of triangles point to the axis or the centre.
bool is_hollow(const TriMesh& mesh, const std::vector<std::uint32_t>& triangles,
               const Feature& found) {
  double outward = 0;
  for (const std::uint32_t t : triangles) {
    const Triangle& corner = mesh.triangles[t];
    const Vec3 middle =
        (mesh.positions[corner[0]] + mesh.positions[corner[1]] + mesh.positions[corner[2]]) / 3.0;
    Vec3 from = middle - found.point;
    if (found.kind != FeatureKind::Sphere) from = reject(from, found.along);
    outward += mesh.area(t) * glm::dot(from, mesh.normal(t));
  }
  return outward < 0;
}

Feature of_facets(const TriMesh& mesh, const std::vector<std::uint32_t>& triangles,
                  const std::vector<Vec3>& corners) {
  std::vector<Vec3> normals;
  std::vector<Sample> samples;
  for (const std::uint32_t t : triangles) {
    if (!(mesh.area(t) > 0)) continue;
    normals.push_back(mesh.normal(t));
    for (const std::uint32_t v : mesh.triangles[t])
      samples.push_back({mesh.positions[v], normals.back()});
  }
  Feature plane = detail::fit_surface(samples, {detail::kFacetFit.place, 1e-3});
  if (plane.kind == FeatureKind::Plane) {
    // The middle of what is rounded is nearer to the plane than any corner.
    plane.point = Vec3(0);
    for (const Vec3& p : corners) plane.point += p / static_cast<double>(corners.size());
    return plane;
  }
  Feature found = detail::fit_facets(corners, normals);
  if (found.kind != FeatureKind::Other) found.hollow = is_hollow(mesh, triangles, found);
  return found;
}

void set_extent(const ProxyMesh& proxy, const std::vector<std::uint32_t>& triangles, Feature& out) {
  if (!out.has_axis() && out.kind != FeatureKind::Sphere) return;
  const TurnedExtent extent = extent_about({out.point, out.along}, proxy, triangles);
  out.turn = static_cast<double>(extent.turn.count());
  out.low = extent.low;
  out.high = extent.high;
  if (out.kind == FeatureKind::Cone || out.kind == FeatureKind::Turned) out.radius = extent.radius;
}

/// Half-edges of an edge of the model; each pair of both sides once.
std::vector<HalfEdge> half_edges_of(const ProxyMesh& proxy, std::int32_t number) {
  std::vector<HalfEdge> out;
  for (HalfEdge h = 0; h < static_cast<HalfEdge>(proxy.source_edge.size()); ++h) {
    if (proxy.source_edge[static_cast<std::size_t>(h)] != number) continue;
    const HalfEdge other = proxy.topology.opposite[static_cast<std::size_t>(h)];
    if (other != kNoHalfEdge && other < h) continue;
    out.push_back(h);
  }
  return out;
}

std::pair<Vec3, Vec3> ends_of(const ProxyMesh& proxy, HalfEdge h) {
  return {proxy.mesh.positions[origin(proxy.mesh, h)],
          proxy.mesh.positions[origin(proxy.mesh, next_in_face(h))]};
}

}  // namespace

const char* to_string(FeatureKind kind) {
  constexpr std::array<const char*, 10> kNames{
      "a point",    "a straight edge", "a round edge",
      "a plane",    "a cylinder",      "a cone",
      "a sphere",   "a torus",         "a surface of revolution",
      "a free form"};
  return kNames[static_cast<std::size_t>(kind)];
}

Feature point_feature(Vec3 point) {
  Feature out;
  out.kind = FeatureKind::Point;
  out.point = point;
  out.points = {point};
  return out;
}

std::optional<Feature> face_feature(const Surface& surface, std::int32_t number,
                                    const RunContext& context) {
  const auto faces = triangles_of_faces(surface.proxy());
  const auto face = faces.find(number);
  if (face == faces.end()) return std::nullopt;
  return detail::feature_of(surface, number, face->second, context);
}

Feature detail::feature_of(const Surface& surface, std::int32_t number,
                           const std::vector<std::uint32_t>& triangles, const RunContext& context) {
  const ProxyMesh& proxy = surface.proxy();
  context.check();
  const std::vector<Sample> samples = face_samples(surface, triangles, kFrames);
  const std::vector<Vec3> corners = corners_of(proxy.mesh, triangles);
  Feature out = detail::fit_surface(samples, detail::kExactFit);
  if (out.kind == FeatureKind::Other && !surface.exact()) {
    out = of_facets(proxy.mesh, triangles, corners);
  }
  if (out.kind == FeatureKind::Other) {
    if (const auto turned = turned_face(surface, triangles)) {
      const auto torus =
          detail::fit_torus(samples, turned->axis.point, turned->axis.along, detail::kExactFit);
      out.kind = turned->sphere ? FeatureKind::Other : FeatureKind::Turned;
      out.point = turned->axis.point;
      out.along = turned->axis.along;
      out.hollow = turned->hollow;
      if (torus && !turned->sphere) out = *torus;
    }
  }
  out.number = number;
  set_extent(proxy, triangles, out);
  out.points = corners;
  for (const std::uint32_t t : triangles) out.size += proxy.mesh.area(t);
  return out;
}

std::optional<Feature> edge_feature(const Surface& surface, std::int32_t number) {
  const ProxyMesh& proxy = surface.proxy();
  const std::vector<HalfEdge> halves = half_edges_of(proxy, number);
  if (number < 0 || halves.empty()) return std::nullopt;
  std::set<std::uint32_t> vertices;
  double length = 0;
  for (const HalfEdge h : halves) {
    vertices.insert(origin(proxy.mesh, h));
    vertices.insert(origin(proxy.mesh, next_in_face(h)));
    const auto [a, b] = ends_of(proxy, h);
    length += glm::distance(a, b);
  }
  std::vector<Vec3> points;
  for (const std::uint32_t v : vertices) points.push_back(proxy.mesh.positions[v]);
  Feature out = detail::fit_edge(points);
  out.number = number;
  out.size = length;
  out.points = std::move(points);
  if (out.kind == FeatureKind::Circle) {
    // Of the arcs over the chords.
    double turn = 0;
    for (const HalfEdge h : halves) {
      const auto [a, b] = ends_of(proxy, h);
      turn += 2 * std::asin(std::min(1.0, 0.5 * glm::distance(a, b) / out.radius));
    }
    out.turn = glm::degrees(turn);
    out.size = turn * out.radius;
  }
  return out;
}

NearFeature nearest_face(const Surface& surface, Vec3 to) {
  const ProxyMesh& proxy = surface.proxy();
  NearFeature best{-1, std::numeric_limits<double>::infinity()};
  for (std::uint32_t t = 0; t < proxy.mesh.triangles.size(); ++t) {
    if (proxy.is_cut(t)) continue;
    const double distance = distance_to_triangle(proxy.mesh, t, to);
    if (distance < best.distance) best = {proxy.face_source(t), distance};
  }
  return best;
}

NearFeature nearest_edge(const Surface& surface, Vec3 to) {
  const ProxyMesh& proxy = surface.proxy();
  NearFeature best{-1, std::numeric_limits<double>::infinity()};
  for (HalfEdge h = 0; h < static_cast<HalfEdge>(proxy.source_edge.size()); ++h) {
    if (proxy.source_edge[static_cast<std::size_t>(h)] < 0) continue;
    const auto [a, b] = ends_of(proxy, h);
    const double distance = distance_to_segment(a, b, to);
    if (distance < best.distance) {
      best = {proxy.source_edge[static_cast<std::size_t>(h)], distance};
    }
  }
  return best;
}

}  // namespace burin
