#pragma once
/// OCCT's side of a CAD part. Internal: for this form and for the readers that fill it; nothing
/// else sees OCCT's types.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/loose_triangles.h>
#include <burin/forms/charted/atlas.h>

#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>

#include <functional>
#include <memory>
#include <vector>

namespace burin {

/// Joined triangles over charts, and those of faces that could not be joined. `loose` names each in
/// a diagnostic.
struct BrepTriangles : ChartMesh {
  LooseTriangles loose;
};

/// Makes the chart of a face from its surface and the box of (u,v) that it takes.
using ChartMaker =
    std::function<std::shared_ptr<const Chart>(const Handle(Geom_Surface)&, const ParameterBox&)>;

/// What the drawing calls the first face and the first edge of a model that is one of several
/// bodies of a part.
struct FirstNumbers {
  std::int32_t face = 0, edge = 0;
  bool operator==(const FirstNumbers&) const = default;
};

/// A shape with its faces as charts, in its own coordinates. Faces and edges are numbered from 0 in
/// the order of TopExp::MapShapes; the drawing counts them from `FirstNumbers` on. Coedges are uses
/// of edges by faces, in the order of the faces. Every function may be called from many threads.
class BrepModel final : public Atlas {
 public:
  /// Takes a copy of the shape's structure (not of its geometry) with triangulations of its own.
  /// The location of the shape itself is part of its coordinates. Throws GeometryError where the
  /// shape has no face. `make_chart` stands in for make_surface_chart where tests want faces that
  /// break.
  explicit BrepModel(const TopoDS_Shape& shape, const ChartMaker& make_chart = {},
                     FirstNumbers first = {});
  ~BrepModel() override;

  const TopoDS_Shape& shape() const;
  BrepCounts counts() const;

  std::size_t face_count() const override;
  const Chart& chart(std::int32_t face) const override;
  bool reversed(std::int32_t face) const override;
  Vec2 on_coedge(std::int32_t coedge, double t) const override;
  std::int32_t source_face(std::int32_t face) const override { return first_.face + face; }
  std::int32_t source_edge(std::int32_t edge) const override { return first_.edge + edge; }

  /// The box of axes * p, as Form::bounds: exact for planes and lines, within 1e-5 of the size
  /// elsewhere, and not less than the shape.
  Box3 bounds(const Mat3& axes) const;
  /// The diagonal of the box along the axes of the model.
  double size() const;

  /// Triangles within `tolerance` (in the model's own unit); they do not depend on earlier calls;
  /// normals are not filled in. Waits for the mesher if another thread has it; the last few results
  /// are kept. Faces that cannot be meshed together with their neighbours, or have no chart that
  /// works, are meshed by themselves or keep the triangles that the shape came with, and are named
  /// in `diagnostics` ("brep.face_loose"); those without any triangle are left out
  /// ("brep.face_not_meshed"). Throws GeometryError where that is all of them, Cancelled within
  /// 0.1 s of a cancel save inside one face (kernel/forms/brep/README.md).
  std::shared_ptr<const BrepTriangles> tessellate(double tolerance, RunContext& context,
                                                  Diagnostics* diagnostics) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  FirstNumbers first_;
};

/// The faces of a model as the splines that they become where they are stretched or sheared, in
/// place: for what OCCT integrates. Throws GeometryError where OCCT cannot.
TopoDS_Shape as_splines(const BrepModel& model, const Placement& placement);

/// The model of a shape as it was read (placement apart). Throws GeometryError as BrepModel does;
/// no exception of OCCT gets out.
std::shared_ptr<const BrepModel> make_brep_model(const TopoDS_Shape& shape,
                                                 FirstNumbers first = {});

}  // namespace burin
