#include "trimmed_face.h"

#include <burin/base/error.h>

#include "spline_to_occt.h"
#include "trim_loops.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <Standard_RangeError.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Shares of the size: corners that are one point (text prints six digits), and how far borders in
/// space may lie from the trimming curves on the surface.
constexpr double kOnePoint = 1e-6, kBorder = 1e-7;

/// Makes the wires of one face.
class FaceOnSurface {
 public:
  explicit FaceOnSurface(const Handle(Geom_BSplineSurface) & surface);
  TopoDS_Face face(const TrimRegion& region);

 private:
  gp_Pnt at(const Handle(Geom2d_BSplineCurve) & curve, double t) const {
    const gp_Pnt2d uv = curve->Value(t);
    return surface_->Value(uv.X(), uv.Y());
  }
  bool degenerate(const Handle(Geom2d_BSplineCurve) & curve) const;
  TopoDS_Vertex vertex(const gp_Pnt& p);
  TopoDS_Wire wire(const LoopCurves& curves);
  TopoDS_Edge edge(const Handle(Geom2d_BSplineCurve) & curve);
  void measure(const TopoDS_Edge& edge);

  Handle(Geom_BSplineSurface) surface_;
  double one_point_ = 0, border_ = 0;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<gp_Pnt> points_;
};

FaceOnSurface::FaceOnSurface(const Handle(Geom_BSplineSurface) & surface) : surface_(surface) {
  Bnd_Box box;
  for (int i = 1; i <= surface->NbUPoles(); ++i) {
    for (int j = 1; j <= surface->NbVPoles(); ++j) box.Add(surface->Pole(i, j));
  }
  const double size = std::sqrt(box.SquareExtent());
  one_point_ = std::max(kOnePoint * size, Precision::Confusion());
  border_ = std::max(kBorder * size, Precision::Confusion());
}

bool FaceOnSurface::degenerate(const Handle(Geom2d_BSplineCurve) & curve) const {
  constexpr int kSamples = 8;
  const double from = curve->FirstParameter(), to = curve->LastParameter();
  const gp_Pnt first = at(curve, from);
  for (int i = 1; i <= kSamples; ++i) {
    if (first.Distance(at(curve, from + (to - from) * i / kSamples)) > one_point_) return false;
  }
  return true;
}

/// Corners at one place are one vertex: also where the surface closes.
TopoDS_Vertex FaceOnSurface::vertex(const gp_Pnt& p) {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (points_[i].Distance(p) <= one_point_) return vertices_[i];
  }
  points_.push_back(p);
  vertices_.emplace_back();
  builder_.MakeVertex(vertices_.back(), p, one_point_);
  return vertices_.back();
}

TopoDS_Edge FaceOnSurface::edge(const Handle(Geom2d_BSplineCurve) & curve) {
  const double from = curve->FirstParameter(), to = curve->LastParameter();
  const bool point = degenerate(curve);
  TopoDS_Edge edge;
  builder_.MakeEdge(edge);
  builder_.UpdateEdge(edge, curve, surface_, TopLoc_Location(), border_);
  const TopoDS_Vertex first = vertex(at(curve, from));
  const TopoDS_Vertex last = point ? first : vertex(at(curve, to));
  builder_.Add(edge, first.Oriented(TopAbs_FORWARD));
  builder_.Add(edge, last.Oriented(TopAbs_REVERSED));
  builder_.Range(edge, from, to);
  if (point) {
    builder_.Degenerated(edge, true);
  } else if (!BRepLib::BuildCurve3d(edge, border_)) {
    throw GeometryError("a trimming curve has no border in space");
  }
  return edge;
}

TopoDS_Wire FaceOnSurface::wire(const LoopCurves& curves) {
  TopoDS_Wire wire;
  builder_.MakeWire(wire);
  for (const auto& curve : curves) builder_.Add(wire, edge(curve));
  wire.Closed(true);
  return wire;
}

/// States that the border in space and the curve on the surface have one parameter, with the
/// tolerance that this takes.
void FaceOnSurface::measure(const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) return;
  constexpr int kSamples = 8;  // a stretch between knots
  double from = 0, to = 0;
  const Handle(Geom_Curve) border = BRep_Tool::Curve(edge, from, to);
  const auto curve = Handle(Geom2d_BSplineCurve)::DownCast(
      BRep_Tool::CurveOnSurface(edge, surface_, TopLoc_Location(), from, to));
  double off = 0;
  for (int k = 1; k < curve->NbKnots(); ++k) {
    const double a = curve->Knot(k), b = curve->Knot(k + 1);
    for (int i = 0; i <= kSamples; ++i) {
      const double t = a + (b - a) * i / kSamples;
      off = std::max(off, border->Value(t).Distance(at(curve, t)));
    }
  }
  constexpr double kBetween = 1.1;  // samples
  const double tolerance = std::max(border_, kBetween * off);
  builder_.SameRange(edge, true);
  builder_.SameParameter(edge, true);
  builder_.UpdateEdge(edge, tolerance);
  for (TopExp_Explorer it(edge, TopAbs_VERTEX); it.More(); it.Next()) {
    builder_.UpdateVertex(TopoDS::Vertex(it.Current()), tolerance);
  }
}

TopoDS_Face FaceOnSurface::face(const TrimRegion& region) {
  vertices_.clear();
  points_.clear();
  TopoDS_Face face;
  builder_.MakeFace(face, surface_, border_);
  builder_.Add(face, wire(region.outer));
  for (const LoopCurves& hole : region.holes) builder_.Add(face, wire(hole));
  try {
    BRepLib::SameParameter(face, border_, true);
  } catch (const Standard_RangeError&) {
    // OCCT 7.8 reads beyond a table where a curve has corners. The borders were made of the curves.
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      measure(TopoDS::Edge(it.Current()));
    }
  }
  return face;
}

}  // namespace

std::vector<TopoDS_Face> FaceMaker::faces_of(const TrimmedSurface& trimmed) const {
  try {
    const Handle(Geom_BSplineSurface) surface = occt_surface(trimmed.surface);
    if (trimmed.loops.empty()) {
      return {BRepBuilderAPI_MakeFace(surface, Precision::Confusion()).Face()};
    }
    std::vector<TopoDS_Face> faces;
    for (const TrimRegion& region : trim_regions(trimmed, file, context)) {
      context.check();
      faces.push_back(FaceOnSurface(surface).face(region));
    }
    return faces;
  } catch (const GeometryError& e) {
    fail_at(file, trimmed.place, fmt::format("this trimmed surface cannot be drawn: {}", e.what()));
  }
}

}  // namespace burin
