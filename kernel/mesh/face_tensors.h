#pragma once
/// Curvature tensors of single triangles and their means at wedges.

#include <burin/mesh/corners.h>
#include <burin/mesh/proxy_mesh.h>

#include "tensor.h"

#include <vector>

namespace burin {

/// The mean of the tensors of the triangles around each wedge by corner area, in the frame
/// `tangent_frame(wedge_normal)`. @cite Rusinkiewicz2004
std::vector<Tensor> wedge_tensors(const ProxyMesh& proxy, const Corners& corners,
                                  const RunContext& context);

}  // namespace burin
