#include "measure_shape.h"

#include <burin/base/error.h>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <gp_Mat.hxx>

#include <cmath>

namespace burin {
namespace {

Vec3 vec(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

}  // namespace

ShapeMeasure brep_measure(const BrepModel& model) {
  const BrepCounts counts = model.counts();
  try {
    // The samples of Gauss that OCCT takes by itself are up to 2e-3 off on rational splines, but
    // the same for the same faces wherever they stand, which is what is compared; integrating to
    // 1e-7 takes some hundred times as long.
    GProp_GProps surface, body;
    BRepGProp::SurfaceProperties(model.shape(), surface);
    if (counts.closed) BRepGProp::VolumeProperties(model.shape(), body);
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

}  // namespace burin
