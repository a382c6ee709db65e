#pragma once
/// The planes that cut a mesh open.

#include <burin/base/vec.h>
#include <burin/mesh/proxy_mesh.h>

#include <vector>

namespace burin {

/// A plane of a section, as what closes the mesh there has it.
struct CutFace {
  Vec3 point{0}, normal{0};
};

/// One a plane, by their numbers; none of a mesh that is whole. Cost: a pass over the triangles.
std::vector<CutFace> cut_faces(const ProxyMesh& proxy);

}  // namespace burin
