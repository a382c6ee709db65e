#include <burin/base/error.h>

#include "brep_checks.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <thread>

namespace burin::test {
namespace {

TopoDS_Compound compound_of(std::initializer_list<TopoDS_Shape> shapes) {
  TopoDS_Compound c;
  BRep_Builder builder;
  builder.MakeCompound(c);
  for (const TopoDS_Shape& s : shapes) builder.Add(c, s);
  return c;
}

TopoDS_Face dome() {
  TColgp_Array2OfPnt p(1, 3, 1, 3);
  for (int i = 1; i <= 3; ++i) {
    for (int j = 1; j <= 3; ++j) p(i, j) = gp_Pnt(2 * i, 3 * j, i == 2 && j == 2 ? 4 : 0);
  }
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(p), 1e-7).Face();
}

/// Rows are three directions, neither unit nor orthogonal.
Mat3 skew_axes() { return glm::transpose(Mat3(1, 2, 3, -1, 1, 0.5, 0.3, -1, 1)); }

TEST(BrepModel, KindsAndDerivativesOfCharts) {
  struct Case {
    TopoDS_Shape shape;
    FaceKind kind;
  };
  for (const Case& c :
       {Case{cylinder_shape(2, 5), FaceKind::Cylinder},
        Case{BRepPrimAPI_MakeCone(3, 1, 4).Shape(), FaceKind::Cone},
        Case{BRepPrimAPI_MakeSphere(3).Shape(), FaceKind::Sphere},
        Case{BRepPrimAPI_MakeTorus(3, 1).Shape(), FaceKind::Torus},
        Case{box_shape(1, 2, 3), FaceKind::Plane}, Case{dome(), FaceKind::Freeform}}) {
    const ModelPtr model = make_brep_model(c.shape);
    const Chart& chart = model->chart(0);
    EXPECT_EQ(chart.kind(), c.kind);
    const double h = 1e-5;
    for (const Vec2 uv : {Vec2(0.3, 0.4), Vec2(0.7, 0.2)}) {
      const SurfaceDerivatives d = chart.derivatives(uv);
      const auto at = [&](double u, double v) { return chart.derivatives(uv + Vec2(u, v)); };
      EXPECT_LT(glm::distance((at(h, 0).p - at(-h, 0).p) / (2 * h), d.u), 1e-8);
      EXPECT_LT(glm::distance((at(0, h).p - at(0, -h).p) / (2 * h), d.v), 1e-8);
      EXPECT_LT(glm::distance((at(h, 0).u - at(-h, 0).u) / (2 * h), d.uu), 1e-8);
      EXPECT_LT(glm::distance((at(0, h).u - at(0, -h).u) / (2 * h), d.uv), 1e-8);
      EXPECT_LT(glm::distance((at(0, h).v - at(0, -h).v) / (2 * h), d.vv), 1e-8);
      EXPECT_LT(glm::distance(chart.position(uv), d.p), 1e-14);
    }
  }
}

// What Algorithm 1 holds candidates against.
TEST(BrepModel, ChartsOfKnownKindKnowTheirLargestArea) {
  for (const TopoDS_Shape& shape :
       {cylinder_shape(2, 5), BRepPrimAPI_MakeCone(3, 1, 4).Shape(),
        BRepPrimAPI_MakeCone(0, 2, 4).Shape(), BRepPrimAPI_MakeSphere(3).Shape(),
        BRepPrimAPI_MakeTorus(3, 1).Shape(), box_shape(1, 2, 3)}) {
    const ModelPtr model = make_brep_model(shape);
    const Chart& chart = model->chart(0);
    const ParameterBox box = chart.domain();
    constexpr int kSide = 100;
    double largest = 0;
    for (int i = 0; i <= kSide; ++i) {
      for (int j = 0; j <= kSide; ++j) {
        const SurfaceDerivatives d =
            chart.derivatives(box.min + box.size() * (Vec2(i, j) / double{kSide}));
        largest = std::max(largest, glm::length(glm::cross(d.u, d.v)));
      }
    }
    EXPECT_NEAR(chart.largest_area(), largest, 1e-12 * largest);
  }
  EXPECT_EQ(make_brep_model(dome())->chart(0).largest_area(), 0);  // the symbolic bound is its own
}

TEST(BrepModel, BoundsOfRoundShapesAreExactAlongAnyAxes) {
  const Mat3 axes = skew_axes();
  const ModelPtr ball = make_brep_model(BRepPrimAPI_MakeSphere(3).Shape());
  const ModelPtr ring = make_brep_model(BRepPrimAPI_MakeTorus(3, 1).Shape());
  const Box3 b = ball->bounds(axes), t = ring->bounds(axes);
  for (int k = 0; k < 3; ++k) {
    const Vec3 d = glm::transpose(axes)[k];
    EXPECT_NEAR(b.max[k], 3 * glm::length(d), 1e-7);
    EXPECT_NEAR(b.min[k], -3 * glm::length(d), 1e-7);
    const double far = 3 * std::hypot(d.x, d.y) + glm::length(d);
    EXPECT_NEAR(t.max[k], far, 1e-7);
    EXPECT_NEAR(t.min[k], -far, 1e-7);
  }
}

TEST(BrepModel, BoundsOfTrimmedFacesEndWhereTheyEnd) {
  const Box3 half = make_brep_model(BRepPrimAPI_MakeSphere(3, 0, 0.5).Shape())->bounds(Mat3(1));
  EXPECT_NEAR(half.min.z, 0, 1e-9);
  EXPECT_NEAR(half.max.z, 3 * std::sin(0.5), 1e-9);
  // The top of a Bezier dome: 4 * 1/2 * 1/2.
  const Box3 d = make_brep_model(dome())->bounds(Mat3(1));
  EXPECT_NEAR(d.max.z, 1, 1e-7);
  EXPECT_NEAR(d.min.z, 0, 1e-12);
  const Box3 box = make_brep_model(box_shape(1, 2, 3))->bounds(Mat3(1));
  EXPECT_EQ(box.min, Vec3(0));
  EXPECT_LT(glm::distance(box.max, Vec3(1, 2, 3)), 1e-12);
}

// Round faces that are cut off between two samples: their surfaces go on beyond the cut.
TEST(BrepModel, BoundsOfRoundedBlocksEndAtTheirCuts) {
  const TopoDS_Shape block = filleted_box_shape(0.4);  // 2 mm high
  for (const double height : {1.61, 1.7, 1.8, 1.9, 1.99}) {
    const TopoDS_Shape above = BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, height), gp_Pnt(5, 4, 3)).Shape();
    const Box3 box = make_brep_model(BRepAlgoAPI_Cut(block, above).Shape())->bounds(Mat3(1));
    EXPECT_LT(glm::distance(box.max, Vec3(4, 3, height)), 1e-7) << height;
    EXPECT_LT(glm::distance(box.min, Vec3(0)), 1e-7) << height;
  }
  // A slot leaves two pieces of a ball on either side of its pole.
  const TopoDS_Shape slot = BRepPrimAPI_MakeBox(gp_Pnt(-0.5, -9, 0), gp_Pnt(0.5, 9, 9)).Shape();
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(3).Shape();
  const Box3 box = make_brep_model(BRepAlgoAPI_Cut(ball, slot).Shape())->bounds(Mat3(1));
  EXPECT_NEAR(box.max.z, std::sqrt(9 - 0.25), 1e-7);
  EXPECT_NEAR(box.min.z, -3, 1e-7);
}

