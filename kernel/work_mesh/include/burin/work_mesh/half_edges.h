#pragma once
/// Opposite half-edges of triangles that are known to be manifold.

#include <burin/mesh/topology.h>

#include <array>
#include <vector>

namespace burin {

/// For each half-edge the opposite one or kNoHalfEdge. Where an edge has more than two triangles,
/// or two turned alike, all of them get none. Cost: 30 ns per triangle (build_topology: 150 ns, but
/// it checks).
std::vector<HalfEdge> pair_half_edges(const std::vector<Triangle>& triangles,
                                      std::size_t vertex_count);

/// A side of the two triangles whose edge was flipped.
struct FlippedSide {
  HalfEdge at;
  /// Which side it was before; kNoHalfEdge: it is the new edge.
  HalfEdge side;
  /// A half-edge that began at its origin before.
  HalfEdge corner;
};

/// Flips the edge of h: the triangles (a,b,c) at h and (b,a,d) beyond become (a,d,c) and (d,b,c).
/// The triangles have no other edge in common, and no edge joins c and d.
std::array<FlippedSide, 6> flip_edge(std::vector<Triangle>& triangles,
                                     std::vector<HalfEdge>& opposite, HalfEdge h);

/// Moves what half-edges carry where an edge was flipped: by `FlippedSide::side` what is of a side,
/// of which the new edge has `fresh`, by `FlippedSide::corner` what is of a corner.
template <class T>
void carry(const std::array<FlippedSide, 6>& flipped, HalfEdge FlippedSide::*by,
           std::vector<T>& values, const T& fresh = {}) {
  std::array<T, 6> moved;
  for (std::size_t k = 0; k < 6; ++k) {
    const HalfEdge from = flipped[k].*by;
    moved[k] = from == kNoHalfEdge ? fresh : values[static_cast<std::size_t>(from)];
  }
  for (std::size_t k = 0; k < 6; ++k) values[static_cast<std::size_t>(flipped[k].at)] = moved[k];
}

}  // namespace burin
