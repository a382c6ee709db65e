#pragma once
/// Triangles over the faces of a shape, under way to its proxy: what forms refine and cut.

#include <burin/base/run_context.h>
#include <burin/base/vec.h>
#include <burin/mesh/topology.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace burin {

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

/// For each half-edge the opposite one, or kNoHalfEdge. Inside faces triangles of one face meet, on
/// model edges two uses of that edge; where that leaves a choice nothing meets.
std::vector<HalfEdge> chart_mesh_opposites(const ChartMesh& mesh);

/// Whether the normals of both sides of `h` have nothing to do with each other.
inline bool sharp_edge(const ChartMesh& mesh, HalfEdge opposite, std::size_t h) {
  if (opposite == kNoHalfEdge) return true;
  return mesh.border[h] >= 0 && mesh.border_class(h) == ModelEdgeClass::Sharp;
}

/// Gives every corner the normal of its wedge (the corners that edges join which are not sharp):
/// the mean of `of_face(corners)` over the faces that it touches. Zero = that face has none there.
/// Fills `normal`; `on_contour` is set where there is none and cleared elsewhere. `of_face` is
/// called from many threads. Cost: 0.1 us per triangle beside it.
using FaceNormal = std::function<Vec3(std::span<const HalfEdge>)>;
void set_corner_normals(ChartMesh& mesh, const FaceNormal& of_face, const RunContext& context);

}  // namespace burin
