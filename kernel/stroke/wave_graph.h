#pragma once
// The picture as a graph for one family of lines: nodes are cells of the raster whose surface faces
// the viewer, links join neighbours on one sheet.

#include <burin/base/groups.h>

#include "picture.h"
#include "view_raster.h"

#include <array>
#include <cstdint>
#include <vector>

namespace burin::detail {

inline constexpr std::int32_t kNone = -1;

struct WaveNode {
  std::uint32_t cell = 0;  // of the raster
  /// Turns a paper mm that the phase is to make, across the lines; its sign is one of two.
  Vec2 wave{0};
  bool ruled = false;  // everybody knows how lines run on its face
};

/// Where it `flips` the wave of b runs against that of a: the field cannot be given signs there.
struct WaveLink {
  std::uint32_t a = 0, b = 0;
  Vec2 step{0};  // paper mm from a to b
  double weight = 1;
  bool flips = false;
};

/// A quad of four cells, by its lower left one, is cut into two triangles by its diagonal.
struct WaveGraph {
  std::vector<WaveNode> nodes;                    // in the order of the cells
  std::vector<std::int32_t> node;                 // of each cell; kNone
  std::vector<WaveLink> links;                    // by their first cell
  std::vector<std::int32_t> right, up, diagonal;  // links of each cell; kNone
  /// Nodes in the order of a tree through each connected component, and the link from the parent;
  /// kNone: a root.
  std::vector<std::uint32_t> order;
  std::vector<std::int32_t> parent_link;
  std::vector<std::uint32_t> component;  // of each node
  std::uint32_t components = 0;
};

/// What stands at the ends of the links at each node, in the order of the links: `ends(link)` are
/// the two of a, and of b.
template <class Ends>
auto at_nodes(const WaveGraph& graph, const Ends& ends) {
  return grouped(
      graph.nodes.size(), graph.links.size(),
      [&](std::size_t l) {
        return std::array{graph.links[l].a, graph.links[l].b};
      },
      ends);
}

/// A link as a triangle goes round, counterclockwise: with it (1) or against it (-1).
struct TriangleSide {
  std::int32_t link = kNone;
  int way = 1;
};
using WaveTriangle = std::array<TriangleSide, 3>;

/// Calls `take(WaveTriangle)` for the triangles of all quads, row by row, whose links are all
/// there.
template <class Take>
void for_each_triangle(const ViewRaster& raster, const WaveGraph& graph, const RunContext& context,
                       const Take& take) {
  const auto offer = [&](const WaveTriangle& t) {
    for (const TriangleSide& s : t) {
      if (s.link == kNone) return;
    }
    take(t);
  };
  for (std::int32_t y = 0; y + 1 < raster.ny; ++y) {
    if (y % 64 == 0) context.check();
    for (std::int32_t x = 0; x + 1 < raster.nx; ++x) {
      const std::size_t low = raster.index(x, y);
      const std::int32_t diagonal = graph.diagonal[low];
      if (diagonal == kNone) continue;
      const std::int32_t bottom = graph.right[low], left = graph.up[low],
                         top = graph.right[raster.index(x, y + 1)],
                         right = graph.up[raster.index(x + 1, y)];
      const WaveLink& across = graph.links[static_cast<std::size_t>(diagonal)];
      if (graph.nodes[across.a].cell == low) {
        offer({{{bottom, 1}, {right, 1}, {diagonal, -1}}});
        offer({{{diagonal, 1}, {top, -1}, {left, -1}}});
      } else {
        offer({{{bottom, 1}, {diagonal, 1}, {left, -1}}});
        offer({{{right, 1}, {top, -1}, {diagonal, -1}}});
      }
    }
  }
}

/// Whether a cell faces the viewer enough for a node.
bool has_node(const RasterCell& cell);

/// The graph of family 1 or 2. Cost: a field query for each cell that is hatched.
WaveGraph wave_graph(const Picture& picture, const ViewRaster& raster, int family,
                     const RunContext& context);

}  // namespace burin::detail
