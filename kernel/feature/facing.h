#pragma once
// Which way each wedge of a proxy faces, and where along an edge that changes.

#include <burin/base/run_context.h>
#include <burin/camera/facing.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/mesh/rounded_mesh.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace burin {

/// A point where g is zero, on the edge of half-edge h.
struct ZeroCrossing {
  Vec3 position{0};
  /// Share of the edge from the half-edge's own origin, in [0,1].
  double share = 0;
};

/// FacingFunction at every wedge of one part; exactly zero where the proxy says so.
class Facing {
 public:
  Facing(const ProxyMesh& proxy, const Camera& camera, const RunContext& context);

  const ProxyMesh& proxy() const { return *proxy_; }
  const Camera& camera() const { return *camera_; }
  double g(std::uint32_t wedge) const { return g_[wedge]; }
  /// Whether the corner at the origin of `h` is turned to the viewer, as the triangle of `h` has
  /// it.
  bool front_at(HalfEdge h) const {
    if (decided(face_of(h))) return decided_[face_of(h)] > 0;
    return front(origin_wedge(h));
  }
  /// Whether a triangle faces as its plane does, whatever the normals at its corners say: contours
  /// run along its edges, not across it.
  bool decided(std::uint32_t face) const { return !decided_.empty() && decided_[face] != 0; }
  /// One half-edge of each smooth edge along which a decided triangle and another face different
  /// ways, ascending: contours run there.
  std::vector<HalfEdge> folds() const;

  std::uint32_t origin_wedge(HalfEdge h) const {
    return proxy_->wedges[face_of(h)][static_cast<std::size_t>(h % 3)];
  }
  std::uint32_t target_wedge(HalfEdge h) const { return origin_wedge(next_in_face(h)); }
  /// Whether g changes its sign along `h`, in the triangle of `h`.
  bool crosses(HalfEdge h) const { return front_at(h) != front_at(next_in_face(h)); }
  /// The zero on a half-edge that crosses; bit for bit the same from both sides of a smooth edge.
  ZeroCrossing crossing(HalfEdge h) const;
  /// Triangles with corners of both signs, ascending.
  std::vector<std::uint32_t> mixed_faces(const RunContext& context) const;
  /// The smooth surface over a triangle; on an edge it passes through `crossing`.
  RoundedFacet over(std::uint32_t face) const { return surface_.facet(face); }
  /// Unit normal on `h` (in its triangle) at a share of it.
  Vec3 normal(HalfEdge h, double share) const;

 private:
  bool front(std::uint32_t wedge) const { return g_[wedge] > 0; }

  /// Makes what is turned to the viewer just turned away; contours of a cut proxy stay where they
  /// are.
  void turn_away(std::uint32_t wedge) {
    const bool on_contour = !proxy_->on_contour.empty() && proxy_->on_contour[wedge] != 0;
    if (!on_contour) g_[wedge] = std::min(g_[wedge], -kEdgeOn);
  }

  /// A flat wall between two fillets has normals that lean to both: seen edge-on it would be cut in
  /// two somewhere. As a whole turned away it ends where the fillet begins, which is where it is
  /// seen.
  void turn_flat_walls_away(const FacingFunction& facing, const RunContext& context);

  /// At a tip (mesh/tips.h) a contour runs straight into it or does not reach it: each face has
  /// the side of its other corners there, and zero where these have both.
  void face_tips(const std::vector<std::uint8_t>& tips);

  /// Turns away what would show less than kThinWidth of paper in its width: patches of a ruled
  /// surface seen along its rulings, which noise in the normals turns a little to the viewer.
  void turn_thin_patches_away(const RunContext& context);

  /// Where the zero of g and the fold of the triangles lie visibly apart, as on wide facets of a
  /// hull, the triangles decide: they are what hides.
  void let_wide_facets_decide(const std::vector<std::uint8_t>& tips, const RunContext& context);
  /// Whether the triangles at a smooth edge face different ways somewhere along it.
  bool is_fold(HalfEdge h) const;

  const ProxyMesh* proxy_;
  const Camera* camera_;
  RoundedMesh surface_;
  std::vector<double> g_;
  /// For each triangle 1 or -1 where it is decided, by its side; empty where none is.
  std::vector<std::int8_t> decided_;
};

}  // namespace burin
