#include "sweep.h"

#include <burin/base/error.h>

#include "at_node.h"
#include "flat/import/import_file.h"

#include <fmt/format.h>

#include <limits>
#include <memory>
#include <utility>

namespace burin::csg {

void check_swept(double triangles, const char* what) {
  if (triangles <= kMostSwept) return;
  throw InputError(fmt::format("{} of {:g} triangles; {:g} are the most: set lower $fn or slices",
                               what, triangles, kMostSwept));
}

std::int32_t add_grids(std::vector<Turned>& surfaces, std::vector<PointGrid> pieces) {
  const auto first = static_cast<std::int32_t>(surfaces.size());
  for (PointGrid& piece : pieces) {
    Turned t;
    t.profile = Turned::Profile::Grid;
    t.grid = std::make_shared<const PointGrid>(std::move(piece));
    surfaces.push_back(std::move(t));
  }
  return first;
}

void drop_unused(Solid& solid) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> now(solid.positions.size(), kNone);
  std::vector<Vec3> kept;
  for (auto& triangle : solid.triangles) {
    for (std::uint32_t& v : triangle) {
      if (now[v] == kNone) {
        now[v] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(solid.positions[v]);
      }
      v = now[v];
    }
  }
  solid.positions = std::move(kept);
}

Solid extruded(Evaluation& e, std::uint32_t node, const Region& region) {
  e.run.check();
  return at_node(e, node, [&] {
    const Node& n = e.tree.nodes[node];
    // The old way: the file is an argument of the extrusion itself.
    const Region from_file = n.text("file").empty() ? Region{} : import_dxf(e, node);
    const Region& profile = n.text("file").empty() ? region : from_file;
    return n.module == Module::RotateExtrude ? rotate_extruded(e, node, profile)
                                             : linear_extruded(e, node, profile);
  });
}

}  // namespace burin::csg