TEST(BrepModel, CountsAndClosedness) {
  const BrepCounts box = count(*make_brep_model(box_shape(1, 2, 3)));
  EXPECT_EQ(box.solids, 1);
  EXPECT_EQ(box.shells, 1);
  EXPECT_EQ(box.faces, 6);
  EXPECT_EQ(box.edges, 12);
  EXPECT_EQ(box.free_edges, 0);
  EXPECT_TRUE(box.closed);
  const BrepCounts sheet = count(*make_brep_model(dome()));
  EXPECT_EQ(sheet.free_edges, 4);
  EXPECT_FALSE(sheet.closed);
}

TEST(BrepModel, LocationsAreBakedIn) {
  gp_Trsf move;
  move.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)), 0.8);
  TopoDS_Shape shape = filleted_box_shape(0.3);
  RunContext context;
  const double volume_there = volume(*make_brep_model(shape)->tessellate(0.01, context, nullptr));
  shape.Move(TopLoc_Location(move));
  const ModelPtr model = make_brep_model(compound_of({shape}));
  const auto mesh = model->tessellate(0.01, context, nullptr);
  EXPECT_EQ(defects(*model, *mesh), "");
  EXPECT_NEAR(volume(*mesh), volume_there, 1e-9 * volume_there);
}

TEST(BrepModel, TheSameTrianglesWhateverWasAskedForBefore) {
  const TopoDS_Shape shape = filleted_box_shape(0.3);
  const ModelPtr a = make_brep_model(shape), b = make_brep_model(shape);
  RunContext context;
  for (const double t : {0.1, 0.001, 0.03, 0.3, 0.0007}) a->tessellate(t, context, nullptr);
  const auto m = a->tessellate(0.01, context, nullptr), n = b->tessellate(0.01, context, nullptr);
  EXPECT_EQ(m->positions, n->positions);
  EXPECT_EQ(m->triangles, n->triangles);
  EXPECT_EQ(m->uv, n->uv);
  EXPECT_EQ(a->tessellate(0.01, context, nullptr), m);  // kept
}

