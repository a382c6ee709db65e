// IGES, BREP, and how formats are told apart.
#include "cad_files.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>

#include <utility>

namespace burin {
namespace {

using test::CadDocument;

class OtherFormats : public test::CadTest {
 protected:
  /// That a file holds one closed box of 3 x 4 x 5 mm.
  void expect_closed_box(const std::string& file, const std::string& format) {
    SCOPED_TRACE(file);
    const FileInfo info = inspect(file);
    EXPECT_EQ(info.format, format);
    ASSERT_EQ(info.parts.size(), 1u);
    EXPECT_EQ(info.parts[0].faces, 6);
    EXPECT_EQ(info.parts[0].edges, 12);
    EXPECT_TRUE(info.parts[0].closed());
    EXPECT_NEAR(info.parts[0].volume, 60, 1e-6);
    test::expect_box(info.parts[0].bounds, {0, 0, 0}, {3, 4, 5});
    EXPECT_EQ(read(file).parts.size(), 1u);
  }
};

TEST_F(OtherFormats, FacesOfIgesAreSewn) {
  CadDocument document;
  document.part(test::solid_box(3, 4, 5), "box", "#ff0000");
  // Mode 0: trimmed surfaces that know nothing of each other; 1: a solid.
  for (const int mode : {0, 1}) {
    Interface_Static::SetIVal("write.iges.brep.mode", mode);
    expect_closed_box(document.iges(folder_ / "box.igs"), "IGES");
  }
  Interface_Static::SetIVal("write.iges.brep.mode", 0);
  EXPECT_EQ(read(folder_ / "box.igs").parts.at(0).color, "#ff0000");
}

TEST_F(OtherFormats, SurfacesOfIgesThatNobodyPutTogetherAreOnePart) {
  // Roots that stand side by side: the faces of a box, and a plate apart.
  Interface_Static::SetIVal("write.iges.brep.mode", 0);
  IGESControl_Controller::Init();
  IGESControl_Writer writer("MM", 0);
  for (TopExp_Explorer it(test::boxes_in_a_row(2), TopAbs_FACE); it.More(); it.Next()) {
    writer.AddShape(it.Current());
  }
  writer.ComputeModel();
  const std::string file = folder_ / "faces.igs";
  ASSERT_TRUE(writer.Write(file.c_str()));
  const Scene scene = read(file);
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "faces");
  EXPECT_EQ(scene.parts[0].pieces.size(), 2u);
  const FileInfo info = inspect(file);
  EXPECT_EQ(info.total().faces, 12);
  EXPECT_TRUE(info.total().closed());
  EXPECT_NEAR(info.total().volume, 3, 1e-6);
}

TEST_F(OtherFormats, AGroupOfIgesWhoseMembersHaveNamesIsAnAssembly) {
  CadDocument document;
  const TDF_Label top = document.assembly("hinge");
  const TDF_Label bolt = document.part(test::solid_box(1, 1, 5), "bolt", "#ff0000");
  document.use(top, document.part(test::solid_box(9, 9, 1), "plate", "#00ff00"), gp_Trsf(),
               "plate");
  document.use(top, bolt, test::moved(1, 1, 1), "bolt 1");
  document.use(top, bolt, test::moved(6, 1, 1), "bolt 2");
  // OCCT's writer loses the names of solids, not those of groups of faces.
  Interface_Static::SetIVal("write.iges.brep.mode", 0);
  const std::string file = document.iges(folder_ / "hinge.igs");
  const Scene scene = read(file);
  ASSERT_EQ(scene.parts.size(), 3u);
  const std::vector<std::string> names = {"plate", "bolt 1", "bolt 2"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(scene.parts[i].name, names[i]);
    EXPECT_EQ(scene.parts[i].assembly, std::vector<std::string>{"hinge"});
    EXPECT_EQ(scene.parts[i].color, i == 0 ? "#00ff00" : "#ff0000");
  }
  test::expect_box(scene.parts[2].form->bounds(Mat3(1)), {6, 1, 1}, {7, 2, 6});
  EXPECT_TRUE(inspect(file).total().closed());
}

TEST_F(OtherFormats, AGroupOfIgesWithoutNamesInsideIsOnePart) {
  CadDocument document;
  document.part(test::boxes_in_a_row(3), "comb");
  const Scene scene = read(document.iges(folder_ / "comb.igs"));
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "comb");
  EXPECT_EQ(scene.parts[0].pieces.size(), 3u);
}

