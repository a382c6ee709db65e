/// Faces that fail, at every stage of building: the rest is drawn as ever, and they are named.

#include <burin/base/error.h>
#include <burin/forms/brep/realise_faces.h>
#include <burin/illustrate/illustrate.h>

#include "brep_checks.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <sstream>

namespace burin {
namespace {

using test::ModelPtr;

TopoDS_Compound compound(std::initializer_list<TopoDS_Shape> shapes) {
  TopoDS_Compound c;
  BRep_Builder builder;
  builder.MakeCompound(c);
  for (const TopoDS_Shape& s : shapes) builder.Add(c, s);
  return c;
}

/// A chart that evaluates until it is asked for what it shall throw at, or one that lies elsewhere
/// than the edges of its face.
class BrokenChart final : public Chart {
 public:
  enum class At { Positions, Everything, Beside };
  BrokenChart(std::shared_ptr<const Chart> inner, At at) : inner_(std::move(inner)), at_(at) {}
  ParameterBox domain() const override { return inner_->domain(); }
  Vec2 period() const override { return inner_->period(); }
  FaceKind kind() const override { return inner_->kind(); }
  Vec3 position(Vec2 uv) const override {
    if (at_ != At::Beside) throw GeometryError("a broken chart");
    return inner_->position(uv) + kBeside;
  }
  SurfaceDerivatives derivatives(Vec2 uv) const override {
    if (at_ == At::Everything) throw std::logic_error("a broken chart");
    SurfaceDerivatives d = inner_->derivatives(uv);
    if (at_ == At::Beside) d.p += kBeside;
    return d;
  }

 private:
  static constexpr Vec3 kBeside{0, 0, 0.5};
  std::shared_ptr<const Chart> inner_;
  At at_;
};

/// The model of a shape whose charts come from that of a whole one, that of `face` broken.
ModelPtr broken_model(const TopoDS_Shape& shape, std::int32_t face, BrokenChart::At at) {
  const ModelPtr whole = make_brep_model(shape);
  std::int32_t next = 0;
  return std::make_shared<const BrepModel>(
      shape, [&, whole](const Handle(Geom_Surface)&, const ParameterBox&) {
        const std::int32_t f = next++;
        std::shared_ptr<const Chart> chart(whole, &whole->chart(f));
        if (f != face) return chart;
        return std::shared_ptr<const Chart>(std::make_shared<BrokenChart>(chart, at));
      });
}

Drawing draw(std::vector<std::shared_ptr<const Form>> forms) {
  Scene scene;
  for (auto& form : forms) scene.parts.push_back({"part", "", std::move(form)});
  ViewOptions options;
  options.direction = {1, -0.8, 0.6};
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, options);
  RunContext context;
  return illustrate(scene, camera, builtin_style("outline"), {}, context);
}

std::vector<Diagnostic> loose(const Diagnostics& all) {
  std::vector<Diagnostic> out;
  for (const Diagnostic& d : all.entries()) {
    if (d.code == "brep.face_loose") out.push_back(d);
  }
  return out;
}

void expect_names(const Diagnostics& all, const std::string& faces) {
  const auto found = loose(all);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::Warning);
  EXPECT_TRUE(found[0].message.ends_with(faces)) << found[0].message;
}

double area(const TriMesh& mesh) {
  double sum = 0;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) sum += mesh.area(f);
  return sum;
}

std::size_t faces_of(const ProxyMesh& proxy) {
  return std::set(proxy.source_face.begin(), proxy.source_face.end()).size();
}

double ink(const Drawing& drawing) {
  double sum = 0;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      for (std::size_t i = 1; i < path.points.size(); ++i) {
        sum += glm::distance(path.points[i - 1], path.points[i]);
      }
    }
  }
  return sum;
}

/// A form that realises the faces of a model with stages of the test.
class StagedForm final : public Form {
 public:
  StagedForm(ModelPtr model, FaceStages stages)
      : model_(std::move(model)), stages_(std::move(stages)) {}
  Box3 bounds(const Mat3& axes) const override { return model_->bounds(axes); }
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override {
    const auto mesh = model_->tessellate(options.tolerance, context, options.diagnostics);
    return realise_faces({model_, {}, model_->size()}, *mesh, mesh->loose, options, context,
                         stages_);
  }

 private:
  ModelPtr model_;
  FaceStages stages_;
};

bool has(const ChartMesh& mesh, std::int32_t face) {
  return std::ranges::find(mesh.face, face) != mesh.face.end();
}

