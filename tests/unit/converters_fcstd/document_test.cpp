// What the archive holds: the window's file, binary shapes, damage.
#include "writing.h"

#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <burin_test/mutated.h>

#include <chrono>
#include <thread>

namespace burin::test {
namespace {

const Vec3 kUnit(1, 2, 3);

std::string colors(const std::vector<std::uint32_t>& packed) {
  std::string out;
  put(out, static_cast<std::uint32_t>(packed.size()));
  for (const std::uint32_t p : packed) put(out, p);
  return out;
}

TEST_F(FcstdTest, ColorsAndVisibilityComeFromTheWindow) {
  Document d;
  for (const char* name : {"A", "B", "C", "D"}) d.add_shape(name, located_box(kUnit, {}), hidden());
  d.add("App::Link", "L", linked("A"));
  const std::string shown = text_property("Visibility", "true");
  const std::string red = property("ShapeColor", "<PropertyColor value=\"4278190080\"/>");
  const auto faces = [](const std::string& member) {
    return property("DiffuseColor", "<ColorList file=\"" + member + "\"/>");
  };
  d.view("A", shown + red);
  d.view("B", shown + red + faces("One"));
  d.view("C", shown + red + faces("Many"));
  d.view("D", shown + red + faces("Cut"));
  d.view("L", property("ShapeMaterial", "<PropertyMaterial diffuseColor=\"65280\"/>") + shown +
                  text_property("OverrideMaterial", "true"));
  d.members.emplace_back("One", colors({0x12345600, 0x12345600}));
  // A box of 1 x 2 x 3 has its faces in pairs along x, y and z.
  d.members.emplace_back(
      "Many", colors({0x12345600, 0x12345600, 0xffd70000, 0x12345600, 0xffd70000, 0xffd70000}));
  d.members.emplace_back("Cut", colors({0x12345600, 0xff}));
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), (Paths{"A", "B", "C", "D", "L"}));
  EXPECT_EQ(scene.parts[0].color, "#ff0000");
  EXPECT_EQ(scene.parts[1].color, "#123456");
  EXPECT_FALSE(scene.parts[1].face_colors);
  EXPECT_EQ(scene.parts[2].color, "#123456");
  ASSERT_TRUE(scene.parts[2].face_colors);
  EXPECT_EQ(scene.parts[2].face_colors->colors, std::vector<std::string>{"#ffd700"});
  EXPECT_EQ(scene.parts[2].face_colors->of_face, (std::vector<std::int32_t>{-1, -1, 0, -1, 0, 0}));
  EXPECT_EQ(scene.parts[3].color, "") << "a list of another length";
  EXPECT_EQ(scene.parts[4].color, "#0000ff");
  RunContext context;
  EXPECT_EQ(inspect_fcstd(folder_ / "a.FCStd", {}, context).parts[2].colors, 2);
}

/// A list of materials as FreeCAD 1.0 writes it.
std::string materials(const std::vector<std::uint32_t>& diffuse) {
  std::string out;
  put(out, static_cast<std::uint32_t>(diffuse.size()));
  for (const std::uint32_t d : diffuse) {
    for (const std::uint32_t p : {0x55555500U, d, 0x88888800U, 0U, 0x3f666666U, 0U}) put(out, p);
  }
  const std::string id = "7f9fd73b-50c9-41d8-b7b2-575a030c1eeb";
  for (std::size_t i = 0; i < diffuse.size(); ++i) {
    put(out, 0U);
    put(out, 0U);
    put(out, static_cast<std::uint32_t>(id.size()));
    out += id;
  }
  return out;
}

TEST_F(FcstdTest, ColorsOfFreecad1ComeFromTheAppearanceOfTheShape) {
  Document d;
  for (const char* name : {"A", "B", "C", "D"}) d.add_shape(name, located_box(kUnit, {}), hidden());
  const auto appearance = [](const std::string& member) {
    return text_property("Visibility", "true") +
           property("ShapeAppearance", "<MaterialList file=\"" + member + "\" version=\"3\"/>");
  };
  d.view("A", appearance("One"));
  d.view("B", appearance("Same"));
  d.view("C", appearance("Many"));
  d.view("D", appearance("Cut"));
  d.members.emplace_back("One", materials({0x12345600}));
  d.members.emplace_back("Same", materials({0xff000000, 0xff0000ff}));
  d.members.emplace_back(
      "Many", materials({0x12345600, 0x12345600, 0x12345600, 0x12345600, 0x65432100, 0x65432100}));
  d.members.emplace_back("Cut", materials({0x12345600, 0x12345600}).substr(0, 40));
  const Scene scene = read(d);
  ASSERT_EQ(paths(scene), (Paths{"A", "B", "C", "D"}));
  EXPECT_EQ(scene.parts[0].color, "#123456");
  EXPECT_EQ(scene.parts[1].color, "#ff0000");
  EXPECT_EQ(scene.parts[2].color, "#123456");
  ASSERT_TRUE(scene.parts[2].face_colors);
  EXPECT_EQ(scene.parts[2].face_colors->colors, std::vector<std::string>{"#654321"});
  EXPECT_EQ(scene.parts[3].color, "");
}

