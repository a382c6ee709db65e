#pragma once
/// Faces with their triangles become a surface, whichever of them are broken.

#include <burin/contour_cut/contour_cut.h>
#include <burin/forms/brep/loose_triangles.h>
#include <burin/forms/charted/atlas.h>
#include <burin/forms/charted/atlas_sampler.h>
#include <burin/forms/charted/charted_surface.h>
#include <burin/forms/charted/wedge_normals.h>
#include <burin/surface/scene.h>

#include <functional>
#include <memory>

namespace burin {

/// What is done to all faces together, one after the other. Tests put stages in their place that
/// fail at faces of their choice.
struct FaceStages {
  std::function<void(ChartMesh&, const PlacedAtlas&, const RunContext&)> normals =
      set_wedge_normals;
  /// False where it was ended by its bound.
  std::function<bool(ChartMesh&, const PlacedAtlas&, const Camera&, const RunContext&)> cut =
      [](ChartMesh& mesh, const PlacedAtlas& atlas, const Camera& camera,
         const RunContext& context) {
        return cut_along_contours(mesh, AtlasSampler(atlas), camera, {}, context);
      };
  std::function<std::shared_ptr<const Surface>(PlacedAtlas, ChartMesh, const RunContext&)> join =
      make_charted_surface;
};

/// Realises `mesh`, the triangles of the atlas in its own coordinates, and beside them `loose`.
/// Where a stage fails, or gives coordinates that are no numbers, the faces that make it fail
/// become loose: they are drawn as their triangles, joined to nothing, strokes end at their
/// borders, and "brep.face_loose" names them. Throws GeometryError where nothing is left to draw.
/// Cost where nothing fails: that of the stages.
std::shared_ptr<const Surface> realise_faces(const PlacedAtlas& atlas, const ChartMesh& mesh,
                                             const LooseTriangles& loose,
                                             const RealiseOptions& options,
                                             const RunContext& context,
                                             const FaceStages& stages = {});

}  // namespace burin