/// Stages of which one fails where the faces are there.
FaceStages failing(const std::string& stage, const std::vector<std::int32_t>& faces) {
  const auto check = [faces](const ChartMesh& mesh) {
    for (const std::int32_t f : faces) {
      if (has(mesh, f)) throw std::runtime_error("no luck");
    }
  };
  FaceStages stages;
  if (stage == "normals") {
    stages.normals = [check, then = stages.normals](ChartMesh& m, const PlacedAtlas& a,
                                                    const RunContext& c) {
      check(m);
      then(m, a, c);
    };
  } else if (stage == "cut") {
    stages.cut = [check, then = stages.cut](ChartMesh& m, const PlacedAtlas& a, const Camera& v,
                                            const RunContext& c) {
      const bool found = then(m, a, v, c);
      check(m);
      return found;
    };
  } else {
    stages.join = [check, then = stages.join](PlacedAtlas a, ChartMesh m, const RunContext& c) {
      check(m);
      return then(std::move(a), std::move(m), c);
    };
  }
  return stages;
}

TEST(BrokenFaces, AStageThatFailsAtAFacePartsThatFaceAlone) {
  const ModelPtr model = make_brep_model(test::filleted_box_shape(0.4));
  const Drawing whole = draw({std::make_shared<BrepForm>(model, Placement{})});
  for (const char* stage : {"normals", "cut", "join"}) {
    for (const std::vector<std::int32_t>& faces : {std::vector<std::int32_t>{7}, {0, 11, 25}}) {
      SCOPED_TRACE(stage + std::to_string(faces.size()));
      const auto form = std::make_shared<StagedForm>(model, failing(stage, faces));
      const Drawing drawing = draw({form});
      expect_names(drawing.diagnostics, faces.size() == 1 ? ": face 7" : ": faces 0, 11, 25");
      EXPECT_EQ(drawing.parts.at(0).faces, 26);
      // Nothing is lost; the borders of the faces that are parted are drawn on top.
      EXPECT_GT(ink(drawing), 0.97 * ink(whole));
      EXPECT_LT(ink(drawing), 2 * ink(whole));
    }
  }
}

TEST(BrokenFaces, ASeamThatDoesNotMatchPartsTheFacesAtIt) {
  const ModelPtr model = make_brep_model(test::box_shape(1, 2, 3));
  RunContext context;
  const auto triangles = model->tessellate(0.01, context, nullptr);
  for (const bool turned : {false, true}) {
    SCOPED_TRACE(turned);
    ChartMesh mesh = *triangles;
    const std::size_t t =
        static_cast<std::size_t>(std::ranges::find(mesh.face, 4) - mesh.face.begin());
    if (turned) {  // against its neighbours
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    } else {  // a third triangle at three edges
      mesh.triangles.push_back(mesh.triangles[t]);
      mesh.face.push_back(4);
      for (std::size_t k = 0; k < 3; ++k) {
        mesh.uv.push_back(mesh.uv[3 * t + k]);
        mesh.border.push_back(-1);
        mesh.normal.emplace_back(0);
        mesh.on_contour.push_back(0);
      }
    }
    Diagnostics diagnostics;
    RealiseOptions options;
    options.diagnostics = &diagnostics;
    const auto surface = realise_faces({model, {}, model->size()}, mesh, {}, options, context);
    const auto found = loose(diagnostics);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LE(found[0].count, 2);
    EXPECT_EQ(faces_of(surface->proxy()), 6u);
    EXPECT_NEAR(area(surface->proxy().mesh), 22, 1e-9);
  }
}

TEST(BrokenFaces, PlacesThatAreNoNumbersPartTheirFaces) {
  const ModelPtr model = make_brep_model(test::filleted_box_shape(0.4));
  FaceStages stages;
  stages.normals = [then = stages.normals](ChartMesh& m, const PlacedAtlas& a,
                                           const RunContext& c) {
    then(m, a, c);
    if (!has(m, 3)) return;
    m.positions[m.triangles[static_cast<std::size_t>(std::ranges::find(m.face, 3) - m.face.begin())]
                           [0]]
        .x = std::numeric_limits<double>::quiet_NaN();
  };
  const Drawing drawing = draw({std::make_shared<StagedForm>(model, stages)});
  expect_names(drawing.diagnostics, ": face 3");
  EXPECT_EQ(drawing.parts.at(0).faces, 26);
}

