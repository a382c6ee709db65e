#pragma once
/// Triangle meshes as a surface form.

#include <burin/forms/mesh/texture_map.h>
#include <burin/mesh/curvature.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/surface/scene.h>

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace burin {

/// A part given by triangles. Its surface is that of its proxy: charts are triangles, coordinates
/// barycentric. The proxy is the mesh itself where its facets lie within half the tolerance of the
/// smooth surface that they stand for (RoundedMesh); coarser ones are divided until they do.
class MeshForm final : public Form {
 public:
  /// Takes a manifold, oriented mesh, as `repair` returns it, and u and v where there are any.
  explicit MeshForm(TriMesh mesh, std::shared_ptr<const TextureMap> texture = nullptr)
      : mesh_(std::move(mesh)), texture_(std::move(texture)) {}
  /// With faces that the input tells apart: one number from 0 a triangle (`number_faces`).
  MeshForm(TriMesh mesh, std::shared_ptr<const TextureMap> texture,
           std::shared_ptr<const std::vector<std::int32_t>> faces)
      : mesh_(std::move(mesh)), texture_(std::move(texture)), faces_(std::move(faces)) {}

  const TriMesh& mesh() const { return mesh_; }
  const std::shared_ptr<const TextureMap>& texture() const { return texture_; }
  /// One number a triangle; null: the input tells none apart.
  const std::shared_ptr<const std::vector<std::int32_t>>& faces() const { return faces_; }
  /// Of the vertices: coarse facets, when rounded, bulge beyond it by up to 0.12 of an edge.
  Box3 bounds(const Mat3& axes) const override;
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override;
  /// A mesh of the points, whose creases are chosen by its own angles.
  std::shared_ptr<const Form> mapped(const Placement& by) const override;
  /// Of the triangles as they are, not rounded.
  ShapeMeasure measure(RunContext& context) const override;
  bool looks_at_view() const override { return false; }
  bool realised_beside_others() const override { return true; }

 private:
  std::shared_ptr<const Surface> realise_mesh(const RealiseOptions& options,
                                              RunContext& context) const;

  TriMesh mesh_;
  std::shared_ptr<const TextureMap> texture_;
  std::shared_ptr<const std::vector<std::int32_t>> faces_;
};

/// Faces of a mesh whose triangles are of several kinds, such as colours: for each triangle the
/// number of the smooth region of one kind that holds it, from 0 in order of the triangles. Creases
/// are those of ProxyOptions. `kind`: one number a triangle. Cost: that of `build_proxy`.
std::vector<std::int32_t> number_faces(const TriMesh& mesh, std::span<const std::int32_t> kind,
                                       const RunContext& context);

/// The surface that a proxy mesh is by itself: what MeshForm realises, for forms that make their
/// own proxies. `curvature` has one entry per wedge, or none.
std::shared_ptr<const Surface> make_mesh_surface(ProxyMesh proxy,
                                                 const std::vector<Curvature>& curvature);

/// Such a surface, and for each of its triangles that of the proxy that it is a piece of, or is.
struct RoundedSurface {
  std::shared_ptr<const Surface> surface;
  std::vector<std::uint32_t> face_origin;
};

/// The surface that the facets of a proxy stand for: those that are farther from it than half the
/// tolerance are divided, as MeshForm does, but for triangles that are nonzero in `exact` (one a
/// triangle, or none at all), which lie on a surface that is known and keep their edges. Curvature
/// is that of the proxy. What the proxy knows of its source is kept.
RoundedSurface make_rounded_surface(ProxyMesh proxy, std::span<const std::uint8_t> exact,
                                    const RealiseOptions& options, RunContext& context);

}  // namespace burin
