// Wires that go round a surface more often than their face does.
#include "brep_checks.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Circle.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <fmt/format.h>
#include <gp.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace burin {
namespace {

constexpr double kTurn = 2 * std::numbers::pi, kQuarter = std::numbers::pi / 2;
constexpr double kTolerance = 1e-7;

Handle(Geom2d_Line) along_u(double from, double v) {
  return new Geom2d_Line(gp_Pnt2d(from, v), gp_Dir2d(1, 0));
}
Handle(Geom2d_Line) along_v(double u) { return new Geom2d_Line(gp_Pnt2d(u, 0), gp_Dir2d(0, 1)); }

/// The round end of a pin, a quarter of a circle of 1 mm turned round z at 2 mm, with a circle at
/// both ends and a seam. The curve of the upper circle is `turns` farther than those beside it;
/// what lies between is called points, or nothing is there.
class PinEnd {
 public:
  explicit PinEnd(int turns, bool points = true) {
    const Handle(Geom_Circle) arc =
        new Geom_Circle(gp_Ax2(gp_Pnt(2, 0, 0), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0)), 1);
    const Handle(Geom_TrimmedCurve) meridian = new Geom_TrimmedCurve(arc, 0, kQuarter);
    builder_.MakeFace(face_, new Geom_SurfaceOfRevolution(meridian, gp::OZ()), kTolerance);
    const TopoDS_Vertex low = vertex({3, 0, 0}), high = vertex({2, 0, 1});
    const TopoDS_Edge below = circle(3, 0, low, 0), above = circle(2, 1, high, kTurn * turns);
    TopoDS_Edge seam;
    builder_.MakeEdge(seam, meridian, kTolerance);
    builder_.UpdateEdge(seam, along_v(kTurn), along_v(0), face_, kTolerance);
    bound(seam, 0, kQuarter, low, high);
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    builder_.Add(wire, below);
    builder_.Add(wire, seam);
    if (turns != 0 && points) builder_.Add(wire, point(kTurn, turns * kTurn, high));
    builder_.Add(wire, above.Reversed());
    if (turns != 0 && points) builder_.Add(wire, point(turns * kTurn, -turns * kTurn, high));
    builder_.Add(wire, seam.Reversed());
    builder_.Add(face_, wire);
  }
  const TopoDS_Face& face() const { return face_; }

 private:
  TopoDS_Vertex vertex(const gp_Pnt& at) {
    TopoDS_Vertex v;
    builder_.MakeVertex(v, at, kTolerance);
    return v;
  }
  void bound(TopoDS_Edge& edge, double first, double last, const TopoDS_Vertex& from,
             const TopoDS_Vertex& to) {
    builder_.Add(edge, from.Oriented(TopAbs_FORWARD));
    builder_.Add(edge, to.Oriented(TopAbs_REVERSED));
    builder_.Range(edge, first, last);
  }
  TopoDS_Edge circle(double radius, double z, const TopoDS_Vertex& at, double from) {
    TopoDS_Edge edge;
    builder_.MakeEdge(edge, new Geom_Circle(gp_Ax2(gp_Pnt(0, 0, z), gp::DZ()), radius), kTolerance);
    builder_.UpdateEdge(edge, along_u(from, z * kQuarter), face_, kTolerance);
    bound(edge, 0, kTurn, at, at);
    return edge;
  }
  /// From u, so far along.
  TopoDS_Edge point(double u, double by, const TopoDS_Vertex& at) {
    TopoDS_Edge edge;
    builder_.MakeEdge(edge);
    const Handle(Geom2d_Line) line =
        new Geom2d_Line(gp_Pnt2d(u, kQuarter), gp_Dir2d(by > 0 ? 1 : -1, 0));
    builder_.UpdateEdge(edge, line, face_, kTolerance);
    bound(edge, 0, std::abs(by), at, at);
    builder_.Degenerated(edge, true);
    return edge;
  }

  BRep_Builder builder_;
  TopoDS_Face face_;
};

TEST(BrepTurns, CurvesInOtherTurnsAreBroughtBack) {
  // Pappus: the arc's length, and its middle at 2 + 2 / pi from the axis.
  const double exact = kQuarter * kTurn * (2 + 2 / std::numbers::pi);
  for (const auto& [turns, points] :
       {std::pair(0, true), std::pair(1, true), std::pair(2, true), std::pair(-1, true),
        std::pair(1, false), std::pair(-2, false)}) {
    SCOPED_TRACE(fmt::format("{} turns, points {}", turns, points));
    const auto model = make_brep_model(PinEnd(turns, points).face());
    const BrepCounts counts = model->counts();
    EXPECT_EQ(counts.faces, 1);
    EXPECT_EQ(counts.edges, 3);
    EXPECT_EQ(counts.free_edges, 2);
    RunContext context;
    Diagnostics said;
    const auto mesh = model->tessellate(1e-3, context, &said);
    EXPECT_TRUE(said.empty());
    EXPECT_TRUE(mesh->loose.empty());
    EXPECT_EQ(test::defects(*model, *mesh), "");
    EXPECT_NEAR(test::area(*mesh), exact, 2e-3 * exact);
  }
}

TEST(BrepTurns, AWireOutOfOrderIsNotFolded) {
  // All of a torus: its circles stand side by side in the wire, a whole turn apart.
  const Handle(Geom_ToroidalSurface) surface = new Geom_ToroidalSurface(gp::XOY(), 3, 1);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, kTolerance);
  std::vector<TopoDS_Shape> edges;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) edges.push_back(it.Current());
  ASSERT_EQ(edges.size(), 4u);
  const TopoDS_Shape first = edges[0];
  std::stable_partition(edges.begin(), edges.end(),
                        [&](const TopoDS_Shape& e) { return e.IsSame(first); });
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Shape& edge : edges) builder.Add(wire, edge);
  TopoDS_Shape mixed = face.EmptyCopied();
  builder.Add(mixed, wire);
  RunContext context;
  const auto mesh = make_brep_model(mixed)->tessellate(1e-2, context, nullptr);
  const double exact = kTurn * kTurn * 3;
  EXPECT_NEAR(test::area(*mesh), exact, 2e-2 * exact);
}

}  // namespace
}  // namespace burin
