// Parts, groups, bodies and links: who is drawn, where, and under which name.
#include "writing.h"

namespace burin::test {
namespace {

const Vec3 kUnitOfTree(1, 2, 3);

TEST_F(FcstdTest, ShapesKeepLabelPlaceAndVisibility) {
  Document d;
  d.add_shape("Box", located_box(kUnitOfTree, {10, 20, 30}),
              text_property("Label", "A &amp; B") + placed({10, 20, 30}));
  d.add_shape("Hidden", located_box(kUnitOfTree, {}), hidden());
  d.add("Sketcher::SketchObject", "Sketch");
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), Paths{"A & B"});
  expect_box(scene.parts[0], {10, 20, 30}, {11, 22, 33});
  ASSERT_EQ(scene.diagnostics.entries().size(), 1u);
  EXPECT_TRUE(has(scene, "fcstd.aids", "'Sketch'"));
  EXPECT_EQ(scene.diagnostics.entries().front().severity, Severity::Info);
}

TEST_F(FcstdTest, ALabelOfBlanksLeavesTheName) {
  Document d;
  d.add_shape("Box", located_box(kUnitOfTree, {}), text_property("Label", "   "));
  EXPECT_EQ(paths(read(d)), Paths{"Box"});
}

TEST_F(FcstdTest, PartsPlaceTheirMembersAndGroupsDoNot) {
  Document d;
  d.add("App::Part", "Asm",
        text_property("Label", "Motor") + group({"Sub", "Folder"}) +
            placed({100, 0, 0}, "Placement", {0, 0, 1}, 90));
  d.add("App::Part", "Sub", group({"Box"}) + placed({0, 0, 50}));
  d.add_shape("Box", located_box(kUnitOfTree, {5, 0, 0}), placed({5, 0, 0}));
  d.add("App::DocumentObjectGroup", "Folder", group({"Other"}) + placed({7, 7, 7}) + hidden());
  d.add_shape("Other", located_box(kUnitOfTree, {}));
  d.add("App::Part", "Off", group({"Inside"}) + hidden());
  d.add_shape("Inside", located_box(kUnitOfTree, {}));
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), (Paths{"Motor/Sub/Box", "Motor/Folder/Other"}));
  // Turned by 90 degrees about z: (x, y) goes to (-y, x).
  expect_box(scene.parts[0], {98, 5, 50}, {100, 6, 53});
  expect_box(scene.parts[1], {98, 0, 0}, {100, 1, 3});
}

TEST_F(FcstdTest, ABodyIsItsOwnShapeOrThatOfItsTip) {
  const auto body = [&](bool own) {
    Document d;
    const std::string properties = group({"Pad", "Pocket", "Plane"}) +
                                   property("Tip", "<Link value=\"Pocket\"/>") + placed({0, 9, 0});
    if (own) {
      d.add_shape("Body", located_box(kUnitOfTree, {0, 9, 0}), properties, "PartDesign::Body");
    } else {
      d.add("PartDesign::Body", "Body", properties);
    }
    d.add_shape("Pad", located_box({8, 8, 8}, {}), "", "PartDesign::Pad");
    d.add_shape("Pocket", located_box(kUnitOfTree, {}), "", "PartDesign::Pocket");
    d.add_shape("Plane", located_box({99, 99, 99}, {}), "", "PartDesign::Plane");
    return read(d);
  };
  for (const bool own : {true, false}) {
    const Scene scene = body(own);
    ASSERT_EQ(paths(scene), Paths{"Body"});
    expect_box(scene.parts[0], {0, 9, 0}, {1, 11, 3});
  }
}

