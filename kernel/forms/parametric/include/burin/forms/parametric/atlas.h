#pragma once
/// Charts that meet along edges, and triangles over them: what trimmed faces and patches have in
/// common.

#include <burin/forms/parametric/chart.h>
#include <burin/mesh/tri_mesh.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

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
};

/// An atlas at its place in the scene; `size` is its diagonal in model mm.
struct PlacedAtlas {
  std::shared_ptr<const Atlas> atlas;
  Placement placement;
  double size = 1;

  bool reversed(std::int32_t face) const { return atlas->reversed(face) != placement.mirrors(); }
  Vec3 position(std::int32_t face, Vec2 uv) const {
    return placement.point(atlas->chart(face).position(uv));
  }
  SurfaceDerivatives derivatives(std::int32_t face, Vec2 uv) const {
    const SurfaceDerivatives d = atlas->chart(face).derivatives(uv);
    return placement.moves() ? placement(d) : d;
  }
  Vec3 normal(std::int32_t face, Vec2 uv, const SurfaceDerivatives& d) const {
    return chart_normal(d, reversed(face), uv, atlas->chart(face).domain().center());
  }
};

/// What a model edge is. Seams are edges where a face meets itself, or that divide one surface:
/// curvature goes on over them (`bends_alike`), as between the halves of a cylinder.
enum class ModelEdgeClass : std::uint8_t { Sharp, Smooth, Seam, Boundary };

/// Half-edge numbering as in Topology: h = 3 * triangle + corner.
struct ChartMesh {
  /// Model mm, in place; vertices on model edges are shared by the faces that meet there.
  std::vector<Vec3> positions;
  /// Counter-clockwise seen from outside.
  std::vector<Triangle> triangles;
  /// For each triangle its face of the atlas.
  std::vector<std::int32_t> face;
  /// For each half-edge, at its origin: the parameters in its triangle's face (in a periodic face
  /// those of one triangle lie side by side, not a period apart), and the unit normal of its wedge:
  /// across smooth edges the mean of both faces. Zero normal = none (the tip of a cone).
  std::vector<Vec2> uv;
  std::vector<Vec3> normal;
  /// For each half-edge: nonzero where g is zero for the view (see cut_along_contours).
  std::vector<std::uint8_t> on_contour;
  /// For each half-edge its entry in `borders`, -1 inside faces.
  std::vector<std::int32_t> border;
  struct Border {
    std::int32_t edge = -1;    // model edge
    std::int32_t coedge = -1;  // -1: no curve known; straight in (u,v)
    double t0 = 0, t1 = 0;     // the edge's parameter at origin and target of the half-edge
  };
  std::vector<Border> borders;
  /// For each model edge.
  std::vector<ModelEdgeClass> edge_class;
  /// Largest distance in model mm between the triangles and the surface.
  double tolerance = 0;

  ModelEdgeClass border_class(std::size_t half_edge) const {
    return edge_class[static_cast<std::size_t>(
        borders[static_cast<std::size_t>(border[half_edge])].edge)];
  }
};

}  // namespace burin
