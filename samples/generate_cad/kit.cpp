#include "kit.h"

#include <BOPAlgo_Builder.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_Surface.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <numbers>
#include <stdexcept>

namespace burin::samples {
namespace {

constexpr double kSmooth = 0.02;  // sine of the angle below which an edge counts as smooth

TopTools_ListOfShape list(auto first, auto last) {
  TopTools_ListOfShape shapes;
  for (; first != last; ++first) shapes.Append(*first);
  return shapes;
}

/// Faces of one surface and edges of one curve become one.
TopoDS_Shape unified(const TopoDS_Shape& shape) {
  ShapeUpgrade_UnifySameDomain unify(shape, Standard_True, Standard_True, Standard_False);
  unify.Build();
  return unify.Shape();
}

gp_Vec outward(const TopoDS_Face& face, const TopoDS_Edge& edge, double t) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  const gp_Pnt2d uv = curve->Value(t);
  GeomLProp_SLProps properties(BRep_Tool::Surface(face), uv.X(), uv.Y(), 1, 1e-9);
  gp_Vec n(properties.Normal());
  if (face.Orientation() == TopAbs_REVERSED) n.Reverse();
  return n;
}

EdgeView view_of(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces) {
  const BRepAdaptor_Curve curve(edge);
  const double t = 0.5 * (curve.FirstParameter() + curve.LastParameter());
  EdgeView view;
  gp_Vec d;
  curve.D1(t, view.middle, d);
  view.direction = gp_Dir(d);
  view.line = curve.GetType() == GeomAbs_Line;
  if (faces.Extent() != 2) return view;
  const TopoDS_Face& a = TopoDS::Face(faces.First());
  const gp_Vec na = outward(a, edge, t), nb = outward(TopoDS::Face(faces.Last()), edge, t);
  // The edge as the first face runs along it, its material on the left.
  for (TopExp_Explorer it(a, TopAbs_EDGE); it.More(); it.Next()) {
    if (it.Current().IsSame(edge) && it.Current().Orientation() == TopAbs_REVERSED) d.Reverse();
  }
  const double turn = na.Crossed(nb).Dot(d) / d.Magnitude();
  view.smooth = std::abs(turn) < kSmooth;
  view.convex = turn > 0;
  return view;
}

/// A fillet within 0.001 mm: finer ones take a hundred times the space.
struct Fillet : BRepFilletAPI_MakeFillet {
  explicit Fillet(const TopoDS_Shape& shape) : BRepFilletAPI_MakeFillet(shape) {
    SetParams(1e-2, 1e-3, 1e-4, 1e-3, 1e-4, 1e-3);
  }
};

template <class Maker>
TopoDS_Shape blended(const TopoDS_Shape& shape, double size,
                     const std::function<bool(const EdgeView&)>& choose) {
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, edges);
  Maker maker(shape);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.FindKey(i));
    if (BRep_Tool::Degenerated(edge) || edges(i).Extent() != 2) continue;
    const EdgeView view = view_of(edge, edges(i));
    if (!view.smooth && choose(view)) maker.Add(size, edge);
  }
  maker.Build();
  if (!maker.IsDone())
    throw std::runtime_error("edges cannot be blended with " + std::to_string(size));
  return maker.Shape();
}

}  // namespace

TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high) {
  return BRepPrimAPI_MakeBox(low, high).Shape();
}

TopoDS_Shape cylinder(const gp_Pnt& base, const gp_Dir& axis, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(base, axis), radius, height).Shape();
}

TopoDS_Shape prism(const std::vector<gp_Pnt>& polygon, const gp_Vec& sweep) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& p : polygon) wire.Add(p);
  wire.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), sweep).Shape();
}

TopoDS_Shape turned(const std::vector<std::pair<double, double>>& profile) {
  BRepBuilderAPI_MakePolygon wire;
  for (const auto& [radius, z] : profile) wire.Add(gp_Pnt(radius, 0, z));
  wire.Close();
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp::OZ()).Shape();
}

TopoDS_Shape fuse(const std::vector<TopoDS_Shape>& shapes) {
  BRepAlgoAPI_Fuse operation;
  operation.SetArguments(list(shapes.begin(), shapes.begin() + 1));
  operation.SetTools(list(shapes.begin() + 1, shapes.end()));
  operation.Build();
  return unified(operation.Shape());
}

TopoDS_Shape cut(const TopoDS_Shape& from, const std::vector<TopoDS_Shape>& tools) {
  BRepAlgoAPI_Cut operation;
  TopTools_ListOfShape arguments;
  arguments.Append(from);
  operation.SetArguments(arguments);
  operation.SetTools(list(tools.begin(), tools.end()));
  operation.Build();
  return unified(operation.Shape());
}

std::vector<TopoDS_Shape> round_about(const TopoDS_Shape& shape, int n, double first_angle) {
  std::vector<TopoDS_Shape> copies;
  for (int i = 0; i < n; ++i) {
    gp_Trsf turn;
    turn.SetRotation(gp::OZ(), first_angle + 2 * std::numbers::pi * i / n);
    copies.push_back(BRepBuilderAPI_Transform(shape, turn, Standard_True).Shape());
  }
  return copies;
}

TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius,
                     const std::function<bool(const EdgeView&)>& choose) {
  return blended<Fillet>(shape, radius, choose);
}

TopoDS_Shape chamfered(const TopoDS_Shape& shape, double size,
                       const std::function<bool(const EdgeView&)>& choose) {
  return blended<BRepFilletAPI_MakeChamfer>(shape, size, choose);
}

}  // namespace burin::samples