TEST(BrepModel, ManyThreadsGetTheSame) {
  const TopoDS_Shape shape = plate_with_hole_shape();
  const ModelPtr model = make_brep_model(compound_of({shape, dome()}));
  const std::vector<double> tolerances{0.1, 0.02, 0.05, 0.01};
  std::vector<std::shared_ptr<const ChartMesh>> got(8);
  std::vector<double> sums(8, 0.0);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < got.size(); ++i) {
    threads.emplace_back([&, i] {
      RunContext context;
      got[i] = model->tessellate(tolerances[i % 4], context, nullptr);
      for (const ChartMesh::Border& b : got[i]->borders) {
        sums[i] += glm::length(model->on_coedge(b.coedge, b.t0));
      }
      for (std::size_t h = 0; h < got[i]->uv.size(); ++h) {
        sums[i] += model->chart(got[i]->face[h / 3]).derivatives(got[i]->uv[h]).u.x;
      }
    });
  }
  for (std::thread& t : threads) t.join();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(got[i]->positions, got[i + 4]->positions);
    EXPECT_EQ(sums[i], sums[i + 4]);
    EXPECT_EQ(defects(*model, *got[i]), "");
  }
}

TEST(BrepModel, ReadsItsOwnText) {
  std::ostringstream out;
  BRepTools::Write(plate_with_hole_shape(), out);
  EXPECT_EQ(count(*brep_from_text(out.str())).faces, 7);
  EXPECT_THROW(brep_from_text("solid nonsense"), Error);
  EXPECT_THROW(brep_from_text(""), Error);
  // Cut off in the middle: an error or what is left, but no crash.
  try {
    EXPECT_LE(count(*brep_from_text(out.str().substr(0, out.str().size() / 2))).faces, 7);
  } catch (const Error&) {
  }
}

TEST(BrepBroken, NoFaces) {
  EXPECT_THROW(make_brep_model(TopoDS_Shape()), GeometryError);
  EXPECT_THROW(make_brep_model(compound_of({})), GeometryError);
  EXPECT_THROW(make_brep_model(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)).Shape()),
               GeometryError);
}

TEST(BrepBroken, FacesWithoutCurvesInTheirParametersGetThem) {
  // Four edges in space and a cylinder, put together by hand.
  const double r = 2, h = 3;
  const Handle(Geom_CylindricalSurface) surface =
      new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), r);
  const gp_Circ low(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), r);
  const gp_Circ high(gp_Ax2(gp_Pnt(0, 0, h), gp_Dir(0, 0, 1)), r);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(low, 0, 1).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(r * std::cos(1), r * std::sin(1), 0),
                                   gp_Pnt(r * std::cos(1), r * std::sin(1), h))
               .Edge());
  wire.Add(TopoDS::Edge(BRepBuilderAPI_MakeEdge(high, 0, 1).Edge().Reversed()));
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(r, 0, h), gp_Pnt(r, 0, 0)).Edge());
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, surface, 1e-7);
  builder.Add(face, wire.Wire());
  const ModelPtr model = make_brep_model(face);
  RunContext context;
  const auto mesh = model->tessellate(1e-3, context, nullptr);
  EXPECT_EQ(defects(*model, *mesh), "");
  EXPECT_NEAR(area(*mesh), r * h, 2e-3 * r * h);
}

TEST(BrepBroken, WiresThatDoNotCloseAndInfiniteFacesAreNamed) {
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(1, 0, 0), gp_Pnt(1, 1, 0)).Edge());
  BRep_Builder builder;
  TopoDS_Face open;
  builder.MakeFace(open, new Geom_Plane(gp_Pln()), 1e-7);
  builder.Add(open, wire.Wire());
  const TopoDS_Face infinite = BRepBuilderAPI_MakeFace(gp_Pln()).Face();
  const ModelPtr model = make_brep_model(compound_of({open, box_shape(1, 2, 3), infinite}));
  ASSERT_EQ(model->face_count(), 8u);
  RunContext context;
  Diagnostics diagnostics;
  const auto mesh = model->tessellate(1e-2, context, &diagnostics);
  EXPECT_NEAR(volume(*mesh), 6, 0.2);  // the open face may be drawn as far as it goes
  ASSERT_EQ(diagnostics.entries().size(), 1u);
  EXPECT_EQ(diagnostics.entries()[0].code, "brep.face_not_meshed");
  EXPECT_NE(diagnostics.entries()[0].message.find('7'), std::string::npos);
  EXPECT_THROW(make_brep_model(infinite)->tessellate(1e-2, context, nullptr), GeometryError);
}

