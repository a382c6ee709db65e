#include "measure_shape.h"

#include <burin/base/error.h>

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <gp_GTrsf.hxx>
#include <gp_Mat.hxx>

#include <cmath>

namespace burin {
namespace {

Vec3 vec(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

ShapeMeasure measure_faces(const TopoDS_Shape& shape, const BrepCounts& counts) {
  try {
    // The samples of Gauss that OCCT takes by itself are up to 2e-3 off on rational splines, but
    // the same for the same faces wherever they stand, which is what is compared; integrating to
    // 1e-7 takes some hundred times as long.
    GProp_GProps surface, body;
    BRepGProp::SurfaceProperties(shape, surface);
    if (counts.closed) BRepGProp::VolumeProperties(shape, body);
    const gp_Mat inertia = surface.MatrixOfInertia();  // tr(M) I - M, about the middle
    const double trace = 0.5 * (inertia.Value(1, 1) + inertia.Value(2, 2) + inertia.Value(3, 3));
    Mat3 second(0);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        second[k][i] = (i == k ? trace : 0) - inertia.Value(i + 1, k + 1);
      }
    }
    // Outward or inward does not matter: the middle is the same.
    const double volume = counts.closed ? std::abs(body.Mass()) : 0;
    ShapeMeasure m = shape_measure(surface.Mass(), vec(surface.CentreOfMass()), second, volume,
                                   volume > 0 ? vec(body.CentreOfMass()) : Vec3(0));
    m.faces = counts.faces;
    m.edges = counts.edges;
    return m;
  } catch (const Standard_Failure&) {
    throw GeometryError("OCCT cannot integrate over the faces of the part");
  }
}

gp_GTrsf transformation(const Placement& placement) {
  const Mat3& m = placement.linear;
  gp_Mat rows;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) rows(row + 1, column + 1) = m[column][row];
  }
  return {rows, gp_XYZ(placement.offset.x, placement.offset.y, placement.offset.z)};
}

}  // namespace

TopoDS_Shape as_splines(const BrepModel& model, const Placement& placement) {
  try {
    BRepBuilderAPI_GTransform splines(model.shape(), transformation(placement), true);
    return splines.Shape();
  } catch (const Standard_Failure&) {
    throw GeometryError("OCCT cannot make splines of the stretched faces of the part");
  }
}

ShapeMeasure brep_measure(const BrepModel& model) {
  return measure_faces(model.shape(), model.counts());
}

ShapeMeasure brep_measure(const BrepModel& model, const Placement& placement) {
  return measure_faces(as_splines(model, placement), model.counts());
}

}  // namespace burin
