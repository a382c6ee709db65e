#pragma once
/// Vertices where the surface has no one normal: tips of cones and of fans of facets. There the
/// corners of a vertex have wedges of their own although smooth edges connect them.

#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Whether both triangles at a smooth edge have one wedge at the origin of `h`; they have not where
/// that is a tip.
inline bool one_wedge_at(const ProxyMesh& proxy, HalfEdge h) {
  const HalfEdge beyond = next_in_face(proxy.topology.opposite[static_cast<std::size_t>(h)]);
  return proxy.wedges[face_of(h)][static_cast<std::size_t>(h % 3)] ==
         proxy.wedges[face_of(beyond)][static_cast<std::size_t>(beyond % 3)];
}

/// For each wedge whether it is one of several at a tip; empty where there is no tip. Cost: a pass
/// over the corners at creases.
std::vector<std::uint8_t> wedges_at_tips(const ProxyMesh& proxy);

/// The corner of a triangle with two tips that is none, else nothing. Such a triangle is a flat
/// face between the fans from both: its third corner has its normal.
std::optional<std::size_t> corner_beside_tips(std::span<const std::uint8_t> tips,
                                              const Triangle& wedges);

/// Gives the corners of a wedge a wedge for each of their labels (one a half-edge), with the mean
/// of what `corner_normal` says of them, by length. Wedges of one label keep their normals; all are
/// numbered anew, by their vertices. For proxies that were cut for no view. Cost: 30 ms a million
/// triangles.
void part_wedges(ProxyMesh& proxy, std::span<const std::uint32_t> label,
                 const std::function<Vec3(HalfEdge)>& corner_normal);

}  // namespace burin
