#include "kit.h"
#include "models.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Wire.hxx>

#include <cmath>
#include <numbers>

namespace burin::samples {
namespace {

constexpr double kTip = 78, kRoot = 6, kHub = 17, kPitch = 150;
constexpr int kSections = 9, kAround = 32;

double smooth(double a, double b, double t) { return a + (b - a) * t * t * (3 - 2 * t); }

/// Half the thickness of a section of chord 1 and thickness 1: an ellipse that is fuller ahead.
double half_thickness(double x) { return std::sqrt(x * (1 - x)) * (1.25 - 0.5 * x); }

/// One section of the blade: a smooth closed curve in the plane x = r.
TopoDS_Wire section(double r) {
  const double s = (r - kRoot) / (kTip - kRoot);
  const double outline = std::sqrt(1.0004 - std::pow(s, 5));
  const double chord = (24 + 48 * std::sin(0.72 * std::numbers::pi * std::pow(s, 1.25))) * outline;
  const double thick = smooth(9, 1.6, s) * std::sqrt(outline);
  const double angle = std::atan(kPitch / (2 * std::numbers::pi * std::max(r, 14.0)));
  const double skew = 20 * s * s, rake = -9 * s;
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, kAround);
  for (int i = 0; i < kAround; ++i) {
    // From the trailing edge over the back to the leading edge and along the face home.
    const double w = 2 * std::numbers::pi * i / kAround, x = 0.5 * (1 + std::cos(w));
    const double camber = 0.12 * x * (1 - x) * chord;
    const double half = half_thickness(x) * thick * (2 * i <= kAround ? 0.5 : -0.5);
    const double u = (x - 0.5) * chord, v = camber + half;
    points->SetValue(i + 1, gp_Pnt(r, u * std::cos(angle) - v * std::sin(angle) + skew,
                                   u * std::sin(angle) + v * std::cos(angle) + rake));
  }
  // The same parameters for all sections keep the knots of the loft few.
  Handle(TColStd_HArray1OfReal) at = new TColStd_HArray1OfReal(1, kAround + 1);
  for (int i = 0; i <= kAround; ++i) at->SetValue(i + 1, i);
  GeomAPI_Interpolate through(points, at, Standard_True, 1e-6);
  through.Perform();
  const Handle(Geom_BSplineCurve) curve = through.Curve();
  // Two edges, so that the loft pairs leading edge with leading edge.
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(curve, 0, kAround / 2.0).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(curve, kAround / 2.0, kAround).Edge());
  return wire.Wire();
}

TopoDS_Shape blade() {
  BRepOffsetAPI_ThruSections loft(Standard_True, Standard_False, 1e-4);
  loft.SetMaxDegree(3);
  loft.CheckCompatibility(Standard_False);  // all sections begin at the trailing edge
  for (int i = 0; i < kSections; ++i) {
    // Closer together towards the tip, where the outline turns.
    const double t = static_cast<double>(i) / (kSections - 1);
    loft.AddWire(section(kRoot + (kTip - kRoot) * std::sin(t * std::numbers::pi / 2)));
  }
  loft.Build();
  return loft.Shape();
}

/// A turned hub: a collar aft, then one curve to the round nose.
TopoDS_Shape hub() {
  const gp_Pnt aft(0, 0, -34), rim(kHub, 0, -34), shoulder(kHub, 0, -26), front(0, 0, 46);
  TColgp_Array1OfPnt points(1, 13);
  for (int i = 0; i < 13; ++i) {
    const double a = std::numbers::pi / 2 * i / 12;
    points(i + 1) = gp_Pnt(kHub * std::pow(std::cos(a), 0.8), 0, -26 + 72 * std::sin(a));
  }
  GeomAPI_PointsToBSpline fit(points, 3, 5, GeomAbs_C2, 1e-3);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(aft, rim).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(rim, shoulder).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(fit.Curve(), shoulder, front).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(front, aft).Edge());
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp::OZ()).Shape();
}

}  // namespace

TopoDS_Shape propeller() {
  // Turned so that the seam of the hub runs between two blades.
  std::vector<TopoDS_Shape> all = round_about(blade(), 3, std::numbers::pi / 2);
  all.insert(all.begin(), hub());
  const TopoDS_Shape blended = rounded(fuse(all), 1.5, [](const EdgeView& e) {
    return !e.convex && std::hypot(e.middle.X(), e.middle.Y()) < kHub + 6;
  });
  return cut(blended,
             {cylinder({0, 0, -50}, gp_Dir(0, 0, 1), 7, 60), box({-2, 0, -50}, {2, 9.3, 10})});
}

}  // namespace burin::samples