TEST_F(FcstdTest, OpacitiesOfFacesAreKept) {
  Document d;
  for (const char* name : {"A", "B"}) d.add_shape(name, located_box(kUnit, {}));
  const auto faces = [](const std::string& member) {
    return property("DiffuseColor", "<ColorList file=\"" + member + "\"/>");
  };
  d.view("A", faces("Window"));
  d.view("B", faces("Glass"));
  const std::uint32_t grey = 0x80808000, glass = 0x80c0ff99;
  d.members.emplace_back("Window", colors({grey, grey, grey, grey, grey, glass}));
  d.members.emplace_back("Glass", colors({0x80c0ff33, glass, glass, glass, glass, glass}));
  const Scene scene = read(d);
  ASSERT_EQ(scene.parts.size(), 2u);
  const auto faces_of = [&](std::size_t part) {
    const auto& own = scene.parts[part].face_colors;
    return own ? own->colors : std::vector<std::string>{};
  };
  EXPECT_EQ(scene.parts[0].color, "#808080");
  EXPECT_EQ(scene.parts[0].opacity, 1);
  EXPECT_EQ(faces_of(0), std::vector<std::string>{"#80c0ff66"});
  EXPECT_EQ(scene.parts[1].color, "#80c0ff");
  EXPECT_EQ(scene.parts[1].opacity, 0.8) << "the least transparent of its faces";
  EXPECT_EQ(faces_of(1), std::vector<std::string>{"#80c0ff66"});
}

TEST_F(FcstdTest, TransparencyIsKeptAsOpacity) {
  Document d;
  for (const char* name : {"A", "B", "C", "D", "E"}) d.add_shape(name, located_box(kUnit, {}));
  d.add("App::Link", "L", linked("A"));
  d.view("A", text_property("Visibility", "true"));
  d.view("B",
         property("ShapeColor", "<PropertyColor value=\"65280\"/>") + integer("Transparency", 60));
  const auto faces = [](const std::string& member) {
    return integer("Transparency", 0) +
           property("DiffuseColor", "<ColorList file=\"" + member + "\"/>");
  };
  // FreeCAD's alpha is transparency; a face that hides what is behind makes a part that does.
  d.view("C", faces("Even"));
  d.view("D", faces("Uneven"));
  d.view("E", property("ShapeAppearance", "<MaterialList file=\"Materials\"/>"));
  d.view("L", text_property("OverrideMaterial", "true") +
                  property("ShapeMaterial",
                           "<PropertyMaterial diffuseColor=\"65280\" transparency=\"0.75\"/>"));
  d.members.emplace_back("Even", colors({0x12345680, 0x12345680}));
  d.members.emplace_back("Uneven", colors({0x12345680, 0x12345600}));
  std::string materials;
  put(materials, std::uint32_t{1});
  for (const std::uint32_t p : {0x55555500U, 0x11223300U, 0x88888800U, 0U, 0x3f666666U})
    put(materials, p);
  put(materials, 0.5F);
  d.members.emplace_back("Materials", materials);
  const Scene scene = read(d);
  ASSERT_EQ(scene.parts.size(), 6u);
  EXPECT_EQ(scene.parts[0].opacity, 1);
  EXPECT_NEAR(scene.parts[1].opacity, 0.4, 1e-12);
  EXPECT_NEAR(scene.parts[2].opacity, 1 - 128.0 / 255, 1e-12);
  EXPECT_EQ(scene.parts[3].opacity, 1);
  EXPECT_EQ(scene.parts[3].color, "#123456") << "all two of six faces";
  EXPECT_EQ(scene.parts[4].opacity, 0.5);
  EXPECT_EQ(scene.parts[4].color, "#112233");
  EXPECT_EQ(scene.parts[5].opacity, 0.25);
  RunContext context;
  const FileInfo info = inspect_fcstd(folder_ / "a.FCStd", {}, context);
  EXPECT_NEAR(info.parts[1].opacity, 0.4, 1e-12);
}

