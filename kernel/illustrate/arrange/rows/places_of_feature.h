#pragma once
// Places of a face, an edge or a part from which it may be seen; internal to the module.

#include <burin/base/vec.h>
#include <burin/mesh/proxy_mesh.h>

#include "seen_feature.h"

#include <cstdint>
#include <vector>

namespace burin::detail {

/// A place of a surface, and its normal there; of an edge the point of it beside that.
struct SampledPlace {
  Vec3 at{0}, normal{0}, on_edge{0};
};

/// Whether a triangle of a part is one of a face; of a part all are.
bool is_of_feature(const ProxyMesh& proxy, std::uint32_t triangle, const SeenFeature& seen);

/// Those that are turned to the viewer, of 1024 at the most: of a face its triangles, of an edge
/// what lies beside it.
std::vector<SampledPlace> sampled_places(const SeenFeature& seen, Vec3 to_viewer);

}  // namespace burin::detail