TEST_F(OtherFormats, BrepIsReadAsTextAndBinary) {
  const std::string text = folder_ / "lever.brep", binary = folder_ / "lever.brp";
  ASSERT_TRUE(BRepTools::Write(test::solid_box(3, 4, 5), text.c_str()));
  ASSERT_TRUE(BinTools::Write(test::solid_box(3, 4, 5), binary.c_str()));
  expect_closed_box(text, "BREP (text)");
  expect_closed_box(binary, "BREP (binary)");
  EXPECT_EQ(read(text).parts[0].name, "lever");
}

TEST_F(OtherFormats, WiresBesideSolidsAreLeftOutAndTold) {
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(gp_Pnt(9, 0, 0), gp_Pnt(9, 1, 0));
  TopoDS_Compound all;
  BRep_Builder().MakeCompound(all);
  BRep_Builder().Add(all, test::solid_box(3, 4, 5));
  BRep_Builder().Add(all, BRepBuilderAPI_MakeWire(edge).Wire());
  BRep_Builder().Add(all, BRepBuilderAPI_MakeEdge(gp_Pnt(9, 2, 0), gp_Pnt(9, 3, 0)).Edge());
  BRep_Builder().Add(all, BRepBuilderAPI_MakeVertex(gp_Pnt(9, 4, 0)).Vertex());
  const std::string brep = folder_ / "wires.brep";
  ASSERT_TRUE(BRepTools::Write(all, brep.c_str()));
  CadDocument document;
  document.part(test::solid_box(3, 4, 5), "box");
  document.part(BRepBuilderAPI_MakeWire(edge).Wire(), "wire");
  CadDocument mixed;
  mixed.part(all, "mixed");
  for (const auto& [file, count] :
       {std::pair(brep, 3), std::pair(document.step(folder_ / "a.step"), 1),
        std::pair(mixed.step(folder_ / "b.step"), 3)}) {
    const Scene scene = read(file);
    EXPECT_EQ(scene.parts.size(), 1u) << file;
    ASSERT_EQ(scene.diagnostics.entries().size(), 1u) << file;
    EXPECT_EQ(scene.diagnostics.entries()[0].code, "cad.no_faces");
    EXPECT_EQ(scene.diagnostics.entries()[0].severity, Severity::Warning);
    EXPECT_EQ(scene.diagnostics.entries()[0].count, count) << file;
  }
  const std::string reported = read(folder_ / "a.step").diagnostics.entries()[0].message;
  EXPECT_NE(reported.find("are in 'wire'"), reported.npos) << reported;
}

TEST_F(OtherFormats, IgesThatIsPackedOrPiped) {
  CadDocument document;
  document.part(test::solid_box(3, 4, 5), "box");
  const std::string file = document.iges(folder_ / "box.igs");
  const std::string pack = "gzip -c '" + file + "' > '" + folder_ / "box.igsz" + "'";
  ASSERT_EQ(std::system(pack.c_str()), 0);  // NOLINT(cert-env33-c): a test's own file
  expect_closed_box(folder_ / "box.igsz", "IGES");
}

TEST_F(OtherFormats, ContentGoesBeforeTheSuffix) {
  CadDocument document;
  document.part(test::solid_box(3, 4, 5), "box");
  const std::string step = test::slurp(document.step(folder_ / "box.step"));
  expect_closed_box(folder_.write("wrong.brep", step), "STEP (AP214)");
  expect_closed_box(folder_.write("none", "/* a note */\r\n  " + step), "STEP (AP214)");
  EXPECT_TRUE(is_cad_content(step));
  EXPECT_FALSE(is_cad_content("solid box\nfacet normal 0 0 1\n"));
  EXPECT_FALSE(is_cad_content(""));
  for (const char* name : {"a.step", "a.STP", "a.p21", "a.igs", "a.IGES", "a.brep", "a.brp"}) {
    EXPECT_TRUE(is_cad_suffix(name)) << name;
  }
  EXPECT_FALSE(is_cad_suffix("a.stl"));
}

}  // namespace
}  // namespace burin