TEST(BrokenFaces, StrokesEndWhereAPartedFaceBegins) {
  const ModelPtr model = make_brep_model(test::one_fillet_shape(2));
  RunContext context;
  const auto mesh = model->tessellate(0.01, context, nullptr);
  std::int32_t fillet = 0;
  while (model->chart(fillet).kind() != FaceKind::Cylinder) ++fillet;
  const auto surface =
      realise_faces({model, {}, model->size()}, *mesh, {}, {}, context, failing("join", {fillet}));
  const ProxyMesh& proxy = surface->proxy();
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const SurfacePoint from = surface->lift({f, Vec3(1.0 / 3)});
    EXPECT_NEAR(glm::distance(from.position, proxy.position(f, Vec3(1.0 / 3))), 0, 0.05);
    const ProxyPoint back = surface->to_proxy(from);
    EXPECT_EQ(proxy.source_face[back.face], proxy.source_face[f]);
    const Frame frame = surface->frame(from);
    const MarchStep step = surface->march(from, glm::cross(frame.normal, Vec3(0, 1, 0)), 100);
    EXPECT_NE(step.stop, MarchStop::Completed);
    const ProxyPoint end = surface->to_proxy(step.end);
    EXPECT_EQ(proxy.source_face[end.face], proxy.source_face[f]);
  }
  EXPECT_EQ(surface->wedge_frames(context).size(), proxy.wedge_vertex.size());
}

TEST(BrokenFaces, AChartThatThrowsIsDrawnFromTriangles) {
  const TopoDS_Shape shape = test::filleted_box_shape(0.4);
  const Drawing whole = draw({test::brep_form(shape)});
  const ModelPtr sound = make_brep_model(shape);
  for (const auto at : {BrokenChart::At::Positions, BrokenChart::At::Everything}) {
    std::int32_t face = 0;  // one that is bent: flat ones are not refined
    while (sound->chart(face).kind() != FaceKind::Cylinder) ++face;
    const ModelPtr model = broken_model(shape, face, at);
    const Drawing drawing = draw({std::make_shared<BrepForm>(model, Placement{})});
    expect_names(drawing.diagnostics, ": face " + std::to_string(face));
    EXPECT_EQ(drawing.parts.at(0).faces, 26);
    EXPECT_GT(ink(drawing), 0.97 * ink(whole));
  }
}

TEST(BrokenFaces, AFaceBesideItsEdgesIsDrawnFromTriangles) {
  const TopoDS_Shape shape = test::filleted_box_shape(0.4);
  const Drawing whole = draw({test::brep_form(shape)});
  const ModelPtr model = broken_model(shape, 5, BrokenChart::At::Beside);
  const Drawing drawing = draw({std::make_shared<BrepForm>(model, Placement{})});
  expect_names(drawing.diagnostics, "their edges lie up to 0.5 mm beside their surfaces): face 5");
  EXPECT_GT(ink(drawing), 0.97 * ink(whole));
  EXPECT_LT(ink(drawing), 2 * ink(whole));
}

/// A face beside a box is left out, named, and the box is whole.
void expect_left_out_beside_a_box(const TopoDS_Face& face) {
  const ModelPtr model = make_brep_model(compound({test::box_shape(1, 2, 3), face}));
  Diagnostics diagnostics;
  RunContext context;
  const auto mesh = model->tessellate(0.01, context, &diagnostics);
  EXPECT_NEAR(test::area(*mesh), 22, 1e-9);
  EXPECT_TRUE(mesh->loose.empty());
  ASSERT_EQ(diagnostics.entries().size(), 1u);
  EXPECT_EQ(diagnostics.entries()[0].code, "brep.face_not_meshed");
  EXPECT_TRUE(diagnostics.entries()[0].message.ends_with(": face 6"));
}

TEST(BrokenFaces, ASurfaceWithoutNumbersLeavesTheOthers) {
  TColgp_Array2OfPnt points(1, 8, 1, 8);
  for (int i = 1; i <= 8; ++i) {
    for (int k = 1; k <= 8; ++k) points(i, k) = gp_Pnt(i, k, 5 + std::sin(i) * std::cos(k));
  }
  const Handle(Geom_BSplineSurface) surface = GeomAPI_PointsToBSplineSurface(points).Surface();
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
  surface->SetPole(4, 4, gp_Pnt(std::numeric_limits<double>::quiet_NaN(), 4, 5));
  expect_left_out_beside_a_box(face);
}

/// A cylinder of radius 1 and height 2, whose round side comes first; the edges of that side are
/// its two rims and its seam, which it uses twice.
struct Cylinder {
  TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  TopoDS_Face side = TopoDS::Face(TopExp_Explorer(shape, TopAbs_FACE).Current());

