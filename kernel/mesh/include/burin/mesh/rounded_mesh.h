#pragma once
/// The smooth surface that the facets of a proxy stand for.

#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// The patch over one triangle. Holds a reference to the proxy.
class RoundedFacet {
 public:
  RoundedFacet(const ProxyMesh& proxy, std::uint32_t face) : proxy_(&proxy), face_(face) {}

  std::uint32_t face() const { return face_; }
  /// The point over a share t in [0,1] of the k-th edge, from the lower of its vertices on; the
  /// same bits for both triangles at an edge.
  Vec3 on_edge(std::size_t k, double t) const;
  /// The point over a place of the triangle; on an edge the same as `on_edge` but for rounding.
  Vec3 at(Vec3 bary) const;
  /// A normal of the patch there, outward for a closed mesh, of any length; zero where it has none.
  Vec3 normal_at(Vec3 bary) const;

 private:
  friend class RoundedMesh;

  const ProxyMesh* proxy_;
  std::uint32_t face_;
  // What lifts the points of the k-th edge, at its start and at its end, and those in the middle.
  Vec3 ahead_[3], back_[3], inner_;
};

/// Curved point-normal triangles over a proxy mesh: one cubic patch per triangle, tangent at each
/// wedge to the wedge's normal, without gaps between triangles. A crease leaves its vertices along
/// both sides' tangent planes: straight where faces are flat, round on the rim of a cylinder.
/// Triangles that are nonzero in `exact` (one a triangle, or none at all) lie on a surface that is
/// known: their edges are straight. Holds references: proxy and `exact` must outlive it. Cost: one
/// pass over the edges to build; the lifts are found once per RoundedFacet, whatever the number of
/// its points. @cite Vlachos2001
class RoundedMesh {
 public:
  explicit RoundedMesh(const ProxyMesh& proxy, std::span<const std::uint8_t> exact = {});

  RoundedFacet facet(std::uint32_t face) const;
  /// As RoundedFacet::on_edge, for one point.
  Vec3 on_edge(HalfEdge h, double t) const;

 private:
  Vec3 control_lift(HalfEdge h, bool at_origin) const;
  bool is_exact(HalfEdge h) const;

  const ProxyMesh* proxy_;
  std::span<const std::uint8_t> exact_;
  // For each vertex the length of its shortest edge in model mm.
  std::vector<float> finest_;
};

}  // namespace burin