TEST_F(FcstdTest, LinksStandWhereTheySay) {
  Document d;
  d.add_shape("Box", located_box(kUnitOfTree, {10, 0, 0}), placed({10, 0, 0}) + hidden());
  d.add("App::Link", "Plain", linked("Box") + placed({0, 0, 100}));
  d.add("App::Link", "With",
        linked("Box") + placed({0, 0, 200}) + text_property("LinkTransform", "true"));
  d.add("App::Link", "Big",
        linked("Box") +
            property("ScaleVector", "<PropertyVector valueX=\"2\" valueY=\"2\" valueZ=\"2\"/>"));
  d.add("App::Link", "Uneven",
        linked("Box") +
            property("ScaleVector", "<PropertyVector valueX=\"2\" valueY=\"1\" valueZ=\"1\"/>"));
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), (Paths{"Plain", "With", "Big", "Uneven"}));
  expect_box(scene.parts[0], {0, 0, 100}, {1, 2, 103});
  expect_box(scene.parts[1], {10, 0, 200}, {11, 2, 203});
  expect_box(scene.parts[2], {0, 0, 0}, {2, 4, 6});
  expect_box(scene.parts[3], {0, 0, 0}, {2, 2, 3});
  RunContext context;
  const FileInfo info = inspect_fcstd(folder_ / "a.FCStd", {}, context);
  EXPECT_NEAR(info.parts[3].volume, 12, 1e-9);
  EXPECT_NEAR(info.parts[3].area, 2 * (4 + 6 + 6), 1e-9);
}

TEST_F(FcstdTest, LinksThatFlattenAreLeftOutByName) {
  Document d;
  d.add_shape("Box", located_box(kUnitOfTree, {}));
  d.add("App::Link", "Flat", linked("Box") + scaled({1, 1, 0}));
  const Scene scene = read(d);
  EXPECT_EQ(paths(scene), Paths{"Box"});
  EXPECT_TRUE(has(scene, "fcstd.broken_shape", "Flat"));
}

TEST_F(FcstdTest, LinksToPartsTakeTheirNameAndLeaveTheirPlace) {
  Document d;
  d.add("App::Part", "Asm", group({"Sub"}) + placed({50, 0, 0}));
  d.add("App::Part", "Sub", group({"Box"}) + placed({0, 5, 0}));
  d.add_shape("Box", located_box(kUnitOfTree, {0, 0, 7}), placed({0, 0, 7}));
  d.add("App::Link", "Copy", linked("Asm") + placed({0, 100, 0}));
  d.add("App::Link", "Inner", linked("Asm", "", "Sub.Box.") + placed({0, 200, 0}));
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), (Paths{"Asm/Sub/Box", "Copy/Sub/Box", "Inner"}));
  expect_box(scene.parts[0], {50, 5, 7}, {51, 7, 10});
  expect_box(scene.parts[1], {0, 105, 7}, {1, 107, 10});
  expect_box(scene.parts[2], {0, 205, 7}, {1, 207, 10});
}

TEST_F(FcstdTest, ArraysOfLinks) {
  Document d;
  d.add_shape("Box", located_box(kUnitOfTree, {10, 0, 0}), placed({10, 0, 0}) + hidden());
  std::string list;
  put<std::uint32_t>(list, 3);
  for (int i = 0; i < 3; ++i) {
    for (const double v : {20.0 * i, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}) put(list, v);
  }
  d.members.emplace_back("Places", list);
  d.add("App::Link", "Row",
        linked("Box") + placed({0, 0, 9}) + property("ElementCount", "<Integer value=\"3\"/>") +
            property("PlacementList", "<PlacementList file=\"Places\"/>") +
            // The last digit is that of the first element.
            property("VisibilityList", "<BoolList value=\"101\"/>"));
  // Elements that were made in a window are hidden themselves: the list of their link tells.
  d.add("App::Link", "Shown",
        linked("Box") + link_list("ElementList", {"E0", "E1"}) +
            property("VisibilityList", "<BoolList value=\"01\"/>"));
  d.add("App::LinkElement", "E0", linked("Box") + placed({0, 40, 0}) + hidden());
  d.add("App::LinkElement", "E1", linked("Box") + hidden());
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), (Paths{"Row", "Row #2", "Shown"}));
  expect_box(scene.parts[0], {0, 0, 9}, {1, 2, 12});
  expect_box(scene.parts[1], {40, 0, 9}, {41, 2, 12});
  expect_box(scene.parts[2], {0, 40, 0}, {1, 42, 3});
}

TEST_F(FcstdTest, GroupsOfLinksHideByTheirOwnList) {
  Document d;
  d.add("App::LinkGroup", "Set",
        link_list("ElementList", {"A", "B"}) + placed({0, 0, 5}) +
            property("VisibilityList", "<BoolList value=\"01\"/>"));
  d.add_shape("A", located_box(kUnitOfTree, {}), hidden());
  d.add_shape("B", located_box(kUnitOfTree, {}));
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), Paths{"Set/A"});
  expect_box(scene.parts[0], {0, 0, 5}, {1, 2, 8});
}

