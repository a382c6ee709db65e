#pragma once
/// Curvature tensors of single triangles and their means at wedges.

#include "ring_mesh.h"
#include "tensor.h"

#include <vector>

namespace burin {

/// The mean of the tensors of the triangles around each wedge by corner area, in the frame
/// `tangent_frame(wedge_normal)`. @cite Rusinkiewicz2004
std::vector<Tensor> wedge_tensors(const RingMesh& rings, const Groups<RingHandle>& of_wedge,
                                  const ProxyMesh& proxy, const RunContext& context);

}  // namespace burin
