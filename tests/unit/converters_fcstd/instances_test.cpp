// What is instanced: names, link extensions, copies.
#include <burin/assembly/items.h>

#include "writing.h"

#include <filesystem>
#include <map>

namespace burin::test {
namespace {

const Vec3 kUnitBox(1, 2, 3);
const std::string kLinkExtension = "App::LinkExtensionPython";

std::map<std::string, std::size_t> items(const Scene& scene) {
  Diagnostics diagnostics;
  RunContext context;
  std::map<std::string, std::size_t> out;
  for (const Item& item : find_items(scene, {}, diagnostics, context)) {
    out[item.name] = item.parts.size();
  }
  return out;
}
using Items = std::map<std::string, std::size_t>;

TEST_F(FcstdTest, LinksAreOfOneItemWithWhatTheyLinkTo) {
  Document d;
  d.add_shape("chip", located_box(kUnitBox, {}), label("chip"));
  d.add("App::Link", "L0", linked("chip") + label("chip2") + placed({5, 0, 0}));
  d.add("App::Link", "L1", linked("L0") + label("left one") + placed({9, 0, 0}));
  const Scene scene = read(d);
  EXPECT_EQ(paths(scene), (Paths{"chip", "chip2", "left one"}));
  EXPECT_EQ(items(scene), (Items{{"chip", 3}}));
}

TEST_F(FcstdTest, ArraysOfDraftAreLinks) {
  Document d;
  d.add_shape("Box", located_box(kUnitBox, {50, 0, 0}), label("Klotz") + placed({50, 0, 0}));
  d.members.emplace_back("Places", place_list({{0, 0, 0}, {10, 0, 0}, {20, 0, 0}}));
  d.add("Part::FeaturePython", "Array",
        label("Reihe") + link_property("Base", "Box") + integer("Count", 3) +
            link_list("ElementList", {}) + placed({0, 0, 7}) +
            property("PlacementList", "<PlacementList file=\"Places\"/>") +
            proxy("draftobjects.array", "Array"),
        kLinkExtension);
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), (Paths{"Klotz", "Reihe", "Reihe #2", "Reihe #3"}));
  expect_box(scene.parts[3], {20, 0, 7}, {21, 2, 10});
  EXPECT_EQ(items(scene), (Items{{"Klotz", 4}}));
}

TEST_F(FcstdTest, ExpandedArraysOfDraftAreTheirElements) {
  Document d;
  d.add_shape("Box", located_box(kUnitBox, {}));
  d.add("Part::FeaturePython", "Array",
        link_property("Base", "Box") + integer("Count", 2) +
            link_list("ElementList", {"Array_i0", "Array_i1"}) + placed({0, 0, 7}),
        kLinkExtension);
  d.add("App::LinkElement", "Array_i0", linked("Box") + placed({10, 0, 0}),
        "App::LinkBaseExtension");
  d.add("App::LinkElement", "Array_i1", linked("Box") + placed({20, 0, 0}),
        "App::LinkBaseExtension");
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), (Paths{"Box", "Array", "Array #2"}));
  expect_box(scene.parts[2], {20, 0, 7}, {21, 2, 10});
}

TEST_F(FcstdTest, PythonObjectsWithAShapeThatDoNotLinkKeepIt) {
  Document d;
  d.members.emplace_back("Own.brp", brep_text(located_box(kUnitBox, {})));
  d.add("Part::FeaturePython", "Gear", property("Shape", "<Part file=\"Own.brp\"/>"),
        kLinkExtension);
  d.add("Part::FeaturePython", "Lost", link_property("Base", ""), kLinkExtension);
  const Scene scene = read(d);
  EXPECT_EQ(paths(scene), Paths{"Gear"});
  EXPECT_TRUE(has(scene, "fcstd.broken_link", "Lost"));
}

TEST_F(FcstdTest, GroupsOfAssembly3ShowTheirPartsAlone) {
  Document d;
  const std::string base = "App::LinkBaseExtensionPython";
  d.add("Part::FeaturePython", "Asm",
        label("Pump") + group({"Constraints", "Parts"}) + placed({0, 0, 5}) +
            proxy("freecad.asm3.assembly", "Assembly"),
        base);
  d.add("App::FeaturePython", "Constraints",
        group({"Face"}) + proxy("freecad.asm3.assembly", "AsmConstraintGroup"), base);
  d.add("Part::FeaturePython", "Face", linked("Box") + proxy("freecad.asm3.assembly", "AsmElement"),
        kLinkExtension);
  d.add("Part::FeaturePython", "Parts",
        group({"Box", "Off"}) + hidden() + text_property("VisibilityList", "01") +
            proxy("freecad.asm3.assembly", "AsmPartGroup"),
        base);
  d.add_shape("Box", located_box(kUnitBox, {}), label("Cover"));
  d.add_shape("Off", located_box(kUnitBox, {}));
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), Paths{"Pump/Parts/Cover"});
  expect_box(scene.parts[0], {0, 0, 5}, {1, 2, 8});
  EXPECT_TRUE(scene.diagnostics.empty());
}

