#include "sweep.h"

#include <burin/base/error.h>

#include "at_node.h"
#include "import_file.h"

#include <fmt/format.h>

#include <limits>

namespace burin::csg {

void check_swept(double triangles, const char* what) {
  if (triangles <= kMostSwept) return;
  throw InputError(fmt::format("{} of {:g} triangles; {:g} are the most: set lower $fn or slices",
                               what, triangles, kMostSwept));
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
