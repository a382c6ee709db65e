#pragma once
// The picture as a graph for one family of lines: nodes are cells of the raster whose surface faces
// the viewer, links join neighbours on one sheet.

#include "picture.h"
#include "view_raster.h"

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

/// Whether a cell faces the viewer enough for a node.
bool has_node(const RasterCell& cell);

/// The graph of family 1 or 2. Cost: a field query for each cell that is hatched.
WaveGraph wave_graph(const Picture& picture, const ViewRaster& raster, int family,
                     const RunContext& context);

}  // namespace burin::detail
