// Faces whose hole touches their outline: one wire runs along both.
#include "cad_files.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <numbers>
#include <vector>

namespace burin {
namespace {

using test::CadDocument;

class TouchingHoles : public test::CadTest {};

TopoDS_Edge circle_from(const TopoDS_Vertex& at, gp_Pnt centre, double radius) {
  // Around -z, from -x on: clockwise as a hole is.
  const gp_Circ circle(gp_Ax2(centre, gp_Dir(0, 0, -1), gp_Dir(-1, 0, 0)), radius);
  return BRepBuilderAPI_MakeEdge(circle, at, at);
}

/// A rectangle of 12 x 80 mm with two holes of radius 3 that touch its left side, and stand out by
/// as little as files round to: the wire of the outline runs round the first one, the second one
/// has a wire of its own.
TopoDS_Face plate() {
  constexpr double kBeside = 7e-8;
  std::vector<TopoDS_Vertex> corners;
  for (const gp_Pnt& p : {gp_Pnt(kBeside, 0, 0), gp_Pnt(12, 0, 0), gp_Pnt(12, 80, 0),
                          gp_Pnt(kBeside, 80, 0), gp_Pnt(0, 6, 0)}) {
    corners.push_back(BRepBuilderAPI_MakeVertex(p));
  }
  BRepBuilderAPI_MakeWire outline;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    outline.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[i + 1]));
  }
  outline.Add(circle_from(corners.back(), gp_Pnt(3, 6, 0), 3));
  outline.Add(BRepBuilderAPI_MakeEdge(corners.back(), corners.front()));
  BRepBuilderAPI_MakeFace face(gp_Pln(), outline.Wire());
  const TopoDS_Vertex apart = BRepBuilderAPI_MakeVertex(gp_Pnt(0, 70, 0));
  face.Add(BRepBuilderAPI_MakeWire(circle_from(apart, gp_Pnt(3, 70, 0), 3)).Wire());
  return face.Face();
}

TEST_F(TouchingHoles, StayHoles) {
  CadDocument document;
  document.part(plate(), "plate");
  const Scene scene = read(document.step(folder_ / "plate.step"));
  ASSERT_EQ(scene.parts.size(), 1u);
  RunContext context;
  const ShapeMeasure measure = scene.parts[0].form->measure(context);
  EXPECT_EQ(measure.faces, 1);
  EXPECT_NEAR(measure.area, 960 - 2 * 9 * std::numbers::pi, 1e-5);
  // No disc closes a hole; OCCT does not mesh such wires, so the face is drawn from coarse
  // triangles.
  const auto surface = scene.parts[0].form->realise({.tolerance = 0.001}, context);
  const TriMesh& mesh = surface->proxy().mesh;
  double area = 0;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) area += mesh.area(f);
  EXPECT_NEAR(area, 960 - 2 * 9 * std::numbers::pi, 2);
}

}  // namespace
}  // namespace burin