TEST_F(FcstdTest, ContainersNameWhatFreecadCalledItself) {
  Document d;
  d.add("App::Part", "Part", label("Bearing cap") + group({"Body"}));
  d.add_shape("Body", located_box(kUnitBox, {}), label("Body"), "PartDesign::Body");
  d.add("App::Part", "Part001", label("Part001") + group({"Cut"}));
  d.add_shape("Cut", located_box({4, 2, 3}, {}), label("Cut"), "Part::Cut");
  d.add("App::Part", "Part002", label("Drive") + group({"Body001", "Body002"}));
  d.add_shape("Body001", located_box({5, 2, 3}, {}), label("Body001"), "PartDesign::Body");
  d.add_shape("Body002", located_box({6, 2, 3}, {}), label("Shaft"), "PartDesign::Body");
  d.add("App::Part", "Part003", label("Lager") + group({"Box", "Tool"}));
  d.add_shape("Box", located_box({7, 2, 3}, {}), label("Würfel001"), "Part::Box");
  d.add_shape("Tool", located_box({8, 2, 3}, {}), hidden());
  const Scene scene = read(d);
  EXPECT_EQ(paths(scene), (Paths{"Bearing cap/Body", "Part001/Cut", "Drive/Body001", "Drive/Shaft",
                                 "Lager/Würfel001"}));
  EXPECT_EQ(definitions(scene), (Paths{"Bearing cap", "Cut", "Body001", "Shaft", "Lager"}));
}

TEST_F(FcstdTest, LinksGiveOneNameToAllOfAThing) {
  Document d;
  d.add_shape("Body", located_box(kUnitBox, {}), label("Body"), "PartDesign::Body");
  d.add("App::Link", "L0", linked("Body") + label("Foot") + placed({5, 0, 0}));
  d.add("App::Link", "L1", linked("Body") + label("Foot001") + placed({9, 0, 0}));
  EXPECT_EQ(items(read(d)), (Items{{"Foot", 3}}));
  d.add("App::Link", "L2", linked("Body") + label("left one") + placed({13, 0, 0}));
  EXPECT_EQ(items(read(d)), (Items{{"Body", 4}}));
}

TEST_F(FcstdTest, LinksNameBodiesThatNobodyNamed) {
  Document other;
  other.add_shape("Body", located_box(kUnitBox, {}), label("Body"), "PartDesign::Body");
  folder_.write("bearing.FCStd", other.bytes());
  Document d;
  d.add_shape("Body", located_box({4, 2, 3}, {}), label("Body") + hidden(), "PartDesign::Body");
  d.add("App::Link", "Link", linked("Body") + label("Washer"));
  d.add("App::Link", "Link001", linked("Body", "bearing.FCStd") + label("Body001"));
  d.add("App::Link", "Link002", linked("Body", "bearing.FCStd") + label("left bearing"));
  EXPECT_EQ(items(read(d)), (Items{{"Washer", 1}, {"bearing", 2}}));
}

TEST_F(FcstdTest, CopiesJoinWhatTheyAreCopiesOfWhereTheyLookTheSame) {
  const auto bent = [] {  // three boxes, so that it is not its own mirror image
    BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    builder.Add(all, located_box({20, 5, 5}, {}));
    builder.Add(all, located_box({5, 15, 5}, {0, 5, 0}));
    builder.Add(all, located_box({5, 5, 12}, {0, 0, 5}));
    return TopoDS_Shape(all);
  };
  const auto mirrored = [](const TopoDS_Shape& shape) {
    gp_Trsf t;
    t.SetMirror(gp_Ax2(gp_Pnt(0, -9, 0), gp_Dir(0, 1, 0)));
    return BRepBuilderAPI_Transform(shape, t, true).Shape();
  };
  Document d;
  d.add_shape("Box", located_box(kUnitBox, {}), label("Klotz"));
  d.add_shape("M1", mirrored(located_box(kUnitBox, {})),
              label("Spiegel") + link_property("Source", "Box"), "Part::Mirroring");
  d.add_shape("Hook", bent(), label("Haken"));
  d.add_shape("M2", mirrored(bent()), label("Haken links") + link_property("Source", "Hook"),
              "Part::Mirroring");
  d.add_shape(
      "Clone", bent(),
      label("Zweiter") + link_list("Objects", {"Hook"}) + proxy("draftobjects.clone", "Clone"),
      "Part::FeaturePython");
  d.add("App::Link", "Left", linked("Hook") + label("Haken am Rand") + scaled({-1, 1, 1}));
  d.add("App::Link", "Even", linked("Box") + label("Klotz am Rand") + scaled({-1, 1, 1}));
  EXPECT_EQ(definitions(read(d)),
            (Paths{"Klotz", "Klotz", "Haken", "Haken links", "Haken", "Haken am Rand", "Klotz"}));
}

