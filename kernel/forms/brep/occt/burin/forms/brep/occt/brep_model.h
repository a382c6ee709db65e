#pragma once
/// OCCT's side of a CAD part. Internal: for this form and for the readers that fill it; nothing
/// else sees OCCT's types.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/parametric/atlas.h>

#include <TopoDS_Shape.hxx>

#include <memory>
#include <vector>

namespace burin {

/// A shape with its faces as charts, in its own coordinates. Faces and edges are numbered from 0 in
/// the order of TopExp::MapShapes. Coedges are uses of edges by faces, in the order of the faces.
/// Every function may be called from many threads.
class BrepModel final : public Atlas {
 public:
  /// Takes a copy of the shape's structure (not of its geometry) with triangulations of its own.
  /// The location of the shape itself is part of its coordinates. Throws GeometryError where the
  /// shape has no face.
  explicit BrepModel(const TopoDS_Shape& shape);
  ~BrepModel() override;

  const TopoDS_Shape& shape() const;
  BrepCounts counts() const;

  std::size_t face_count() const override;
  const Chart& chart(std::int32_t face) const override;
  bool reversed(std::int32_t face) const override;
  Vec2 on_coedge(std::int32_t coedge, double t) const override;

  /// The box of axes * p, as Form::bounds: exact for planes and lines, within 1e-5 of the size
  /// elsewhere, and not less than the shape.
  Box3 bounds(const Mat3& axes) const;
  /// The diagonal of the box along the axes of the model.
  double size() const;

  /// Triangles within `tolerance` (of the model's own unit), the same whatever was asked for
  /// before; normals are not filled in. Waits for the mesher if another thread has it; the last few
  /// results are kept. Faces that cannot be meshed are left out and named in `diagnostics`
  /// ("brep.face_not_meshed"). Throws GeometryError where none can, Cancelled within 0.1 s of a
  /// cancel save inside one face (kernel/docs/brep.md).
  std::shared_ptr<const ChartMesh> tessellate(double tolerance, RunContext& context,
                                              Diagnostics* diagnostics) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The model of a shape as it was read (placement apart). Throws GeometryError as BrepModel does;
/// no exception of OCCT gets out.
std::shared_ptr<const BrepModel> make_brep_model(const TopoDS_Shape& shape);

}  // namespace burin
