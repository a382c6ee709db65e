#pragma once
/// Curvature tensors of single triangles and their means at wedges.

#include <burin/mesh/proxy_mesh.h>

#include "corners.h"
#include "tensor.h"

#include <vector>

namespace burin {

/// The mean of the tensors of the triangles around each wedge by corner area, in the frame
/// `tangent_frame(wedge_normal)`. @cite Rusinkiewicz2004
std::vector<Tensor> wedge_tensors(const ProxyMesh& proxy, const VertexCorners& corners,
                                  const RunContext& context);

}  // namespace burin