TEST_F(FcstdTest, LinksIntoOtherDocuments) {
  Document other;
  other.add_shape("Box", located_box(kUnitOfTree, {10, 0, 0}), placed({10, 0, 0}));
  folder_.write("other.FCStd", other.bytes());
  Document d;
  d.add("App::Link", "Here", linked("Box", "other.FCStd") + placed({0, 3, 0}));
  d.add("App::Link", "Gone", linked("Box", "gone.FCStd"));
  d.add("App::Link", "Nobody", linked("Nix", "other.FCStd"));
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), Paths{"Here"});
  expect_box(scene.parts[0], {0, 3, 0}, {1, 5, 3});
  EXPECT_TRUE(has(scene, "fcstd.missing_file", "Gone"));
  EXPECT_TRUE(has(scene, "fcstd.broken_link", "Nobody"));
  Document only;
  only.add("App::Link", "Gone", linked("Box", "gone.FCStd"));
  EXPECT_TRUE(holds(error_of(only.bytes()), "'gone.FCStd' is missing"));
}

TEST_F(FcstdTest, MeshesStandAtTheirPlacement) {
  Document d;
  d.members.emplace_back("MeshKernel.bms", bms(box({0, 0, 0}, {1, 2, 3})));
  const std::string mesh = property("Mesh", "<Mesh file=\"MeshKernel.bms\"/>");
  d.add("Mesh::Feature", "M", mesh + placed({0, 0, -50}));
  d.add("App::Link", "L",
        linked("M") +
            property("ScaleVector", "<PropertyVector valueX=\"-1\" valueY=\"1\" valueZ=\"1\"/>"));
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), (Paths{"M", "L"}));
  expect_box(scene.parts[0], {0, 0, -50}, {1, 2, -47});
  expect_box(scene.parts[1], {-1, 0, 0}, {0, 2, 3});
  RunContext context;
  const FileInfo info = inspect_fcstd(folder_ / "a.FCStd", {}, context);
  ASSERT_EQ(info.parts.size(), 2u);
  EXPECT_NEAR(info.parts[0].volume, 6, 1e-9);
  EXPECT_NEAR(info.parts[1].volume, 6, 1e-9);
}

TEST_F(FcstdTest, InfoMeasuresAndNamesInstances) {
  Document d;
  d.add_shape("Box", located_box(kUnitOfTree, {}));
  d.add("App::Link", "L", linked("Box") + placed({9, 0, 0}));
  folder_.write("a.FCStd", d.bytes());
  RunContext context;
  const FileInfo info = inspect_fcstd(folder_ / "a.FCStd", {}, context);
  EXPECT_EQ(info.format, "FreeCAD 0.20");
  ASSERT_EQ(info.parts.size(), 2u);
  EXPECT_NEAR(info.parts[0].volume, 6, 1e-9);
  EXPECT_EQ(info.parts[0].faces, 6);
  EXPECT_EQ(info.parts[1].same_shape_as, 0);
}

TEST_F(FcstdTest, ObjectsAreChosenByNameOrLabel) {
  Document d;
  d.add("App::Part", "Asm", group({"Box"}) + placed({100, 0, 0}) + hidden());
  d.add_shape("Box", located_box(kUnitOfTree, {}), text_property("Label", "Cover") + hidden());
  d.add_shape("Other", located_box(kUnitOfTree, {}));
  for (const char* name : {"Box", "Cover"}) {
    const Scene scene = read(d, {.objects = {name}});
    ASSERT_EQ(paths(scene), Paths{"Asm/Cover"});
    expect_box(scene.parts[0], {100, 0, 0}, {101, 2, 3});
  }
  EXPECT_EQ(paths(read(d, {.objects = {"Other", "Box", "Cover"}})), (Paths{"Other", "Asm/Cover"}));
  EXPECT_TRUE(holds(error_of(d.bytes(), {.objects = {"Covre"}}), "the nearest is 'Cover'"));
}

}  // namespace
}  // namespace burin::test
