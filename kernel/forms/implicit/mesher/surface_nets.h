#pragma once
// Polygons around the grid edges that the zero set crosses: a closed, oriented manifold.

#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>

#include "grid.h"

#include <array>
#include <vector>

namespace burin {

/// Dual vertices, one for each sheet of the surface in a cell, and the polygons that join them, ccw
/// seen from the positive side. @cite Gibson1998, Nielson2004
struct Nets {
  std::vector<Vec3> vertices;
  // From here on they lie on faces between cells, to keep edges apart that join the same two cells.
  std::uint32_t first_extra = 0;
  // For each vertex its cell, the signs there (bit = inside) and which sheet of the cell it stands
  // for.
  struct Source {
    Cell cell{0};
    std::uint8_t signs = 0, sheet = 0;
  };
  std::vector<Source> sources;
  std::vector<std::uint32_t> corners;       // of all polygons
  std::vector<std::uint32_t> first_corner;  // a polygon, and the end
};

/// The grid edges that the sheet of a vertex crosses: inside end, outside end.
std::vector<std::array<Vec3, 2>> crossed_edges(const GridLayout& layout,
                                               const Nets::Source& source);

Nets make_nets(const Grid& grid, const RunContext& context);

}  // namespace burin
