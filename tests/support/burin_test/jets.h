#pragma once
/// Curvature by polynomial fits over wide rings: slow, exact on clean meshes, independent of the
/// kernel's own.

#include <burin/mesh/curvature.h>

#include <vector>

namespace burin::test {

/// One entry a vertex, by CGAL's Monge jets of degree 4 over three rings, in the kernel's
/// conventions. For meshes without creases, whose wedges are their vertices. @cite Cazals2005
std::vector<Curvature> jet_curvature(const ProxyMesh& proxy);

}  // namespace burin::test
