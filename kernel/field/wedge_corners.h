#pragma once
/// The corners of every wedge.

#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burin::field {

/// The corners of a wedge as half-edges that start there, ascending.
struct WedgeCorners {
  std::vector<std::uint32_t> first;
  std::vector<HalfEdge> corner;

  explicit WedgeCorners(const ProxyMesh& proxy);
  std::span<const HalfEdge> of(std::size_t wedge) const {
    return {corner.data() + first[wedge], corner.data() + first[wedge + 1]};
  }
};

}  // namespace burin::field
