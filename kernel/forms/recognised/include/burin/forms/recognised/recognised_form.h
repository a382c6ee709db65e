#pragma once
/// Meshes whose facets stand for round surfaces; the round surfaces are drawn.

#include <burin/forms/mesh/texture_map.h>
#include <burin/forms/recognised/turned_surface.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/surface/scene.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace burin {

/// How many round faces were recognised, each connected piece once.
struct RecognisedFaces {
  std::int64_t cylinders = 0, cones = 0, spheres = 0, tori = 0;
  /// Other surfaces of revolution.
  std::int64_t revolved = 0;
  /// Smooth surfaces through rows of points: swept, twisted, of splines.
  std::int64_t swept = 0;
  std::int64_t total() const { return cylinders + cones + spheres + tori + revolved + swept; }
};

/// A part given by triangles of which runs of flat facets lie around an axis at equal angles, nine
/// or more to a turn: cylinders and cones, and where such bands follow one another smoothly
/// spheres, tori and other surfaces of revolution. The vertices of the mesh lie on the surface that
/// is meant: it goes through them, has its own normals and curvature, and meets its neighbours in
/// circles and curves instead of polygons. Where all facets stand for such
/// surfaces or planes it is made of their charts, as CAD faces are; a part with others stays on its
/// triangles, and those are what MeshForm makes of them. No point moves
/// farther than a few times the sagitta of the facets it lies in; polyhedra of eight or fewer sides
/// a turn are left alone (kernel/forms/recognised/README.md).
class RecognisedForm final : public Form {
 public:
  /// Takes a manifold, oriented mesh, as `repair` returns it, and recognises; u and v of `texture`
  /// come before those of the surfaces that are found, and `faces` (one number from 0 a triangle)
  /// before their faces: such as one round surface in two colours. Cost: 2 s per million triangles.
  RecognisedForm(TriMesh mesh, const RunContext& context,
                 std::shared_ptr<const TextureMap> texture = nullptr,
                 std::shared_ptr<const std::vector<std::int32_t>> faces = nullptr);
  /// The same of a mesh of which it is known what its facets stand for: runs are looked for among
  /// unknown ones alone. What a chain of cones stands for is judged as above.
  RecognisedForm(TriMesh mesh, const KnownSurfaces& known, const RunContext& context);
  ~RecognisedForm() override;

  /// Not yet placed.
  const TriMesh& mesh() const;
  RecognisedFaces faces() const;
  /// Whether it is drawn as a MeshForm of its triangles is: where no round face was found and,
  /// of facets that are all known to be flat, none that is a wall beside narrower ones, or some
  /// that are part of a rounding.
  bool is_mesh() const;
  /// Whether the coordinates have too few digits left, as far from the origin, to tell round from
  /// flat: then nothing is recognised.
  bool too_coarse() const;
  Box3 bounds(const Mat3& axes) const override;
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override;
  std::shared_ptr<const Form> mapped(const Placement& by) const override;
  bool realised_beside_others() const override { return true; }
  /// Of the triangles.
  ShapeMeasure measure(RunContext& context) const override;

 private:
  struct Impl;
  RecognisedForm(std::shared_ptr<Impl> impl, const Placement& placement);
  Box3 bounds_as_read(const Mat3& axes) const;

  std::shared_ptr<Impl> impl_;
  Placement placement_;
};

}  // namespace burin
