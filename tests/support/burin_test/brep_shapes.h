#pragma once
/// OCCT's own shapes. For tests that link OCCT.

#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax2.hxx>

#include <memory>

namespace burin::test {

inline TopoDS_Shape box_shape(double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(dx, dy, dz).Shape();
}
inline TopoDS_Shape cylinder_shape(double radius, double height) {
  return BRepPrimAPI_MakeCylinder(radius, height).Shape();
}

/// A box of 4 x 3 x 2 with all its edges rounded: 26 faces.
inline TopoDS_Shape filleted_box_shape(double radius) {
  const TopoDS_Shape box = box_shape(4, 3, 2);
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer e(box, TopAbs_EDGE); e.More(); e.Next()) {
    fillet.Add(radius, TopoDS::Edge(e.Current()));
  }
  return fillet.Shape();
}

/// A plate of 10 x 8 x 1 with a round hole of radius 2 through its middle.
inline TopoDS_Shape plate_with_hole_shape() {
  const TopoDS_Shape plate = box_shape(10, 8, 1);
  const TopoDS_Shape drill =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 4, -1), gp_Dir(0, 0, 1)), 2, 3).Shape();
  return BRepAlgoAPI_Cut(plate, drill).Shape();
}

/// A box of 10 x 10 x 5 with the one edge at x = 10, z = 5 rounded.
inline TopoDS_Shape one_fillet_shape(double radius) {
  const TopoDS_Shape box = box_shape(10, 10, 5);
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge e = TopoDS::Edge(it.Current());
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(e)),
                 b = BRep_Tool::Pnt(TopExp::LastVertex(e));
    const auto on = [](const gp_Pnt& p) { return p.X() > 9.9 && p.Z() > 4.9; };
    if (on(a) && on(b)) {
      fillet.Add(radius, e);
      break;
    }
  }
  return fillet.Shape();
}

inline std::shared_ptr<const Form> brep_form(const TopoDS_Shape& shape,
                                             const Placement& placement = {}) {
  return std::make_shared<BrepForm>(make_brep_model(shape), placement);
}

}  // namespace burin::test