  std::vector<TopoDS_Edge> edges(bool seam) const {
    std::vector<TopoDS_Edge> found;
    for (TopExp_Explorer e(side, TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(e.Current());
      if (BRep_Tool::IsClosed(edge, side) == seam) found.push_back(edge);
    }
    return found;
  }
};

TEST(BrokenFaces, ACurveInTheFaceWithAWildPoleIsMadeAnew) {
  const Cylinder cylinder;
  const TopoDS_Face& side = cylinder.side;
  for (const TopoDS_Edge& rim : cylinder.edges(false)) {
    // Straight as it was, but for one pole.
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) line = BRep_Tool::CurveOnSurface(rim, side, first, last);
    TColgp_Array1OfPnt2d poles(1, 5);
    for (int i = 1; i <= 5; ++i) poles(i) = line->Value(first + (last - first) * (i - 1) / 4);
    poles(3).SetY(1e30);
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = first;
    knots(2) = last;
    TColStd_Array1OfInteger times(1, 2);
    times.Init(5);
    const Handle(Geom2d_BSplineCurve) wild = new Geom2d_BSplineCurve(poles, knots, times, 4);
    BRep_Builder().UpdateEdge(rim, wild, side, 1e-7);
  }
  RunContext context;
  Diagnostics diagnostics;
  const auto mesh = make_brep_model(cylinder.shape)->tessellate(0.001, context, &diagnostics);
  EXPECT_TRUE(diagnostics.entries().empty());
  EXPECT_NEAR(test::area(*mesh), 6 * std::numbers::pi, 0.02);
}

/// A square Bezier patch of degree 5, in the plane z = 0 but for its middle, and one of its sides.
struct Patch {
  TopoDS_Face face = BRepBuilderAPI_MakeFace(surface(), 1e-7).Face();
  TopoDS_Edge side = TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current());

  static Handle(Geom_BezierSurface) surface() {
    TColgp_Array2OfPnt poles(1, 6, 1, 6);
    for (int i = 1; i <= 6; ++i) {
      for (int k = 1; k <= 6; ++k)
        poles(i, k) = gp_Pnt(i, k, (i - 1) * (6 - i) * (k - 1) * (6 - k));
    }
    return new Geom_BezierSurface(poles);
  }

  /// Moves the last pole of the curve of the side in (u,v).
  void lead_astray(gp_Pnt2d to) const {
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) line = BRep_Tool::CurveOnSurface(side, face, first, last);
    TColgp_Array1OfPnt2d poles(1, 6);
    for (int i = 1; i <= 6; ++i) poles(i) = line->Value(first + (last - first) * (i - 1) / 5);
    poles(6) = to;
    BRep_Builder().UpdateEdge(side, new Geom2d_BezierCurve(poles), face, 1e-7);
    BRep_Builder().Range(side, face, 0, 1);
  }
};

double patch_area() {
  RunContext context;
  return test::area(*make_brep_model(Patch().face)->tessellate(0.01, context, nullptr));
}

TEST(BrokenFaces, ACurveInTheFaceThatLeavesTheSurfaceIsMadeAnew) {
  for (const double u : {-2.0, 3.0, 425.0}) {
    SCOPED_TRACE(u);
    const Patch patch;
    patch.lead_astray({u, 0});
    RunContext context;
    Diagnostics diagnostics;
    const auto mesh = make_brep_model(patch.face)->tessellate(0.01, context, &diagnostics);
    EXPECT_TRUE(diagnostics.entries().empty());
    EXPECT_NEAR(test::area(*mesh), patch_area(), 1e-6 * patch_area());
  }
}

