#include "places_of_feature.h"

#include <algorithm>

namespace burin::detail {
namespace {

/// Of a face or an edge: every so many places that there are still as many.
constexpr std::size_t kPlaces = 512;
/// Cosine: faces that are seen from their edge count.
constexpr double kEdgeOn = -1e-6;

SampledPlace middle_of(const TriMesh& mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return {(mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0,
          mesh.normal(triangle)};
}

/// Share of the way from the border of a triangle to its middle.
constexpr double kIn = 0.05;

/// In a triangle beside one of its edges: an edge is seen where a face is seen that ends at it.
SampledPlace beside_edge(const TriMesh& mesh, HalfEdge h) {
  SampledPlace place = middle_of(mesh, face_of(h));
  const Vec3 edge =
      0.5 * (mesh.positions[origin(mesh, h)] + mesh.positions[origin(mesh, next_in_face(h))]);
  place.on_edge = edge;
  place.at = glm::mix(edge, place.at, kIn);
  return place;
}

/// In the corners of a triangle and beside its edges: of a wall all but a corner may be hidden.
void add_border_of(const TriMesh& mesh, std::uint32_t triangle, std::vector<SampledPlace>& out) {
  const SampledPlace middle = middle_of(mesh, triangle);
  for (int k = 0; k < 3; ++k) {
    const HalfEdge h = static_cast<HalfEdge>(3 * triangle) + k;
    out.push_back(beside_edge(mesh, h));
    out.push_back({glm::mix(mesh.positions[origin(mesh, h)], middle.at, kIn), middle.normal});
  }
}

/// Of a face its triangles, and what a section cut open at its borders; of a plane that is seen
/// from behind what is turned to the viewer beyond its borders.
std::vector<SampledPlace> places_of_face(const ProxyMesh& proxy, const Feature& feature,
                                         Vec3 to_viewer) {
  std::vector<SampledPlace> out;
  const bool from_behind =
      feature.kind == FeatureKind::Plane && glm::dot(feature.along, to_viewer) < kEdgeOn;
  const auto is_of_it = [&](std::uint32_t i) {
    return !proxy.is_cut(i) && proxy.face_source(i) == feature.number;
  };
  const auto add_beyond = [&](HalfEdge h) {
    const HalfEdge opposite = proxy.topology.opposite[static_cast<std::size_t>(h)];
    if (opposite == kNoHalfEdge || is_of_it(face_of(opposite))) return;
    const SampledPlace place = beside_edge(proxy.mesh, opposite);
    const bool turned_to = from_behind && glm::dot(place.normal, to_viewer) > -kEdgeOn;
    if (turned_to || proxy.is_cut(face_of(opposite))) out.push_back(place);
  };
  for (std::uint32_t i = 0; i < proxy.mesh.triangles.size(); ++i) {
    if (!is_of_it(i)) continue;
    out.push_back(middle_of(proxy.mesh, i));
    if (feature.kind == FeatureKind::Plane) add_border_of(proxy.mesh, i, out);
    for (int corner = 0; corner < 3; ++corner) {
      add_beyond(static_cast<HalfEdge>(3 * i) + corner);
    }
  }
  return out;
}

}  // namespace

bool is_of_feature(const ProxyMesh& proxy, std::uint32_t triangle, const SeenFeature& seen) {
  if (seen.kind == FeatureRow::Kind::Part) return true;
  return !proxy.is_cut(triangle) && proxy.face_source(triangle) == seen.feature.number;
}

namespace {

std::vector<SampledPlace> places_of(const SeenFeature& seen, Vec3 to_viewer) {
  const ProxyMesh& proxy = seen.surface.proxy();
  if (seen.kind == FeatureRow::Kind::Face) return places_of_face(proxy, seen.feature, to_viewer);
  std::vector<SampledPlace> out;
  if (seen.kind == FeatureRow::Kind::Part) {
    for (std::uint32_t i = 0; i < proxy.mesh.triangles.size(); ++i) {
      out.push_back(middle_of(proxy.mesh, i));
    }
    return out;
  }
  for (HalfEdge h = 0; h < static_cast<HalfEdge>(proxy.source_edge.size()); ++h) {
    if (proxy.source_edge[static_cast<std::size_t>(h)] != seen.feature.number) continue;
    out.push_back(beside_edge(proxy.mesh, h));
  }
  return out;
}

}  // namespace

std::vector<SampledPlace> sampled_places(const SeenFeature& seen, Vec3 to_viewer) {
  const std::vector<SampledPlace> places = places_of(seen, to_viewer);
  const std::size_t step = std::max<std::size_t>(1, places.size() / kPlaces);
  std::vector<SampledPlace> out;
  for (std::size_t k = 0; k < places.size(); k += step) {
    if (glm::dot(places[k].normal, to_viewer) >= kEdgeOn) out.push_back(places[k]);
  }
  return out;
}

}  // namespace burin::detail
