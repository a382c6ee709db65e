#pragma once
// Which way each wedge of a proxy faces, and where along an edge that changes.

#include <burin/base/run_context.h>
#include <burin/camera/facing.h>

#include "zero_set.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// Triangles a range of the parallel loops.
constexpr std::size_t kFaceGrain = 16384;

/// FacingFunction at every wedge of one part; exactly zero where the proxy says so. The front side
/// is turned to the viewer. Triangles are `decided` that face as their planes do: contours run
/// along their edges.
class Facing : public ZeroSet {
 public:
  Facing(const ProxyMesh& proxy, const Camera& camera, const RunContext& context);

  /// One half-edge of each smooth edge along which a decided triangle and another face different
  /// ways, ascending: contours run there.
  std::vector<HalfEdge> folds() const;

 private:
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
};

}  // namespace burin
