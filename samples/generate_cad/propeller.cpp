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
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Wire.hxx>

#include <cmath>
#include <numbers>

namespace burin::samples {
namespace {

constexpr double kTip = 78, kHub = 15, kPitch = 150;
constexpr int kSections = 9, kAround = 28;

double smooth(double a, double b, double t) { return a + (b - a) * t * t * (3 - 2 * t); }

/// Half the thickness of a section of chord 1 and thickness 1, x from the leading edge; its
/// trailing edge is sharp.
double half_thickness(double x) { return 2.6 * std::sqrt(x) * (1 - x) * 0.5; }

/// One section of the blade: a closed curve in the plane x = r, with a corner at its trailing edge.
TopoDS_Wire section(double r) {
  const double s = (r - 6) / (kTip - 6);
  const double chord = 18 + 44 * std::sin(std::numbers::pi * std::pow(s, 1.25) * 0.72) *
                                std::pow(1.0001 - std::pow(s, 6), 0.5);
  const double thick = smooth(7.5, 1.4, s),
               angle = std::atan(kPitch / (2 * std::numbers::pi * std::max(r, 12.0)));
  const double skew = 20 * s * s, rake = -9 * s;
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 2 * kAround + 1);
  for (int i = 0; i <= 2 * kAround; ++i) {
    // From the trailing edge over the back to the leading edge and along the face home.
    const double w = std::numbers::pi * i / kAround, x = 0.5 * (1 + std::cos(w));
    const double camber = 0.25 * x * (1 - x) * chord * 0.5;
    const double half = half_thickness(x) * thick * 0.5;
    const double u = (x - 0.5) * chord, v = camber + (i <= kAround ? half : -half);
    const double y = u * std::cos(angle) - v * std::sin(angle) + skew;
    const double z = u * std::sin(angle) + v * std::cos(angle) + rake;
    points->SetValue(i + 1, gp_Pnt(r, y, z));
  }
  points->SetValue(2 * kAround + 1, points->Value(1));
  GeomAPI_PointsToBSpline fit(points->Array1(), 3, 3, GeomAbs_C2, 1e-3);
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(fit.Curve()).Edge()).Wire();
}

TopoDS_Shape blade() {
  BRepOffsetAPI_ThruSections loft(Standard_True, Standard_False, 1e-4);
  loft.SetMaxDegree(3);
  for (int i = 0; i < kSections; ++i) {
    // Closer together towards the tip, where the outline turns.
    const double t = static_cast<double>(i) / (kSections - 1);
    loft.AddWire(section(6 + (kTip - 6) * std::sin(t * std::numbers::pi / 2)));
  }
  loft.Build();
  return loft.Shape();
}

/// A turned hub with a rounded nose.
TopoDS_Shape hub() {
  const gp_Pnt aft(0, 0, -26), rim(kHub + 2, 0, -26), shoulder(kHub + 2, 0, -4), front(0, 0, 44);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(aft, rim).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(rim, shoulder).Edge());
  TColgp_Array1OfPnt points(1, 9);
  for (int i = 0; i < 9; ++i) {
    const double a = std::numbers::pi / 2 * i / 8;
    points(i + 1) = gp_Pnt((kHub + 2) * std::cos(a), 0, -4 + 48 * std::sin(a));
  }
  GeomAPI_PointsToBSpline fit(points, 3, 5, GeomAbs_C2, 1e-4);
  wire.Add(BRepBuilderAPI_MakeEdge(fit.Curve(), shoulder, front).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(front, aft).Edge());
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp::OZ()).Shape();
}

}  // namespace

TopoDS_Shape propeller() {
  std::vector<TopoDS_Shape> all = round_about(blade(), 4);
  all.insert(all.begin(), hub());
  const TopoDS_Shape whole = fuse(all);
  const TopoDS_Shape blended = rounded(whole, 2, [](const EdgeView& e) {
    return !e.convex && std::hypot(e.middle.X(), e.middle.Y()) < kHub + 6;
  });
  return cut(blended,
             {cylinder({0, 0, -40}, gp_Dir(0, 0, 1), 7, 40), box({-2, 0, -40}, {2, 9.3, -2})});
}

}  // namespace burin::samples
