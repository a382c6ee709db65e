#pragma once
/// A ChartMesh while it is built.

#include <burin/forms/charted/atlas.h>

namespace burin {

struct RawMesh {
  ChartMesh mesh;
  /// For each half-edge: 1 where every u gives the same point at its origin, a pole of the face; 2
  /// where every v does; else 0. The corner's own u is then that of the middle of its triangle.
  std::vector<std::uint8_t> pole;

  /// (u,v) at the share s of a half-edge: the edge itself on model edges (`t` runs from t0 to t1),
  /// along the meridian next to poles.
  Vec2 on_edge(const Atlas& atlas, std::size_t half_edge, double s) const;
};

}  // namespace burin
