#include "kit.h"
#include "models.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>

#include <cmath>
#include <numbers>
#include <vector>

namespace burin::samples {
namespace {

constexpr double kTip = 78, kRoot = 6, kHub = 17, kPitch = 150;
constexpr int kSections = 10, kAround = 24;

/// The points of one section of the blade in the plane x = r, from the trailing edge over the back
/// to the leading edge and along the face home.
std::vector<gp_Pnt> section(double r) {
  const double s = (r - kRoot) / (kTip - kRoot);
  const double outline = std::sqrt(1.002 - std::pow(s, 5));
  const double chord = (24 + 48 * std::sin(0.72 * std::numbers::pi * std::pow(s, 1.25))) * outline;
  const double thick = (9 - 7 * s) * std::sqrt(outline);
  const double angle = std::atan(kPitch / (2 * std::numbers::pi * std::hypot(r, 8.0)));
  const double skew = 20 * s * s, rake = -9 * s;
  std::vector<gp_Pnt> points;
  for (int i = 0; i < kAround; ++i) {
    const double w = 2 * std::numbers::pi * i / kAround, x = 0.5 * (1 + std::cos(w));
    const double camber = 0.12 * x * (1 - x) * chord;
    const double half = 0.25 * std::sin(w) * (1.25 - 0.5 * x) * thick;
    const double u = (x - 0.5) * chord, v = camber + half;
    points.emplace_back(r, u * std::cos(angle) - v * std::sin(angle) + skew,
                        u * std::sin(angle) + v * std::cos(angle) + rake);
  }
  return points;
}

/// The cubic spline through the points at the parameters 0, 1, 2 ...
Handle(Geom_BSplineCurve) spline(const std::vector<gp_Pnt>& points, bool closed) {
  const int n = static_cast<int>(points.size()), parameters = closed ? n + 1 : n;
  const Handle(TColgp_HArray1OfPnt) at = new TColgp_HArray1OfPnt(1, n);
  const Handle(TColStd_HArray1OfReal) t = new TColStd_HArray1OfReal(1, parameters);
  for (int i = 1; i <= n; ++i) at->SetValue(i, points[static_cast<std::size_t>(i - 1)]);
  for (int i = 1; i <= parameters; ++i) t->SetValue(i, i - 1);
  GeomAPI_Interpolate through(at, t, closed, 1e-6);
  through.Perform();
  Handle(Geom_BSplineCurve) curve = through.Curve();
  if (closed) curve->SetNotPeriodic();
  return curve;
}

/// The loft through the sections, smooth to the second order: splines through their poles.
Handle(Geom_BSplineSurface) loft() {
  std::vector<Handle(Geom_BSplineCurve)> sections, rails;
  for (int i = 0; i < kSections; ++i) {
    // Closer together towards the tip, where the outline turns.
    const double t = std::sin(std::numbers::pi / 2 * i / (kSections - 1));
    sections.push_back(spline(section(kRoot + (kTip - kRoot) * t), true));
  }
  for (int j = 1; j <= sections[0]->NbPoles(); ++j) {
    std::vector<gp_Pnt> poles;
    for (const auto& curve : sections) poles.push_back(curve->Pole(j));
    rails.push_back(spline(poles, false));
  }
  TColgp_Array2OfPnt poles(1, sections[0]->NbPoles(), 1, rails[0]->NbPoles());
  for (int j = 1; j <= poles.ColLength(); ++j) {
    for (int k = 1; k <= poles.RowLength(); ++k) {
      poles(j, k) = rails[static_cast<std::size_t>(j - 1)]->Pole(k);
    }
  }
  return new Geom_BSplineSurface(poles, sections[0]->Knots(), rails[0]->Knots(),
                                 sections[0]->Multiplicities(), rails[0]->Multiplicities(), 3, 3);
}

TopoDS_Shape blade() {
  const Handle(Geom_BSplineSurface) surface = loft();
  constexpr double kLeading = kAround / 2.0, kEnd = kSections - 1;
  BRepBuilderAPI_Sewing sewing(1e-4);
  // Back and face, which meet smoothly at both edges.
  sewing.Add(BRepBuilderAPI_MakeFace(surface, 0, kLeading, 0, kEnd, 1e-6).Face());
  sewing.Add(BRepBuilderAPI_MakeFace(surface, kLeading, kAround, 0, kEnd, 1e-6).Face());
  for (const double end : {0.0, kEnd}) {
    const Handle(Geom_Curve) rim = surface->VIso(end);
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(rim, 0, kLeading).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(rim, kLeading, kAround).Edge());
    sewing.Add(BRepBuilderAPI_MakeFace(wire.Wire(), Standard_True).Face());
  }
  sewing.Perform();
  TopoDS_Solid solid =
      BRepBuilderAPI_MakeSolid(
          TopoDS::Shell(TopExp_Explorer(sewing.SewedShape(), TopAbs_SHELL).Current()))
          .Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
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
