#pragma once
/// The wedges of the curved part of a proxy mesh as a graph with parallel transport along its
/// links.

#include <burin/base/run_context.h>
#include <burin/mesh/proxy_mesh.h>

#include "links.h"

#include <cstdint>
#include <vector>

namespace burin::field {

struct WedgeGraph {
  /// The links of crosses (directions to the fourth power in each wedge's TangentBasis). Wedges of
  /// flat parts alone have no links.
  Links<Vec2> crosses;
  /// For each wedge the x axis of its TangentBasis.
  std::vector<Vec3> axis;
  /// For each wedge a third of the area of its curved triangles, in model mm^2.
  std::vector<double> area;
  /// For each wedge its smooth region.
  std::vector<std::int32_t> region;
};

/// The weight of a link is 2/3 of the area of the triangles at the edge over its length squared:
/// like the cotangent weights for good triangles, and positive for bad ones. `skipped` is nonzero
/// for triangles to leave out.
WedgeGraph build_wedge_graph(const ProxyMesh& proxy, const std::vector<std::uint8_t>& skipped,
                             const RunContext& context);

/// `turn` between the bases of two wedges.
Vec2 wedge_turn(const ProxyMesh& proxy, const WedgeGraph& graph, std::uint32_t from,
                std::uint32_t to);

}  // namespace burin::field
