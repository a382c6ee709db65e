#include "measure_shape.h"

#include <burin/base/affine.h>
#include <burin/base/error.h>

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopLoc_Location.hxx>
#include <gp_GTrsf.hxx>
#include <gp_Mat.hxx>
#include <gp_Trsf.hxx>

#include <cmath>

namespace burin {
namespace {

Vec3 vec(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

gp_Trsf transformation(const Placement& placement) {
  const Mat3& m = placement.linear;
  const Vec3& o = placement.offset;
  gp_Trsf t;
  t.SetValues(m[0][0], m[1][0], m[2][0], o[0], m[0][1], m[1][1], m[2][1], o[1], m[0][2], m[1][2],
              m[2][2], o[2]);
  return t;
}

gp_GTrsf stretching(const Placement& placement) {
  const Mat3& m = placement.linear;
  gp_Mat rows;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) rows(row + 1, column + 1) = m[column][row];
  }
  return {rows, gp_XYZ(placement.offset.x, placement.offset.y, placement.offset.z)};
}

/// A body where it stands, its faces as the splines that they become where it is stretched.
TopoDS_Shape placed_shape(const BrepBody& body) {
  if (!body.placement.moves()) return body.model->shape();
  if (!is_similar(body.placement)) return as_splines(*body.model, body.placement);
  return body.model->shape().Moved(TopLoc_Location(transformation(body.placement)));
}

/// The integrals over a body where it stands, added to those of the others.
void add(const BrepBody& body, bool closed, GProp_GProps& surface, GProp_GProps& volume) {
  const TopoDS_Shape placed = placed_shape(body);
  // The samples of Gauss that OCCT takes by itself are up to 2e-3 off on rational splines, but
  // the same for the same faces wherever they stand, which is what is compared; integrating to
  // 1e-7 takes some hundred times as long.
  GProp_GProps own;
  BRepGProp::SurfaceProperties(placed, own);
  surface.Add(own);
  if (!closed) return;
  GProp_GProps inside;
  BRepGProp::VolumeProperties(placed, inside);
  if (inside.Mass() < 0) {  // inside out in the file
    inside = GProp_GProps();
    BRepGProp::VolumeProperties(placed.Reversed(), inside);
  }
  volume.Add(inside);
}

}  // namespace

TopoDS_Shape as_splines(const BrepModel& model, const Placement& placement) {
  try {
    BRepBuilderAPI_GTransform splines(model.shape(), stretching(placement), true);
    return splines.Shape();
  } catch (const Standard_Failure&) {
    throw GeometryError("OCCT cannot make splines of the stretched faces of the part");
  }
}

ShapeMeasure brep_measure(const BrepModel& model) {
  // Not owned: the body lives as long as the call.
  return brep_measure({{std::shared_ptr<const BrepModel>(std::shared_ptr<void>(), &model), {}}});
}

ShapeMeasure brep_measure(const BrepModel& model, const Placement& placement) {
  return brep_measure(
      {{std::shared_ptr<const BrepModel>(std::shared_ptr<void>(), &model), placement}});
}

ShapeMeasure brep_measure(const std::vector<BrepBody>& bodies) {
  std::int64_t faces = 0, edges = 0;
  bool closed = true;
  for (const BrepBody& body : bodies) {
    const BrepCounts counts = body.model->counts();
    faces += counts.faces;
    edges += counts.edges;
    closed = closed && counts.closed;
  }
  try {
    GProp_GProps surface, volume;
    for (const BrepBody& body : bodies) add(body, closed, surface, volume);
    const gp_Mat inertia = surface.MatrixOfInertia();  // tr(M) I - M, about the middle
    const double trace = 0.5 * (inertia.Value(1, 1) + inertia.Value(2, 2) + inertia.Value(3, 3));
    Mat3 second(0);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        second[k][i] = (i == k ? trace : 0) - inertia.Value(i + 1, k + 1);
      }
    }
    const double mass = closed ? std::abs(volume.Mass()) : 0;
    ShapeMeasure m = shape_measure(surface.Mass(), vec(surface.CentreOfMass()), second, mass,
                                   mass > 0 ? vec(volume.CentreOfMass()) : Vec3(0));
    m.faces = faces;
    m.edges = edges;
    return m;
  } catch (const Standard_Failure&) {
    throw GeometryError("OCCT cannot integrate over the faces of the part");
  }
}

}  // namespace burin
