#pragma once
/// Charts that meet along edges: what trimmed faces and patches have in common.

#include <burin/base/affine.h>
#include <burin/forms/charted/chart.h>
#include <burin/work_mesh/chart_mesh.h>
#include <burin/work_mesh/proxy_draft.h>

#include <cstdint>
#include <memory>

namespace burin {

/// The faces of a part in its own coordinates. A COEDGE is one use of a model edge by a face (a
/// seam has two of the same face). Immutable, safe for many threads.
class Atlas {
 public:
  Atlas() = default;
  Atlas(const Atlas&) = delete;
  Atlas& operator=(const Atlas&) = delete;
  virtual ~Atlas() = default;

  virtual std::size_t face_count() const = 0;
  virtual const Chart& chart(std::int32_t face) const = 0;
  /// Whether the outward normal is -(Su x Sv).
  virtual bool reversed(std::int32_t face) const = 0;
  /// The point of a coedge at the edge's parameter t, in (u,v) of the coedge's face. Coedges of one
  /// edge share t: they meet in space within the tolerance of the part.
  virtual Vec2 on_coedge(std::int32_t coedge, double t) const = 0;
  /// What the drawing calls a face and a model edge: the indices of the input, -1 = nothing.
  virtual std::int32_t source_face(std::int32_t face) const { return face; }
  virtual std::int32_t source_edge(std::int32_t edge) const { return edge; }
};

/// An atlas at its place in the scene; `size` is its diagonal in model mm.
struct PlacedAtlas {
  std::shared_ptr<const Atlas> atlas;
  Placement placement;
  double size = 1;
  /// Whether the kinds of faces are what they were before it was placed.
  bool keeps_kinds = is_similar(placement);

  /// Stretched or sheared, only a plane stays what it was.
  FaceKind kind(std::int32_t face) const {
    const FaceKind own = atlas->chart(face).kind();
    return keeps_kinds || own == FaceKind::Plane ? own : FaceKind::Freeform;
  }
  bool reversed(std::int32_t face) const { return atlas->reversed(face) != placement.mirrors(); }
  Vec3 position(std::int32_t face, Vec2 uv) const {
    return placement.point(atlas->chart(face).position(uv));
  }
  SurfaceDerivatives derivatives(std::int32_t face, Vec2 uv) const {
    const SurfaceDerivatives d = atlas->chart(face).derivatives(uv);
    return placement.moves() ? placed(placement, d) : d;
  }
  Vec3 normal(std::int32_t face, Vec2 uv, const SurfaceDerivatives& d) const {
    return chart_normal(d, reversed(face), uv, atlas->chart(face).domain().center());
  }
};

/// What `assemble_proxy` wants to know of the triangles of an atlas, by the names of the drawing.
ProxyDraft proxy_draft(const ChartMesh& mesh, const Atlas& atlas);

}  // namespace burin
