#pragma once
// The phase whose level lines are the strokes.

#include "wave_graph.h"

namespace burin::detail {

/// Where the phase of a node is known from outside: lines that begin half a gap from an edge.
struct WaveAnchor {
  std::uint32_t node = 0;
  double phase = 0;  // radians
};

struct WavePhase {
  std::vector<double> at;       // of each node, in [0, 2 pi)
  std::vector<double> advance;  // along each link from a to b, radians; many turns are allowed
};

/// Radians that the phase is to grow by along a link.
double turn_along(const WaveGraph& graph, const WaveLink& link);

/// Unit numbers psi at the nodes that are nearly carried into each other along the links,
/// psi_b = e^(i omega) psi_a, and nearly what the anchors say: by local sweeps from the coarsest of
/// ever coarser graphs to the finest. The same for any number of threads. Cost: linear, some 50
/// passes over the links.
/// @cite Knoeppel2015, Jakob2015
WavePhase solve_phase(const WaveGraph& graph, const std::vector<WaveAnchor>& anchors,
                      const RunContext& context);

}  // namespace burin::detail
