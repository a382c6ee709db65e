#pragma once
/// A ChartMesh in the making.

#include <burin/forms/parametric/atlas.h>

namespace burin {

struct RawMesh {
  ChartMesh mesh;
  /// For each half-edge: 1 (2) where all u (v) stand for its origin, a pole of the face. The
  /// corner's own u is then that of the middle of its triangle.
  std::vector<std::uint8_t> pole;

  /// (u,v) at the share s of a half-edge: the edge itself on model edges (`t` runs from t0 to t1),
  /// along the meridian next to poles.
  Vec2 on_edge(const Atlas& atlas, std::size_t half_edge, double s) const;
};

}  // namespace burin
