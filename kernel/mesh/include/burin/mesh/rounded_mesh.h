#pragma once
/// The smooth surface that the facets of a proxy stand for.

#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Curved point-normal triangles over a proxy mesh: one cubic patch per triangle, tangent at each
/// wedge to the wedge's normal, without gaps between triangles. An edge that touches a crease or
/// boundary vertex stays straight, so that a surface that ends in straight crease edges ends there
/// exactly. Holds a reference: the proxy must outlive it. Cost: one pass over the edges to build,
/// about 0.1 us per point. @cite Vlachos2001
class RoundedMesh {
 public:
  explicit RoundedMesh(const ProxyMesh& proxy);

  /// The point over the edge between two wedges at a share t in [0,1] of it.
  Vec3 on_edge(std::uint32_t a, std::uint32_t b, double t) const;
  /// The point over a place of a triangle; on an edge the same as `on_edge`.
  Vec3 on_face(std::uint32_t face, Vec3 bary) const;

 private:
  Vec3 control_lift(std::uint32_t a, std::uint32_t b) const;

  const ProxyMesh* proxy_;
  // For each vertex the length of its shortest edge in model mm; 0 where a crease or boundary
  // passes.
  std::vector<float> finest_;
};

}  // namespace burin
