#pragma once
// Flat walls among the facets that stand for no round surface; internal to the module.

#include <burin/mesh/proxy_mesh.h>

#include "recognise.h"

#include <cstdint>
#include <vector>

namespace burin::recognised {

/// A wall is a facet that is much wider than the facets that it meets at a small angle: it is a
/// plane of its own, not a facet of something that bends. Where there is no round face, so that all
/// facets are known to be flat, two or three that meet so are walls as well.
class Walls {
 public:
  /// `proxy` is what MeshForm makes of the input: its smooth edges are the small angles.
  Walls(const ProxyMesh& proxy, const Facets& facets, const Recognised& round);

  bool is_wall(std::int32_t facet) const { return wall_[static_cast<std::size_t>(facet)] != 0; }
  /// Whether a facet meets others than walls at a small angle: it is part of a rounding; a facet
  /// that does not is a cut across a corner, flat itself.
  bool goes_on(std::int32_t facet) const { return bends_[static_cast<std::size_t>(facet)] != 0; }

 private:
  std::vector<std::uint8_t> wall_, bends_;
};

}  // namespace burin::recognised
