#pragma once
/// Faces of the input that seams alone divide.

#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <vector>

namespace burin {

/// For each face of the input (`ProxyMesh::source_face`) the first of those that it is one surface
/// with: half cylinders are the cylinder. Empty where no seam divides any, and where the proxy
/// knows no faces.
std::vector<std::int32_t> whole_faces(const ProxyMesh& proxy);

}  // namespace burin