TEST(BrepBroken, EdgesWithThreeFacesArePartedIntoManifolds) {
  // Two boxes and a sheet that share one edge: x = 0, y = 0.
  const TopoDS_Shape box = box_shape(1, 1, 1);
  TopoDS_Edge shared;
  for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge e = TopoDS::Edge(it.Current());
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(e)),
                 b = BRep_Tool::Pnt(TopExp::LastVertex(e));
    if (std::hypot(a.X(), a.Y()) < 1e-9 && std::hypot(b.X(), b.Y()) < 1e-9) shared = e;
  }
  ASSERT_FALSE(shared.IsNull());
  const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(shared)),
               b = BRep_Tool::Pnt(TopExp::LastVertex(shared));
  const auto flap = [&](double x, double y) {
    const gp_Pnt c(b.X() + x, b.Y() + y, b.Z()), d(a.X() + x, a.Y() + y, a.Z());
    BRepBuilderAPI_MakeWire wire(shared);
    const TopoDS_Edge bc =
        BRepBuilderAPI_MakeEdge(TopExp::LastVertex(shared), BRepBuilderAPI_MakeVertex(c).Vertex())
            .Edge();
    wire.Add(bc);
    const TopoDS_Edge cd =
        BRepBuilderAPI_MakeEdge(TopExp::LastVertex(bc), BRepBuilderAPI_MakeVertex(d).Vertex())
            .Edge();
    wire.Add(cd);
    wire.Add(BRepBuilderAPI_MakeEdge(TopExp::LastVertex(cd), TopExp::FirstVertex(shared)).Edge());
    return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
  };
  const ModelPtr model = make_brep_model(compound_of({box, flap(-1, 0), flap(-1, -1)}));
  RunContext context;
  const auto mesh = model->tessellate(1e-2, context, nullptr);
  EXPECT_NO_THROW(build_topology({mesh->positions, mesh->triangles}, context));
  EXPECT_NEAR(area(*mesh), 6 + 1 + std::sqrt(2.0), 1e-9);
  // The box itself stays closed: the two flaps have the open half-edges, at most four each.
  EXPECT_LE(open_half_edges(*mesh), 8);
  EXPECT_GE(open_half_edges(*mesh), 6);
}

TEST(BrepBroken, SheetsThatTouchAtAPointAloneArePartedThere) {
  // Two boxes with one corner in common, as one body: all edges are manifold, the corner is not.
  const TopoDS_Shape fused =
      BRepAlgoAPI_Fuse(box_shape(1, 1, 1),
                       BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 1), 1.0, 2.0, 3.0).Shape())
          .Shape();
  const ModelPtr model = make_brep_model(fused);
  ASSERT_EQ(model->face_count(), 12u);
  RunContext context;
  const auto mesh = model->tessellate(1e-2, context, nullptr);
  EXPECT_EQ(mesh->positions.size(), 16u);
  EXPECT_NO_THROW(build_topology({mesh->positions, mesh->triangles}, context));
  EXPECT_EQ(open_half_edges(*mesh), 0);
  EXPECT_NEAR(volume(*mesh), 7, 1e-9);
}

TEST(BrepBroken, InsideOutSolidsAreTurned) {
  const ModelPtr model = make_brep_model(box_shape(1, 2, 3).Reversed());
  RunContext context;
  const auto mesh = model->tessellate(1e-2, context, nullptr);
  EXPECT_NEAR(volume(*mesh), 6, 1e-9);
  EXPECT_EQ(defects(*model, *mesh), "");
}

TEST(BrepModel, CancelEndsTheMesher) {
  const ModelPtr model = make_brep_model(filleted_box_shape(0.3));
  RunContext context;
  context.cancel();
  EXPECT_THROW(model->tessellate(1e-3, context, nullptr), Cancelled);
  RunContext again;
  EXPECT_NO_THROW(model->tessellate(1e-3, again, nullptr));
}

}  // namespace
}  // namespace burin::test