TEST_F(FcstdTest, DatumPlanesInAssembliesAreNoParts) {
  Document d;
  d.add_shape("Box", located_box(kUnit, {}));
  for (const std::string type : {"PartDesign::Plane", "Part::DatumPlane", "App::Plane"}) {
    d.add_shape(type.substr(type.find(':') + 2) + type[0], located_box(kUnit, {}), "", type);
  }
  EXPECT_EQ(paths(read(d)), Paths{"Box"});
}

TEST_F(FcstdTest, BinaryShapesAreRead) {
  const TopoDS_Shape box = located_box(kUnit, {4, 5, 6});
  std::ostringstream out;
  BinTools_ShapeSet set;
  const int number = set.Add(box);
  const int location = set.Locations().Index(box.Location());
  set.Write(out);
  for (const int i : {number, location, static_cast<int>(box.Orientation())}) {
    BinTools::PutInteger(out, i);
  }
  Document d;
  d.members.emplace_back("PartShape.bin", out.str());
  d.add("Part::Feature", "Box", property("Shape", "<Part file=\"PartShape.bin\"/>"));
  const Scene scene = read(d);
  ASSERT_EQ(scene.parts.size(), 1u);
  expect_box(scene.parts[0], {4, 5, 6}, {5, 7, 9});
  const std::string whole = out.str();
  for (std::size_t cut = 8; cut < whole.size(); cut += whole.size() / 40) {
    d.members[0].second = whole.substr(0, cut);
    EXPECT_TRUE(holds(error_of(d.bytes()), "Box: the object was left out")) << cut;
  }
}

TEST_F(FcstdTest, ABrokenShapeIsLeftOutAndNamed) {
  Document d;
  d.add_shape("Good", located_box(kUnit, {}));
  d.add("Part::Feature", "Cut", property("Shape", "<Part file=\"Cut.brp\"/>"));
  d.add("Part::Feature", "Gone", property("Shape", "<Part file=\"Gone.brp\"/>"));
  d.add("Mesh::Feature", "Mesh", property("Mesh", "<Mesh file=\"Mesh.bms\"/>"));
  const std::string text = brep_text(located_box(kUnit, {}));
  d.members.emplace_back("Cut.brp", text.substr(0, text.size() / 2));
  std::string mesh = bms(box({0, 0, 0}, {1, 1, 1}));
  mesh[8 + 256 + 8 + 8 * 12] = 77;  // a corner that does not exist
  d.members.emplace_back("Mesh.bms", mesh);
  const Scene scene = read(d);
  EXPECT_EQ(paths(scene), Paths{"Good"});
  for (const char* name : {"Cut", "Gone", "Mesh"}) {
    EXPECT_TRUE(has(scene, "fcstd.broken_shape", name)) << name;
  }
}

TEST_F(FcstdTest, NothingToDrawIsToldInOneLine) {
  Document d;
  EXPECT_TRUE(holds(error_of(d.bytes()), "holds no shapes"));
  d.add("App::FeaturePython", "Illustration",
        property("Proxy",
                 "<Python value=\"e30=\" encoded=\"yes\" module=\"freecad.burin_wb"
                 ".features\" class=\"Illustration\"/>"));
  EXPECT_TRUE(holds(error_of(d.bytes()), "Burin illustrations only"));
  d.add_shape("Box", located_box(kUnit, {}), text_property("Label", "Lid") + hidden());
  EXPECT_TRUE(holds(error_of(d.bytes()), "`object 'Lid'`"));
}

TEST_F(FcstdTest, WhatIsNoDocumentIsRefused) {
  EXPECT_TRUE(holds(error_of("solid x\n"), "is no FreeCAD document"));
  EXPECT_TRUE(holds(error_of(Document::zipped({{"a", "b"}})), "without a Document.xml"));
  EXPECT_TRUE(holds(error_of(Document::zipped({{"Document.xml", "<Document><a>\n\n</b>"}})),
                    "Document.xml, line 3: bad XML"));
  EXPECT_TRUE(holds(error_of(Document::zipped({{"Document.xml", "<a/>"}})), "no document of Free"));
  Document d;
  d.add_shape("Box", located_box(kUnit, {}));
  const std::string bytes = d.bytes();
  EXPECT_TRUE(holds(error_of(bytes.substr(0, bytes.size() / 2)), "truncated"));
}

