#pragma once
/// Lines between faces of two kinds.

#include <burin/base/curve.h>
#include <burin/feature/options.h>
#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace burin {

/// Chains of the edges over which the surface is smooth and the kind of its faces changes, hidden
/// ones too: of kind Smooth, without normals. `kind`: of a face of the input. What `lines` asks
/// for of smooth edges and seams is left out: those are lines already (`extract_features`). Cost: a
/// pass over the triangles, 10 ms per million of them, and the lines.
std::vector<Curve3> kind_borders(const ProxyMesh& proxy, std::int32_t part,
                                 const std::function<std::int32_t(std::int32_t face)>& kind,
                                 const FeatureOptions& lines);

}  // namespace burin
