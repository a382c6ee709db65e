// Names, colours, units, places and shared shapes of STEP files.
#include <burin/forms/brep/brep_form.h>

#include "cad_files.h"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>

#include <filesystem>
#include <numbers>
#include <set>

namespace burin {
namespace {

using test::CadDocument;
using Strings = std::vector<std::string>;

class Step : public test::CadTest {};

const BrepForm& form(const Part& part) { return dynamic_cast<const BrepForm&>(*part.form); }

TEST_F(Step, OnePartHasNameColourAndPlace) {
  CadDocument document;
  document.part(test::solid_box(3, 4, 5), "bracket", "#ff8040");
  const Scene scene = read(document.step(folder_ / "one.step"));
  ASSERT_EQ(scene.parts.size(), 1u);
  const Part& part = scene.parts[0];
  EXPECT_EQ(part.name, "bracket");
  EXPECT_EQ(part.color, "#ff8040");
  EXPECT_TRUE(part.assembly.empty());
  EXPECT_EQ(part.source, folder_ / "one.step");
  test::expect_box(part.form->bounds(Mat3(1)), {0, 0, 0}, {3, 4, 5});
  EXPECT_TRUE(scene.diagnostics.empty());
}

TEST_F(Step, LengthsAreMillimetresWhateverTheUnit) {
  CadDocument document;
  document.part(test::solid_box(3, 4, 5), "box");
  const std::string mm = document.step(folder_ / "mm.step");
  const std::string unit = "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )";
  const std::string metre =
      changed(mm, unit, "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.) )", "m.step");
  test::expect_box(read(metre).bounds(), {0, 0, 0}, {3000, 4000, 5000});
  const std::string inch =
      changed(mm, unit, "( CONVERSION_BASED_UNIT('INCH',#9001) LENGTH_UNIT() NAMED_UNIT(#9002) )",
              "half.step");
  const std::string whole =
      changed(inch, "DATA;\n",
              "DATA;\n#9001 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#9003);\n"
              "#9002 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
              "#9003 = ( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) );\n",
              "inch.step");
  test::expect_box(read(whole).bounds(), {0, 0, 0}, {76.2, 101.6, 127});
}

TEST_F(Step, NamesAreUnicode) {
  CadDocument document;
  document.part(test::solid_box(1, 1, 1), "Gehäuse 轴承");
  EXPECT_EQ(read(document.step(folder_ / "a.step")).parts.at(0).name, "Gehäuse 轴承");
  CadDocument plain;
  plain.part(test::solid_box(1, 1, 1), "NAME");
  const std::string file = plain.step(folder_ / "b.step");
  const auto name = [&](const std::string& coded) {
    return read(changed(file, "NAME", coded, "c.step")).parts.at(0).name;
  };
  // The control directives of ISO 10303-21.
  EXPECT_EQ(name("Geh\\X2\\00E4\\X0\\use"), "Gehäuse");
  EXPECT_EQ(name("\\X2\\8F74627F\\X0\\ 7"), "轴承 7");
  EXPECT_EQ(name("Geh\\X\\E4use"), "Gehäuse");
  EXPECT_EQ(name("Geh\\S\\duse"), "Gehäuse");
  EXPECT_EQ(name("\\X4\\0001F529\\X0\\"), "🔩");
  EXPECT_EQ(name("O''Brien"), "O'Brien");
  EXPECT_EQ(name("a\\\\b"), "a\\b");
}

TEST_F(Step, NamesThatSayNothingAreReplaced) {
  for (const char* name : {"Open CASCADE STEP translator 7.6 1", "NAUO12", "17", ""}) {
    CadDocument document;
    document.part(test::solid_box(1, 1, 1), name);
    EXPECT_EQ(read(document.step(folder_ / "lever.step")).parts.at(0).name, "lever") << name;
  }
}

TEST_F(Step, ANumberDoesNotGoBeforeTheNameOfItsProduct) {
  CadDocument document;
  const TDF_Label part = document.part(test::solid_box(1, 1, 1), "QPARTQ");
  const TDF_Label top = document.assembly("top");
  document.use(top, part, test::moved(1, 0, 0), "QUSEQ");
  const std::string file =
      changed(document.step(folder_ / "plain.step"), "PRODUCT('QPARTQ','QPARTQ'",
              "PRODUCT('4711-22','Cover plate'", "numbered.step");
  for (const auto& [instance, name] :
       {std::pair("4711-22", "Cover plate"), std::pair("4711-22.1", "Cover plate"),
        std::pair("Next assembly relationship", "Cover plate"), std::pair("NAUO3", "Cover plate"),
        std::pair("left cover", "left cover"), std::pair("4711-22 left", "4711-22 left")}) {
    const Scene scene = read(changed(file, "QUSEQ", instance, "used.step"));
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(scene.parts[0].name, name) << instance;
    EXPECT_EQ(scene.parts[0].definition, "Cover plate") << instance;
  }
}

TEST_F(Step, MembersOfAnAssemblyAreNotCalledAsTheFile) {
  // A product that has a number for its name, and one that nobody named: what an assembly holds
  // beside its members.
  for (const auto& [product, name] :
       {std::pair("4711-22", "4711-22"), std::pair("Open CASCADE STEP translator 7.6 1", "top"),
        std::pair("NAUO1", "top")}) {
    CadDocument document;
    const TDF_Label part = document.part(test::solid_box(1, 1, 1), product);
    const TDF_Label top = document.assembly("top");
    document.use(top, part, gp_Trsf(), "NAUO7");
    const Scene scene = read(document.step(folder_ / "lever.step"));
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(scene.parts[0].name, name) << product;
    EXPECT_EQ(scene.parts[0].definition, "") << product;
  }
}

/// wheel assembly: a disc twice and a pin in a subassembly that is used twice.
std::string cart(const std::string& file) {
  CadDocument document;
  const TDF_Label disc = document.part(test::solid_box(1, 2, 3), "disc", "#ff0000");
  const TDF_Label pin = document.part(test::solid_sphere(1), "pin", "#00ff00");
  const TDF_Label axle = document.assembly("axle");
  document.use(axle, disc, test::moved(0, 0, 10), "left disc");
  document.use(axle, disc, test::moved(0, 0, -10) * test::turned(90), "right disc");
  document.use(axle, pin, gp_Trsf(), "pin");
  const TDF_Label top = document.assembly("cart");
  document.use(top, axle, test::moved(100, 0, 0), "front axle");
  const TDF_Label rear =
      document.use(top, axle, test::moved(0, 50, 0) * test::turned(90), "rear axle");
  (void)rear;
  return document.step(file);
}

TEST_F(Step, AssembliesKeepNamesAndPlaces) {
  const Scene scene = read(cart(folder_ / "cart.step"));
  ASSERT_EQ(scene.parts.size(), 6u);
  const Strings names = {"left disc", "right disc", "pin", "left disc", "right disc", "pin"};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(scene.parts[i].name, names[i]);
    EXPECT_EQ(scene.parts[i].assembly, (Strings{"cart", i < 3 ? "front axle" : "rear axle"}));
    EXPECT_EQ(scene.parts[i].color, i % 3 == 2 ? "#00ff00" : "#ff0000");
  }
  const auto box = [&](std::size_t i) { return scene.parts[i].form->bounds(Mat3(1)); };
  test::expect_box(box(0), {100, 0, 10}, {101, 2, 13});
  test::expect_box(box(1), {98, 0, -10}, {100, 1, -7});
  test::expect_box(box(2), {99, -1, -1}, {101, 1, 1}, 1e-4);
  // (x, y) -> (-y, 50 + x)
  test::expect_box(box(3), {-2, 50, 10}, {0, 51, 13});
  test::expect_box(box(4), {-1, 48, -10}, {0, 50, -7});
  test::expect_box(box(5), {-1, 49, -1}, {1, 51, 1}, 1e-4);
}

TEST_F(Step, InstancesShareOneShape) {
  const std::string file = cart(folder_ / "cart.step");
  const Scene scene = read(file);
  std::set<const BrepModel*> models;
  for (const Part& part : scene.parts) models.insert(&form(part).model());
  EXPECT_EQ(models.size(), 2u);
  EXPECT_EQ(&form(scene.parts[0]).model(), &form(scene.parts[4]).model());
  const FileInfo info = inspect(file);
  ASSERT_EQ(info.parts.size(), 6u);
  const std::vector<std::int32_t> same = {-1, 0, -1, 0, 0, 2};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(info.parts[i].same_shape_as, same[i]) << i;
}

TEST_F(Step, ColoursOfInstancesSolidsAndFaces) {
  CadDocument document;
  const TopoDS_Shape shape = test::solid_box(1, 1, 1);
  const TDF_Label plain = document.part(shape, "plain");
  const TDF_Label one = document.part(test::solid_box(1, 1, 2), "one colour of faces");
  for (TopExp_Explorer it(XCAFDoc_ShapeTool::GetShape(one), TopAbs_FACE); it.More(); it.Next()) {
    document.color(one, it.Current(), "#102030");
  }
  const TDF_Label two = document.part(test::solid_box(1, 1, 3), "two colours of faces");
  int i = 0;
  for (TopExp_Explorer it(XCAFDoc_ShapeTool::GetShape(two), TopAbs_FACE); it.More(); it.Next()) {
    document.color(two, it.Current(), i++ % 2 == 0 ? "#102030" : "#ff0000");
  }
  const TDF_Label grey = document.part(test::solid_box(1, 1, 4), "grey", "#808080");
  const TDF_Label top = document.assembly("top");
  // OCCT's writer loses the names of instances that are not moved.
  for (const TDF_Label& label : {plain, one, two, grey}) {
    document.use(top, label, test::moved(1, 0, 0), "used");
  }
  document.color(document.use(top, grey, test::moved(2, 0, 0), "painted"), "#0000ff");
  const Scene scene = read(document.step(folder_ / "colours.step"));
  ASSERT_EQ(scene.parts.size(), 5u);
  EXPECT_EQ(scene.parts[0].color, "");
  EXPECT_EQ(scene.parts[1].color, "#102030");
  // Each colour has one of the two faces of each size.
  EXPECT_EQ(scene.parts[2].color, "#102030");
  ASSERT_TRUE(scene.parts[2].face_colors);
  EXPECT_EQ(scene.parts[2].face_colors->colors, Strings{"#ff0000"});
  EXPECT_EQ(scene.parts[2].face_colors->of_face, (std::vector<std::int32_t>{-1, 0, -1, 0, -1, 0}));
  EXPECT_EQ(scene.parts[3].color, "#808080");
  EXPECT_EQ(scene.parts[4].color, "#0000ff");
  EXPECT_FALSE(scene.parts[1].face_colors || scene.parts[3].face_colors);
  // All are called "used": the first as it is, the others numbered.
  EXPECT_EQ(scene.parts[0].name, "used");
  EXPECT_EQ(scene.parts[3].name, "used #4");
}

TEST_F(Step, SolidsAndShellsOfOneProductAreOnePart) {
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  builder.Add(all, test::solid_box(1, 1, 1));
  builder.Add(all, BRepBuilderAPI_Transform(test::solid_sphere(1), test::moved(5, 0, 0)).Shape());
  const TopoDS_Shape other =
      BRepBuilderAPI_Transform(test::solid_box(1, 1, 1), test::moved(0, 5, 0)).Shape();
  builder.Add(all, TopExp_Explorer(other, TopAbs_SHELL).Current());
  builder.Add(all, TopExp_Explorer(other, TopAbs_EDGE).Current());
  CadDocument document;
  document.part(all, "heap");
  const std::string file = document.step(folder_ / "heap.step");
  const FileInfo info = inspect(file);
  ASSERT_EQ(info.parts.size(), 1u);
  EXPECT_EQ(info.parts[0].solids, 2);
  EXPECT_EQ(info.parts[0].shells, 3);
  EXPECT_EQ(info.parts[0].faces, 13);
  EXPECT_NEAR(info.parts[0].volume, 1 + 4.0 / 3 * std::numbers::pi + 1, 1e-6);
  test::expect_box(info.parts[0].bounds, {0, -1, -1}, {6, 6, 1}, 1e-4);
  const Scene scene = read(file);
  ASSERT_EQ(scene.parts.size(), 1u);
  ASSERT_EQ(scene.parts[0].pieces.size(), 3u);
  EXPECT_EQ(scene.parts[0].pieces[0].name, "solid 1");
  EXPECT_EQ(scene.parts[0].pieces[1].name, "solid 2");
  EXPECT_EQ(scene.parts[0].pieces[2].name, "shell 1");
  test::expect_box(scene.parts[0].pieces[1].form->bounds(Mat3(1)), {4, -1, -1}, {6, 1, 1}, 1e-4);
}

/// A product of three boxes, used twice.
std::string two_rows(const std::string& file) {
  CadDocument document;
  const TDF_Label row = document.part(test::boxes_in_a_row(3), "row");
  const TDF_Label top = document.assembly("top");
  document.use(top, row, test::moved(0, 5, 0), "row");
  document.use(top, row, test::moved(0, 50, 0) * test::turned(90), "row");
  return document.step(file);
}

TEST_F(Step, InstancesOfAProductOfSolidsShareItsForm) {
  const std::string file = two_rows(folder_ / "rows.step");
  const Scene scene = read(file);
  ASSERT_EQ(scene.parts.size(), 2u);
  const Definition one = scene.parts[0].form->definition();
  EXPECT_TRUE(one.same(scene.parts[1].form->definition()));
  EXPECT_EQ(inspect(file).parts[1].same_shape_as, 0);
  RunContext context;
  const ShapeMeasure measure = scene.parts[0].form->measure(context);
  EXPECT_NEAR(measure.area, 6 + 10 + 14, 1e-6);
  EXPECT_NEAR(measure.volume, 1 + 2 + 3, 1e-6);
  EXPECT_EQ(measure.faces, 18);
  EXPECT_EQ(measure.edges, 36);
  EXPECT_TRUE(measure.same(scene.parts[1].form->measure(context)));
  test::expect_box(scene.parts[0].form->bounds(Mat3(1)), {0, 5, 0}, {23, 6, 1});
  test::expect_box(scene.parts[1].form->bounds(Mat3(1)), {-1, 50, 0}, {0, 73, 1});
}

TEST_F(Step, FacesAndEdgesOfAProductOfSolidsAreNumberedThrough) {
  const Scene scene = read(two_rows(folder_ / "rows.step"));
  const auto numbers = [](const Form& form) {
    RunContext context;
    const std::shared_ptr<const Surface> surface = form.realise({}, context);
    const ProxyMesh& proxy = surface->proxy();
    std::set<std::int32_t> edges(proxy.source_edge.begin(), proxy.source_edge.end());
    edges.erase(-1);
    return std::pair(std::set(proxy.source_face.begin(), proxy.source_face.end()), edges);
  };
  const auto [faces, edges] = numbers(*scene.parts[0].form);
  EXPECT_EQ(faces.size(), 18u);
  EXPECT_EQ(*faces.begin(), 0);
  EXPECT_EQ(*faces.rbegin(), 17);
  EXPECT_EQ(edges.size(), 36u);
  EXPECT_EQ(*edges.rbegin(), 35);
  // A solid that is chosen alone keeps its numbers.
  const auto [own, own_edges] = numbers(*scene.parts[1].pieces[1].form);
  EXPECT_EQ(own, (std::set<std::int32_t>{6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(*own_edges.begin(), 12);
  EXPECT_EQ(*own_edges.rbegin(), 23);
}

TEST_F(Step, SolidsOfAProductKeepTheirColours) {
  CadDocument document;
  const auto color_solids = [&](const TDF_Label& part, const Strings& colors) {
    std::size_t i = 0;
    for (TopExp_Explorer it(XCAFDoc_ShapeTool::GetShape(part), TopAbs_SOLID); it.More();
         it.Next()) {
      document.color(part, it.Current(), colors[i++]);
    }
  };
  color_solids(document.part(test::boxes_in_a_row(2), "mixed"), {"#ff0000", "#00ff00"});
  color_solids(document.part(test::boxes_in_a_row(3), "same"), {"#ff0000", "#ff0000", "#ff0000"});
  document.part(test::boxes_in_a_row(4), "whole", "#0000ff");
  const Scene scene = read(document.step(folder_ / "colours.step"));
  ASSERT_EQ(scene.parts.size(), 3u);
  // The second box is larger.
  EXPECT_EQ(scene.parts[0].color, "#00ff00");
  ASSERT_TRUE(scene.parts[0].face_colors);
  EXPECT_EQ(scene.parts[0].face_colors->colors, Strings{"#ff0000"});
  EXPECT_EQ(scene.parts[0].face_colors->at(5), 0);
  EXPECT_EQ(scene.parts[0].face_colors->at(6), -1);
  EXPECT_EQ(scene.parts[0].pieces.at(0).color, "#ff0000");
  EXPECT_EQ(scene.parts[0].pieces.at(1).color, "#00ff00");
  EXPECT_FALSE(scene.parts[0].pieces.at(0).face_colors);
  EXPECT_EQ(scene.parts[1].color, "#ff0000");
  EXPECT_EQ(scene.parts[2].color, "#0000ff");
}

TEST_F(Step, FacesHaveTheirColoursBeforeTheirSolidAndInAllInstances) {
  CadDocument document;
  const TDF_Label board = document.part(test::solid_box(10, 20, 1), "board", "#008000");
  TopExp_Explorer face(XCAFDoc_ShapeTool::GetShape(board), TopAbs_FACE);
  face.Next();
  document.color(board, face.Current(), "#ffd700");
  const TDF_Label top = document.assembly("top");
  document.use(top, board, test::moved(1, 0, 0), "first");
  document.use(top, board, test::turned(90), "second");
  document.color(document.use(top, board, test::moved(0, 0, 9), "painted"), "#0000ff");
  const std::string file = document.step(folder_ / "board.step");
  const Scene scene = read(file);
  ASSERT_EQ(scene.parts.size(), 3u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Part& part = scene.parts[i];
    EXPECT_EQ(part.color, "#008000");
    ASSERT_TRUE(part.face_colors);
    EXPECT_EQ(part.face_colors->colors, Strings{"#ffd700"});
    EXPECT_EQ(part.face_colors->of_face, (std::vector<std::int32_t>{-1, 0, -1, -1, -1, -1}));
  }
  EXPECT_EQ(scene.parts[0].face_colors, scene.parts[1].face_colors);
  EXPECT_EQ(scene.parts[2].color, "#0000ff");
  EXPECT_FALSE(scene.parts[2].face_colors);
  const FileInfo info = inspect(file);
  ASSERT_EQ(info.parts.size(), 3u);
  EXPECT_EQ(info.parts[0].colors, 2);
  EXPECT_EQ(info.parts[2].colors, 1);
  EXPECT_NE(to_text(info).find("#008000, in 2 colours"), std::string::npos);
}

TEST_F(Step, TransparencyIsKept) {
  CadDocument document;
  document.color(document.part(test::solid_box(1, 1, 1), "glass"), "#c0e0ff", 0.25);
  document.part(test::solid_box(1, 1, 2), "steel", "#808080");
  const Scene scene = read(document.step(folder_ / "glass.step"));
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_NEAR(inspect(folder_ / "glass.step").parts.at(0).opacity, 0.25, 1e-6);
  EXPECT_NEAR(scene.parts[0].opacity, 0.25, 1e-6);
  EXPECT_EQ(scene.parts[0].color, "#c0e0ff");
  EXPECT_EQ(scene.parts[1].opacity, 1);
}

TEST_F(Step, OpacitiesOfFacesAreKept) {
  const auto painted = [](CadDocument& document, const TDF_Label& part, const Strings& colors,
                          const std::vector<double>& opacities) {
    std::size_t i = 0;
    for (TopExp_Explorer it(XCAFDoc_ShapeTool::GetShape(part), TopAbs_FACE); it.More(); it.Next()) {
      if (i < colors.size()) document.color(part, it.Current(), colors[i], opacities[i]);
      ++i;
    }
  };
  CadDocument document;
  // A window in the largest face of a solid, all of glass in two ways, a label on glass.
  painted(document, document.part(test::solid_box(1, 1, 1), "window", "#808080"), {"#c0e0ff"},
          {0.2});
  painted(document, document.part(test::solid_box(1, 1, 2), "glass"), Strings(6, "#c0e0ff"),
          {0.2, 0.4, 0.4, 0.4, 0.4, 0.4});
  const TDF_Label labelled = document.part(test::solid_box(1, 1, 3), "labelled");
  document.color(labelled, "#c0e0ff", 0.4);
  painted(document, labelled, {"#ffffff", "#c0e0ff"}, {1, 0.6});
  const Scene scene = read(document.step(folder_ / "faces.step"));
  ASSERT_EQ(scene.parts.size(), 3u);
  const auto faces = [&](std::size_t part) {
    return scene.parts[part].face_colors ? scene.parts[part].face_colors->colors : Strings{};
  };
  EXPECT_EQ(scene.parts[0].color, "#808080");
  EXPECT_EQ(scene.parts[0].opacity, 1);
  EXPECT_EQ(faces(0), Strings{"#c0e0ff33"});
  EXPECT_EQ(scene.parts[1].color, "#c0e0ff");
  EXPECT_NEAR(scene.parts[1].opacity, 0.4, 1e-6) << "as most of it";
  EXPECT_EQ(faces(1), Strings{"#c0e0ff33"});
  EXPECT_EQ(scene.parts[2].color, "#c0e0ff");
  EXPECT_NEAR(scene.parts[2].opacity, 0.4, 1e-6) << "as the whole says";
  EXPECT_EQ(faces(2), (Strings{"#ffffff", "#c0e0ff99"}));
  EXPECT_NEAR(inspect(folder_ / "faces.step").parts.at(1).opacity, 0.4, 1e-6);
}

TEST_F(Step, AForeignBoardIsABoardAndFourChips) {
  const std::string file = std::string(BURIN_TEST_DATA) + "/outside/product_of_solids.step";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const Scene scene = read(file);
  ASSERT_EQ(scene.parts.size(), 5u);
  EXPECT_EQ(scene.parts[0].name, "board");
  EXPECT_TRUE(scene.parts[0].pieces.empty());
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_EQ(scene.parts[i].definition, "chip");
    EXPECT_EQ(scene.parts[i].pieces.size(), 7u);
    EXPECT_TRUE(scene.parts[i].form->definition().same(scene.parts[1].form->definition()));
  }
}

TEST_F(Step, InfoMeasuresTheExactSurfaces) {
  CadDocument document;
  document.part(test::solid_sphere(2), "ball", "#c0c0c0");
  const FileInfo info = inspect(document.step(folder_ / "ball.step"));
  EXPECT_EQ(info.format, "STEP (AP214)");
  EXPECT_TRUE(info.schema.starts_with("AUTOMOTIVE_DESIGN")) << info.schema;
  ASSERT_EQ(info.parts.size(), 1u);
  const PartInfo& p = info.parts[0];
  EXPECT_EQ(p.solids, 1);
  EXPECT_EQ(p.faces, 1);
  EXPECT_TRUE(p.closed());
  EXPECT_NEAR(p.volume, 4.0 / 3 * std::numbers::pi * 8, 1e-6);
  EXPECT_NEAR(p.area, 4 * std::numbers::pi * 4, 1e-6);
  EXPECT_EQ(p.color, "#c0c0c0");
  test::expect_box(p.bounds, Vec3(-2), Vec3(2), 1e-4);
  EXPECT_FALSE(p.triangles.has_value());
  const std::string text = to_text(info);
  EXPECT_NE(text.find("STEP (AP214)"), std::string::npos) << text;
  EXPECT_NE(text.find("volume      33.5103 mm3"), std::string::npos) << text;
}

}  // namespace
}  // namespace burin