TEST_F(FcstdTest, WhatIsSeenAndNotDrawnIsToldByName) {
  Document d;
  d.add_shape("Box", located_box(kUnitBox, {}));
  d.add_shape("Wire", BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(9, 0, 0)).Shape());
  d.add("Points::Feature", "Cloud", placed({}));
  d.add("Fem::FemMeshObject", "FemMesh", placed({}));
  d.add("App::FeaturePython", "Dim", proxy("draftobjects.dimension", "LinearDimension"));
  d.add("Some::Thing", "Thing", placed({}));
  d.members.emplace_back("Empty.brp", "");
  d.add("Part::Fillet", "Fillet", property("Shape", "<Part file=\"Empty.brp\"/>") + placed({}));
  d.add_shape("Binder", located_box(kUnitBox, {}), "", "PartDesign::SubShapeBinder");
  d.add("PartDesign::Body", "Leer", placed({}));
  // Nowhere to be seen:
  d.add("Spreadsheet::Sheet", "Sheet", label("my sheet of numbers"));
  d.add("TechDraw::DrawPage", "Page");
  d.add("App::FeaturePython", "Joint", proxy("JointObject", "GroundedJoint") + placed({}));
  d.add("App::Line", "X_Axis", placed({}));
  d.add("PartDesign::Plane", "Datum", placed({}));
  d.add("Points::Feature", "Off", placed({}) + hidden());
  const Scene scene = read(d);
  EXPECT_EQ(paths(scene), Paths{"Box"});
  EXPECT_TRUE(has(scene, "fcstd.no_faces", "'Wire'"));
  EXPECT_TRUE(has(scene, "fcstd.not_drawn", "'Cloud'"));
  EXPECT_TRUE(has(scene, "fcstd.not_drawn", "'FemMesh'"));
  EXPECT_TRUE(has(scene, "fcstd.not_drawn", "'Dim'"));
  EXPECT_TRUE(has(scene, "fcstd.no_shape", "'Thing', 'Leer', 'Fillet'"));
  EXPECT_TRUE(has(scene, "fcstd.aids", "'Binder'"));
  EXPECT_EQ(scene.diagnostics.entries().size(), 6u);
}

// Two objects may be called the same; what is left out takes no number.
TEST_F(FcstdTest, OnlyWhatIsDrawnIsNumbered) {
  Document d;
  d.members.emplace_back("Empty.brp", "");
  d.add("Part::Fillet", "A", property("Shape", "<Part file=\"Empty.brp\"/>") + label("Lid"));
  d.add_shape("B", located_box(kUnitBox, {}), label("Lid"));
  EXPECT_EQ(paths(read(d)), Paths{"Lid"});
  d.add_shape("C", located_box(kUnitBox, {5, 0, 0}), label("Lid"));
  EXPECT_EQ(paths(read(d)), (Paths{"Lid", "Lid #2"}));
}

TEST_F(FcstdTest, ALinkToAFaceSaysThatAllIsDrawn) {
  Document d;
  d.add_shape("Box", located_box(kUnitBox, {}));
  d.add("App::Link", "Face", linked("Box", "", "Face1"));
  const Scene scene = read(d);
  EXPECT_EQ(scene.parts.size(), 2u);
  EXPECT_TRUE(has(scene, "fcstd.whole_object", "'Face'"));
}

TEST_F(FcstdTest, AMissingFileIsOneLine) {
  Document d;
  d.add_shape("Box", located_box(kUnitBox, {}));
  for (const char* name : {"A", "B", "C"}) d.add("App::Link", name, linked("X", "gone.FCStd"));
  const Scene scene = read(d);
  EXPECT_TRUE(has(scene, "fcstd.missing_file", "'A', 'B', 'C'"));
  EXPECT_EQ(scene.diagnostics.entries().size(), 1u);
}

TEST_F(FcstdTest, DocumentsOfOutsideAreCounted) {
  const std::filesystem::path data = std::filesystem::path(BURIN_TEST_DATA) / "outside";
  if (!std::filesystem::is_directory(data)) GTEST_SKIP() << "no " << data;
  const auto counted = [&](const char* name) {
    RunContext context;
    return items(read_fcstd(data / name, {}, context));
  };
  EXPECT_EQ(counted("containers.FCStd"),
            (Items{{"Bearing cap", 1}, {"Shaft", 1}, {"Base plate", 1}}));
  EXPECT_EQ(counted("links_by_label.FCStd"), (Items{{"board", 1}, {"chip", 4}}));
  EXPECT_EQ(counted("draft_arrays.FCStd"), (Items{{"Klotz", 10}, {"Kranz", 1}}));
  RunContext context;
  const Scene scaled = read_fcstd(data / "scaled_links.FCStd", {}, context);
  EXPECT_TRUE(scaled.diagnostics.empty());
  EXPECT_EQ(scaled.parts.size(), 4u);
}

}  // namespace
}  // namespace burin::test