TEST_F(FcstdTest, ABombIsNotUnpacked) {
  Document d;
  d.add_shape("Good", located_box(kUnit, {}));
  d.add("Part::Feature", "Bomb", property("Shape", "<Part file=\"Bomb.brp\"/>"));
  d.members.emplace_back("Bomb.brp", std::string(std::size_t{40} << 20, ' '));
  const Scene scene = read(d);
  EXPECT_EQ(paths(scene), Paths{"Good"});
  EXPECT_TRUE(has(scene, "fcstd.broken_shape", "hostile"));
}

TEST_F(FcstdTest, CyclesEnd) {
  Document d;
  d.add("App::Part", "A", group({"B", "A"}));
  d.add("App::Part", "B", group({"A", "Box"}));
  d.add_shape("Box", located_box(kUnit, {}));
  d.add("App::Link", "L", linked("L"));
  d.add("App::Link", "M", linked("N"));
  d.add("App::Link", "N", linked("M"));
  const Scene scene = read(d);
  EXPECT_EQ(scene.parts.size(), 1u);
  EXPECT_TRUE(has(scene, "fcstd.cycle", "L: "));
  EXPECT_EQ(read(d, {.objects = {"Box"}}).parts.size(), 1u);
}

TEST_F(FcstdTest, LinksThatMultiplyAreRefused) {
  Document d;
  d.add_shape("Box", located_box(kUnit, {}));
  d.add("App::Part", "P0", group({"Box"}));
  for (int i = 1; i <= 40; ++i) {
    const std::string before = fmt::format("P{}", i - 1);
    for (const char* side : {"a", "b"})
      d.add("App::Link", side + std::to_string(i), linked(before));
    d.add("App::Part", fmt::format("P{}", i),
          group({fmt::format("a{}", i), fmt::format("b{}", i)}));
  }
  EXPECT_TRUE(holds(error_of(d.bytes()), "absurdly many"));
  Document array;
  array.add_shape("Box", located_box(kUnit, {}));
  array.add("App::Link", "L",
            linked("Box") + property("ElementCount", "<Integer value=\"2000000000\"/>"));
  EXPECT_TRUE(holds(error_of(array.bytes()), "absurdly many"));
}

TEST_F(FcstdTest, CancelledRunsEnd) {
  Document d;
  d.add_shape("Box", located_box(kUnit, {}));
  folder_.write("a.FCStd", d.bytes());
  RunContext context;
  context.cancel();
  EXPECT_THROW(read_fcstd(folder_ / "a.FCStd", {}, context), Cancelled);
}

TEST_F(FcstdTest, DamagedDocumentsAreReadOrRefused) {
  constexpr std::string_view kSpice[] = {"-1",  "<",     "\"",           "99999999999",
                                         "nan", "1e999", "\xff",         "</Property>",
                                         "Box", "Asm",   "value=\"Asm\""};
  Document d;
  d.add("App::Part", "Asm", group({"Box", "L"}) + placed({1, 2, 3}));
  d.add_shape("Box", located_box(kUnit, {}));
  d.add("App::Link", "L", linked("Box") + property("ElementCount", "<Integer value=\"3\"/>"));
  d.add("Mesh::Feature", "M", property("Mesh", "<Mesh file=\"M.bms\"/>"));
  const std::string xml = d.xml(), shape = d.members[0].second,
                    mesh = bms(box({0, 0, 0}, {1, 1, 1}));
  d.members.emplace_back("M.bms", mesh);
  const std::string archive = d.bytes();
  const Rng rng(5);
  std::uint64_t n = 0;
  int read = 0, refused = 0;
  for (int i = 0; i < 600; ++i) {
    std::string bytes;
    if (i % 4 == 0) {
      bytes = mutated(archive, kSpice, rng, n);
    } else {
      const auto maybe = [&](int which, const std::string& good) {
        return i % 4 == which ? mutated(good, kSpice, rng, n) : good;
      };
      bytes = Document::zipped({{"Document.xml", maybe(1, xml)},
                                {"PartShapeBox.brp", maybe(2, shape)},
                                {"M.bms", maybe(3, mesh)}});
    }
    try {
      RunContext context;
      read_fcstd(folder_.write("f.FCStd", bytes), {}, context);
      ++read;
    } catch (const InputError& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
      ++refused;
    }
  }
  EXPECT_GT(read, 50);
  EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace burin::test