TEST(BrokenFaces, AnEdgeFarBeyondItsSurfaceIsNotMeshed) {
  // With no curve in space to go back to.
  const Patch patch;
  patch.lead_astray({425, 0});
  BRep_Builder().UpdateEdge(patch.side, Handle(Geom_Curve)(), 1e-7);
  RunContext context;
  const auto model = make_brep_model(compound({test::box_shape(1, 2, 3), patch.face}));
  const auto mesh = model->tessellate(0.01, context, nullptr);
  EXPECT_NEAR(test::area(*mesh), 22, 1e-9);
  EXPECT_LT(mesh->loose.triangles.size(), 100'000u);
}

TEST(BrokenFaces, ATornSeamIsNoWayRound) {
  // The sides of the seam lie a thousandth apart in (u,v), not the period.
  const Cylinder cylinder;
  for (const TopoDS_Edge& seam : cylinder.edges(true)) {
    const auto at = [](double u) { return new Geom2d_Line(gp_Pnt2d(u, 0), gp_Dir2d(0, 1)); };
    BRep_Builder().UpdateEdge(seam, at(0), at(1e-3), cylinder.side, 1e-7);
  }
  RunContext context;
  const auto mesh = make_brep_model(cylinder.shape)->tessellate(0.01, context, nullptr);
  EXPECT_LT(mesh->triangles.size() + mesh->loose.triangles.size(), 1000u);
  EXPECT_GT(draw({test::brep_form(cylinder.shape)}).parts.at(0).faces, 2);
}

TEST(BrokenFaces, WiresThatCrossThemselvesAreFilled) {
  BRepBuilderAPI_MakePolygon bow;
  for (const gp_Pnt& p : {gp_Pnt(0, 0, 5), gp_Pnt(2, 2, 5), gp_Pnt(2, 0, 5), gp_Pnt(0, 2, 5)}) {
    bow.Add(p);
  }
  bow.Close();
  const TopoDS_Face face =
      BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1)), bow.Wire(), false).Face();
  const ModelPtr model = make_brep_model(compound({test::box_shape(1, 2, 3), face}));
  ASSERT_EQ(model->face_count(), 7u);
  Diagnostics diagnostics;
  RunContext context;
  const auto mesh = model->tessellate(0.01, context, &diagnostics);
  expect_names(diagnostics, ": face 6");
  EXPECT_NEAR(test::area(*mesh), 22, 1e-9);
  EXPECT_NEAR(area({mesh->loose.positions, mesh->loose.triangles}), 2, 1e-9);
}

TEST(BrokenFaces, TrianglesWithoutASurfaceAreDrawn) {
  const Handle(Poly_Triangulation) t = new Poly_Triangulation(4, 2, false);
  t->SetNode(1, gp_Pnt(0, 0, 5));
  t->SetNode(2, gp_Pnt(1, 0, 5));
  t->SetNode(3, gp_Pnt(1, 1, 5));
  t->SetNode(4, gp_Pnt(0, 1, 5));
  t->SetTriangle(1, Poly_Triangle(1, 2, 3));
  t->SetTriangle(2, Poly_Triangle(1, 3, 4));
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, t);
  for (const bool alone : {true, false}) {
    SCOPED_TRACE(alone);
    const TopoDS_Shape shape =
        alone ? TopoDS_Shape(face) : compound({test::box_shape(1, 1, 1), face});
    const ModelPtr model = make_brep_model(shape);
    EXPECT_NEAR(model->bounds(Mat3(1)).max.z, 5, 1e-9);
    const Drawing drawing = draw({std::make_shared<BrepForm>(model, Placement{})});
    expect_names(drawing.diagnostics, alone ? ": face 0" : ": face 6");
    EXPECT_EQ(drawing.parts.at(0).faces, alone ? 1 : 7);
    EXPECT_GT(ink(drawing), 0);
  }
}

TEST(BrokenFaces, AFaceOfEdgesAloneIsLeftOutAndNamed) {
  BRepBuilderAPI_MakePolygon edges(gp_Pnt(0, 0, 5), gp_Pnt(1, 0, 5), gp_Pnt(1, 1, 5), true);
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face);
  builder.Add(face, edges.Wire());
  expect_left_out_beside_a_box(face);
}

TEST(BrokenFaces, APartThatCannotBeDrawnLeavesTheOthers) {
  const auto infinite = test::brep_form(BRepBuilderAPI_MakeFace(gp_Pln()).Face());
  const Drawing drawing = draw({test::brep_form(test::box_shape(1, 2, 3)), infinite});
  const auto& entries = drawing.diagnostics.entries();
  const auto found = std::ranges::find(entries, "part.not_drawn", &Diagnostic::code);
  ASSERT_NE(found, entries.end());
  EXPECT_EQ(found->severity, Severity::Error);
  EXPECT_GT(ink(drawing), 0);
  EXPECT_THROW(draw({infinite}), GeometryError);
}

TEST(BrokenFaces, ACancelIsNoFault) {
  const ModelPtr model = make_brep_model(test::box_shape(1, 2, 3));
  RunContext context;
  const auto mesh = model->tessellate(0.01, context, nullptr);
  FaceStages stages;
  int calls = 0;
  stages.normals = [&calls](ChartMesh&, const PlacedAtlas&, const RunContext&) {
    ++calls;
    throw Cancelled();
  };
  EXPECT_THROW(realise_faces({model, {}, model->size()}, *mesh, {}, {}, context, stages),
               Cancelled);
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace burin
