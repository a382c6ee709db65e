#include "reading.h"

#include <map>

namespace burin {
namespace {

using test::zipped;

constexpr const char* kRelationships =
    "<?xml version=\"1.0\"?><Relationships "
    "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
    "Id=\"r0\" "
    "Target=\"/3D/here.model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";

std::string archive(const std::string& model) {
  return zipped({{"[Content_Types].xml", "<Types/>"},
                 {"_rels/.rels", kRelationships},
                 {"3D/here.model", model}});
}

std::string model(const std::string& resources, const std::string& build,
                  const std::string& attributes = "") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model " + attributes +
         " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/"
         "06\">\n<resources>\n" +
         resources + "</resources>\n<build>" + build + "</build></model>\n";
}

std::string mesh(const TriMesh& m) {
  std::string out = "<mesh><vertices>\n";
  for (const Vec3& p : m.positions)
    out += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", p.x, p.y, p.z);
  out += "</vertices><triangles>\n";
  for (const Triangle& t : m.triangles) {
    out += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\" pid=\"1\"/>\n", t[0], t[1], t[2]);
  }
  return out + "</triangles></mesh>";
}

std::string model_object(int id, const std::string& name, const std::string& content) {
  return fmt::format("<object id=\"{}\" name=\"{}\" type=\"model\">{}</object>\n", id, name,
                     content);
}

const TriMesh kThreemfBox = test::box({0, 0, 0}, {1, 2, 3});

Box3 bounds(const Scene& scene, std::size_t part) {
  return scene.parts.at(part).form->bounds(Mat3(1));
}

void expect_bounds(const Box3& box, Vec3 low, Vec3 high) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(box.min[k], low[k], 1e-9);
    EXPECT_NEAR(box.max[k], high[k], 1e-9);
  }
}

TEST(ThreeMf, ReadsDoubles) {
  const TriMesh box = test::precise_box();
  const MeshFile file = test::read_bytes(
      archive(model(model_object(1, "a &lt;b&gt; &#228;", mesh(box)), "<item objectid=\"1\"/>")),
      "a.3mf");
  EXPECT_EQ(file.format, "3MF");
  test::expect_mesh(file, box);
  EXPECT_EQ(file.objects[0].name, "a <b> \xc3\xa4");
}

TEST(ThreeMf, IsKnownByContent) {
  const std::string bytes =
      archive(model(model_object(1, "", mesh(kThreemfBox)), "<item objectid=\"1\"/>"));
  EXPECT_EQ(test::read_bytes(bytes, "a.stl").format, "3MF");
}

TEST(ThreeMf, UnitsBecomeMillimetres) {
  const std::map<std::string, double> units = {{"micron", 1e-3},   {"millimeter", 1},
                                               {"centimeter", 10}, {"inch", 25.4},
                                               {"foot", 304.8},    {"meter", 1000}};
  for (const auto& [name, mm] : units) {
    const Scene scene = test::read_scene(
        archive(model(model_object(1, "", mesh(kThreemfBox)),
                      "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/>",
                      "unit=\"" + name + "\"")),
        "a.3mf");
    expect_bounds(bounds(scene, 0), Vec3(5, 0, 0) * mm, Vec3(6, 2, 3) * mm);
  }
}

TEST(ThreeMf, ComponentsAndItemsAreMoved) {
  // Rows of the transform are the images of the axes; the component is turned about z, then the
  // item shifts it.
  const std::string objects =
      model_object(1, "wheel", mesh(kThreemfBox)) +
      model_object(2, "axle",
                   "<components><component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 10 0 0\"/>"
                   "<component objectid=\"1\"/></components>");
  const Scene scene = test::read_scene(
      archive(model(
          objects,
          "<item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 100 0\"/><item objectid=\"1\"/>")),
      "a.3mf");
  ASSERT_EQ(scene.parts.size(), 3u);
  expect_bounds(bounds(scene, 0), {16, 100, 0}, {20, 102, 6});
  expect_bounds(bounds(scene, 1), {0, 100, 0}, {2, 104, 6});
  expect_bounds(bounds(scene, 2), {0, 0, 0}, {1, 2, 3});
  EXPECT_EQ(scene.parts[0].name, "wheel");
}

TEST(ThreeMf, MirroredItemsStayRightSideOut) {
  const auto objects = placed_objects(test::read_bytes(
      archive(model(model_object(1, "", mesh(kThreemfBox)),
                    "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>")),
      "a.3mf"));
  TriMesh m;
  m.positions = objects.at(0).positions;
  for (std::size_t i = 0; i < objects[0].indices.size(); i += 3) {
    const auto* c = &objects[0].indices[i];
    m.triangles.push_back({c[0], c[1], c[2]});
  }
  EXPECT_NEAR(test::numbers(m).volume, 6, 1e-12);
}

TEST(ThreeMf, UsesOfOneObjectShareAForm) {
  const std::string six_digits = "0.866025 0.5 0 -0.5 0.866025 0 0 0 1 50 0 0";
  const std::string sheared = "1 0 0 0.5 1 0 0 0 2 0 50 0";
  const Scene scene = test::read_scene(
      archive(model(model_object(1, "foot", mesh(kThreemfBox)),
                    "<item objectid=\"1\"/><item objectid=\"1\" transform=\"" + six_digits +
                        "\"/><item objectid=\"1\" transform=\"" + sheared +
                        "\"/><item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 9\"/>")),
      "a.3mf");
  ASSERT_EQ(scene.parts.size(), 4u);
  const auto shape = [&](std::size_t i) { return scene.parts[i].form->definition().shape; };
  EXPECT_EQ(shape(0), shape(1));
  EXPECT_TRUE(scene.parts[0].form->definition().same(scene.parts[1].form->definition()));
  EXPECT_FALSE(scene.parts[0].form->definition().same(scene.parts[2].form->definition()));
  expect_bounds(bounds(scene, 2), {0, 50, 0}, {2, 52, 6});
  expect_bounds(bounds(scene, 3), {-1, 0, 9}, {0, 2, 12});
  RunContext context;
  EXPECT_NEAR(scene.parts[2].form->measure(context).volume, 12, 1e-9);
}

TEST(ThreeMf, ColoursOfMaterialsAndColourGroups) {
  const std::string groups =
      "<basematerials id=\"5\"><base name=\"red\" displaycolor=\"#FF0000FF\"/><base name=\"g\" "
      "displaycolor=\"#0000fF40\"/></basematerials><m:colorgroup id=\"6\" "
      "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\"><m:color "
      "color=\"#00FF00\"/><m:color color=\"#00FE00\"/></m:colorgroup>";
  const auto of = [](int id, const std::string& properties, std::string m) {
    for (std::size_t at = m.find(" pid=\"1\""); at != std::string::npos;
         at = m.find(" pid=\"1\"")) {
      m.erase(at, 8);
    }
    std::string text = model_object(id, fmt::format("o{}", id), m);
    return text.replace(text.find("<object") + 7, 0, " " + properties);
  };
  std::string two = mesh(kThreemfBox), even = mesh(kThreemfBox);
  two.replace(two.find("pid=\"1\""), 7, "pid=\"6\" p1=\"0\" p2=\"1\" p3=\"0\"");
  for (std::size_t at = even.find("pid=\"1\""); at != std::string::npos;
       at = even.find("pid=\"1\"")) {
    even.replace(at, 7, "pid=\"6\" p1=\"1\"");
  }
  const Scene scene = test::read_scene(
      archive(model(groups + of(1, "pid=\"5\" pindex=\"0\"", mesh(kThreemfBox)) +
                        of(2, "pid=\"5\" pindex=\"1\"", mesh(kThreemfBox)) +
                        of(3, "pid=\"6\" pindex=\"0\"", two) +
                        of(4, "pid=\"5\" pindex=\"0\"", even) + of(7, "", mesh(kThreemfBox)),
                    "<item objectid=\"1\"/><item objectid=\"2\"/><item objectid=\"3\"/>"
                    "<item objectid=\"4\"/><item objectid=\"7\"/>")),
      "a.3mf");
  ASSERT_EQ(scene.parts.size(), 5u);
  const std::vector<std::string> colors = {"#ff0000", "#0000ff", "#00ff00", "#00fe00", ""};
  for (std::size_t i = 0; i < colors.size(); ++i) EXPECT_EQ(scene.parts[i].color, colors[i]) << i;
  EXPECT_EQ(scene.parts[0].opacity, 1);
  EXPECT_NEAR(scene.parts[1].opacity, 64 / 255.0, 1e-12);
  EXPECT_FALSE(scene.parts[2].face_colors) << "two corners of three are as the rest";
}

TEST(ThreeMf, SupportsAreLeftOutAndTold) {
  std::string support = model_object(2, "brace", mesh(kThreemfBox)),
              other = model_object(3, "tool", mesh(kThreemfBox));
  support.replace(support.find("type=\"model\""), 12, "type=\"support\"");
  other.replace(other.find("type=\"model\""), 12, "type=\"other\"");
  const std::string items = "<item objectid=\"1\"/><item objectid=\"2\"/><item objectid=\"3\"/>";
  const std::string objects = model_object(1, "a", mesh(kThreemfBox)) + support + other;
  for (const std::string& build : {items, std::string()}) {
    const Scene scene = test::read_scene(archive(model(objects, build)), "a.3mf");
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(scene.parts[0].name, "a");
    EXPECT_EQ(test::count_of(scene.diagnostics, "3mf.supports"), 2);
  }
  test::expect_error(archive(model(support, "<item objectid=\"2\"/>")), "a.3mf", 0,
                     "holds support objects alone");
}

/// What Bambu Studio writes: objects without names, and names in its settings.
std::string sliced(const std::string& parts, const std::string& components) {
  const std::string config =
      "<?xml version=\"1.0\"?><config><object id=\"2\"><metadata key=\"name\" value=\"Foot "
      "left\"/><metadata key=\"extruder\" value=\"2\"/>" +
      parts + "</object></config>";
  const std::string root =
      "<object id=\"2\" type=\"model\"><components>" + components + "</components></object>";
  const std::string other = "<object id=\"1\" type=\"model\">" + mesh(kThreemfBox) +
                            "</object><object id=\"3\" type=\"model\">" + mesh(kThreemfBox) +
                            "</object>";
  return zipped({{"_rels/.rels", kRelationships},
                 {"3D/here.model", model(root, "<item objectid=\"2\"/>")},
                 {"3D/Objects/o.model", model(other, "")},
                 {"Metadata/model_settings.config", config},
                 {"Metadata/project_settings.config",
                  "{\"filament_colour\": [\"#101010\", \"#20A0FFFF\"]}"}});
}

std::string component(int id) {
  return fmt::format("<component p:path=\"/3D/Objects/o.model\" objectid=\"{}\"/>", id);
}

std::string settings_of(int id, const std::string& name, const std::string& kind) {
  return fmt::format("<part id=\"{}\" subtype=\"{}\"><metadata key=\"name\" value=\"{}\"/></part>",
                     id, kind, name);
}

TEST(ThreeMf, NamesThatSlicersKeep) {
  const Scene one =
      test::read_scene(sliced(settings_of(1, "foot.stl", "normal_part"), component(1)), "a.3mf");
  ASSERT_EQ(one.parts.size(), 1u);
  EXPECT_EQ(one.parts[0].name, "Foot left");
  EXPECT_TRUE(one.parts[0].assembly.empty());
  EXPECT_EQ(one.parts[0].color, "#20a0ff");

  const Scene two = test::read_scene(
      sliced(settings_of(1, "Body", "normal_part") + settings_of(3, "Pad", "normal_part"),
             component(1) + component(3)),
      "a.3mf");
  ASSERT_EQ(two.parts.size(), 2u);
  EXPECT_EQ(two.parts[0].name, "Body");
  EXPECT_EQ(two.parts[1].name, "Pad");
  EXPECT_EQ(two.parts[1].assembly, std::vector<std::string>{"Foot left"});

  const Scene modified = test::read_scene(
      sliced(settings_of(1, "Body", "normal_part") + settings_of(3, "Hole", "negative_part"),
             component(1) + component(3)),
      "a.3mf");
  ASSERT_EQ(modified.parts.size(), 1u);
  EXPECT_EQ(modified.parts[0].name, "Foot left");
  EXPECT_EQ(test::count_of(modified.diagnostics, "3mf.modifiers"), 1);
}

TEST(ThreeMf, VolumesOfPrusaSlicer) {
  TriMesh both = kThreemfBox;
  const TriMesh pad = test::box({5, 0, 0}, {6, 1, 1});
  for (const Triangle& t : pad.triangles) {
    both.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  }
  both.positions.insert(both.positions.end(), pad.positions.begin(), pad.positions.end());
  const auto read = [&](const std::string& type) {
    const std::string config =
        "<config><object id=\"1\"><metadata type=\"object\" key=\"name\" value=\"Tray\"/><volume "
        "firstid=\"0\" lastid=\"11\"><metadata key=\"name\" value=\"Base\"/></volume><volume "
        "firstid=\"12\" lastid=\"23\"><metadata key=\"name\" value=\"Lid\"/><metadata "
        "key=\"volume_type\" value=\"" +
        type + "\"/></volume></object></config>";
    return test::read_scene(
        zipped({{"_rels/.rels", kRelationships},
                {"3D/here.model", model(model_object(1, "", mesh(both)), "<item objectid=\"1\"/>")},
                {"Metadata/Slic3r_PE_model.config", config}}),
        "a.3mf");
  };
  const Scene parts = read("ModelPart");
  ASSERT_EQ(parts.parts.size(), 2u);
  EXPECT_EQ(parts.parts[0].name, "Base");
  EXPECT_EQ(parts.parts[1].name, "Lid");
  EXPECT_EQ(parts.parts[1].assembly, std::vector<std::string>{"Tray"});
  expect_bounds(bounds(parts, 0), {0, 0, 0}, {1, 2, 3});
  expect_bounds(bounds(parts, 1), {5, 0, 0}, {6, 1, 1});
  const Scene blocked = read("SupportBlocker");
  ASSERT_EQ(blocked.parts.size(), 1u);
  EXPECT_EQ(blocked.parts[0].name, "Tray");
  expect_bounds(bounds(blocked, 0), {0, 0, 0}, {1, 2, 3});
  EXPECT_EQ(test::count_of(blocked.diagnostics, "3mf.modifiers"), 1);
}

TEST(ThreeMf, ObjectsOfOtherModelParts) {
  const std::string other = model(model_object(7, "inner", mesh(kThreemfBox)), "");
  const std::string root =
      model(model_object(1, "outer",
                         "<components><component p:path=\"/3D/Objects/other.model\" "
                         "objectid=\"7\"/></components>"),
            "<item objectid=\"1\"/>");
  const Scene scene = test::read_scene(zipped({{"_rels/.rels", kRelationships},
                                               {"3D/here.model", root},
                                               {"3D/Objects/other.model", other}}),
                                       "a.3mf");
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "inner");
}

TEST(ThreeMf, EmptyBuildShowsAllObjects) {
  const MeshFile file = test::read_bytes(
      archive(model(
          model_object(1, "a", mesh(kThreemfBox)) + model_object(2, "b", mesh(kThreemfBox)), "")),
      "a.3mf");
  EXPECT_EQ(file.objects.size(), 2u);
  EXPECT_EQ(test::count_of(file.diagnostics, "3mf.no_build"), 1);
}

TEST(ThreeMf, ModelIsFoundWithoutRelationships) {
  const std::string m = model(model_object(1, "a", mesh(kThreemfBox)), "<item objectid=\"1\"/>");
  EXPECT_EQ(test::read_bytes(zipped({{"3D/3dmodel.model", m}}), "a.3mf").objects.size(), 1u);
}

void expect_model_error(const std::string& text, const std::string& part) {
  test::expect_error(archive(text), "a.3mf", 0, part);
}

TEST(ThreeMf, ErrorsNameTheMemberAndLine) {
  std::string broken = mesh(kThreemfBox);
  const std::string item = "<item objectid=\"1\"/>";
  broken.replace(broken.find("v1=\"0\""), 6, "v1=\"8\"");
  expect_model_error(model(model_object(1, "", broken), item),
                     "in 3D/here.model, line 14: a triangle refers to vertex '8', its mesh has 8");
  broken = mesh(kThreemfBox);
  broken.replace(broken.find("x=\"0\""), 5, "x=\"zero\"");
  expect_model_error(model(model_object(1, "", broken), item), "line 5: 'zero' is no number for x");
  expect_model_error(model(model_object(1, "", "<mesh><vertices>"), item), "bad XML");
  expect_model_error(model(model_object(1, "", mesh(kThreemfBox)), "<item objectid=\"2\"/>"),
                     "does not hold object '2' of 3D/here.model, which its build uses");
  expect_model_error(
      model(model_object(1, "", mesh(kThreemfBox)) + model_object(1, "", mesh(kThreemfBox)), item),
      "two objects have the id '1'");
  expect_model_error(
      model(model_object(1, "", mesh(kThreemfBox)), "<item objectid=\"1\" transform=\"1 0 0\"/>"),
      "is no transform");
  expect_model_error(model(model_object(1, "", mesh(kThreemfBox)), item, "unit=\"furlong\""),
                     "'furlong' is no unit");
  expect_model_error(model(model_object(1, "", ""), item), "holds no triangles");
  expect_model_error("<other/>", "no element 'model'");
}

TEST(ThreeMf, EntityTricksAreRefused) {
  std::string text = model(model_object(1, "&lol;", mesh(kThreemfBox)), "<item objectid=\"1\"/>");
  text.insert(text.find("<model"),
              "<!DOCTYPE model [<!ENTITY lol SYSTEM \"file:///etc/passwd\">]>\n");
  expect_model_error(text, "document type is not allowed");
}

TEST(ThreeMf, ComponentsThatExplodeOrLoopAreRefused) {
  std::string objects = model_object(1, "", mesh(kThreemfBox));
  for (int i = 2; i < 60; ++i) {  // 2^58 boxes
    const std::string c = fmt::format("<component objectid=\"{}\"/>", i - 1);
    objects += model_object(i, "", "<components>" + c + c + "</components>");
  }
  expect_model_error(model(objects, "<item objectid=\"59\"/>"), "far too many");
  expect_model_error(
      model(model_object(1, "", "<components><component objectid=\"1\"/></components>"),
            "<item objectid=\"1\"/>"),
      "contain each other");
}

TEST(ThreeMf, BombsAndDamagedArchivesAreRefused) {
  const std::string bomb =
      zipped({{"_rels/.rels", kRelationships}, {"3D/here.model", std::string(64 << 20, ' ')}});
  EXPECT_LT(bomb.size(), 200'000u);
  test::expect_error(bomb, "a.3mf", 0, "hostile and was not unpacked");
  const std::string good =
      archive(model(model_object(1, "", mesh(kThreemfBox)), "<item objectid=\"1\"/>"));
  test::expect_error(good.substr(0, good.size() / 2), "a.3mf", 0, "damaged zip archive");
  test::expect_error(zipped({{"readme.txt", "hello"}}), "a.3mf", 0, "without a 3MF model");
  test::expect_error(zipped({{"Document.xml", "<x/>"}}), "a.3mf", 0, "FreeCAD document");
  test::expect_error("solidity", "a.3mf", 0, "no 3MF file");
  std::string liar = good;  // the sizes in the central directory
  const std::size_t entry = liar.rfind("PK\x01\x02");
  liar.replace(entry + 24, 4, test::raw(std::uint32_t{0xfffffff0u}));
  test::expect_error(liar, "a.3mf", 0, "");
}

TEST(ThreeMf, AnObjectOfSeveralMeshesHoldsThemAll) {
  // Against the standard, but written, by programs that mean each of them.
  const std::string far = mesh(test::box({5, 0, 0}, {6, 2, 3}));
  const Scene scene = test::read_scene(
      archive(model(model_object(2, "pair", mesh(kThreemfBox) + far), "<item objectid=\"2\"/>")),
      "pair.3mf");
  ASSERT_EQ(scene.parts.size(), 1u);
  expect_bounds(bounds(scene, 0), {0, 0, 0}, {6, 2, 3});
}

TEST(ThreeMf, BeamsThatAreLeftOutAreTold) {
  const std::string beams =
      "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
      "</vertices><triangles/><b:beamlattice radius=\"1\"><b:beams><b:beam v1=\"0\" v2=\"1\"/>"
      "</b:beams></b:beamlattice></mesh>";
  const MeshFile file = test::read_bytes(
      archive(model(model_object(2, "lattice", beams) + model_object(3, "box", mesh(kThreemfBox)),
                    "<item objectid=\"2\"/><item objectid=\"3\"/>", "xmlns:b=\"b\"")),
      "beams.3mf");
  EXPECT_EQ(file.uses.size(), 1u);
  ASSERT_EQ(file.diagnostics.entries().size(), 1u);
  EXPECT_EQ(file.diagnostics.entries()[0].code, "3mf.beams");
  EXPECT_EQ(file.diagnostics.entries()[0].severity, Severity::Warning);
}

TEST(ThreeMf, WhatTheFileDoesNotHoldIsLeftOutAndTold) {
  const std::string item = "<item objectid=\"1\"/>";
  const std::string uses =
      "<components><component objectid=\"1\"/><component objectid=\"9\"/></components>";
  for (const std::string& text :
       {model(model_object(1, "a", mesh(kThreemfBox)), item + "<item objectid=\"7\"/>"),
        model(model_object(1, "a", mesh(kThreemfBox)),
              item + "<item objectid=\"1\" p:path=\"/3D/none.model\"/>", "xmlns:p=\"p\""),
        model(model_object(1, "a", mesh(kThreemfBox)) + model_object(2, "b", uses),
              "<item objectid=\"2\"/>")}) {
    const Scene scene = test::read_scene(archive(text), "a.3mf");
    EXPECT_EQ(scene.parts.size(), 1u);
    ASSERT_EQ(scene.diagnostics.entries().size(), 1u);
    EXPECT_EQ(scene.diagnostics.entries()[0].code, "3mf.missing");
    EXPECT_EQ(scene.diagnostics.entries()[0].severity, Severity::Warning);
  }
}

TEST(ThreeMf, MaterialsThatAreMixed) {
  const std::string groups =
      "<m:compositematerials id=\"6\" matid=\"5\" matindices=\"0 1 2\"><m:composite values=\"1 1 "
      "0\"/><m:composite values=\"0 0.5\"/><m:composite values=\"0 1 1\"/><m:composite "
      "values=\"\"/></m:compositematerials><basematerials id=\"5\"><base name=\"r\" "
      "displaycolor=\"#FF0000\"/><base name=\"b\" displaycolor=\"#0000FF\"/><base "
      "name=\"none\"/></basematerials>";
  std::string plain = mesh(kThreemfBox);
  for (std::size_t at = 0; (at = plain.find(" pid=\"1\"", at)) != plain.npos;) plain.erase(at, 8);
  std::string objects = groups, items;
  for (int i = 0; i < 4; ++i) {
    objects +=
        fmt::format("<object id=\"{}\" pid=\"6\" pindex=\"{}\">{}</object>", 10 + i, i, plain);
    items += fmt::format("<item objectid=\"{}\"/>", 10 + i);
  }
  const MeshFile file =
      test::read_bytes(archive(model(objects, items, "xmlns:m=\"m\"")), "mixed.3mf");
  ASSERT_EQ(file.uses.size(), 4u);
  EXPECT_EQ(file.uses[0].color, "#bc00bc");
  EXPECT_EQ(file.uses[1].color, "#0000ff");
  EXPECT_EQ(file.uses[2].color, "");  // one of them has none
  EXPECT_EQ(file.uses[3].color, "");
}

TEST(ThreeMf, OfSeveralLayersOfColourTheUpperOneIsSeen) {
  const std::string groups =
      "<basematerials id=\"5\"><base name=\"PLA\" displaycolor=\"#0000FF\"/></basematerials>"
      "<m:colorgroup id=\"6\"><m:color color=\"#00FF00\"/><m:color color=\"#FF000040\"/>"
      "</m:colorgroup><m:multiproperties id=\"7\" pids=\"5 6\"><m:multi pindices=\"0 1\"/>"
      "<m:multi pindices=\"0 9\"/></m:multiproperties>";
  std::string plain = mesh(kThreemfBox);
  for (std::size_t at = 0; (at = plain.find(" pid=\"1\"", at)) != plain.npos;) plain.erase(at, 8);
  const auto painted = [&](int id, int index) {
    return fmt::format("<object id=\"{}\" pid=\"7\" pindex=\"{}\">{}</object>", id, index, plain);
  };
  const MeshFile file = test::read_bytes(
      archive(model(groups + painted(8, 0) + painted(9, 1),
                    "<item objectid=\"8\"/><item objectid=\"9\"/>", "xmlns:m=\"m\"")),
      "layers.3mf");
  ASSERT_EQ(file.uses.size(), 2u);
  EXPECT_EQ(file.uses[0].color, "#8900e0");  // a quarter of red over blue, mixed as light
  EXPECT_EQ(file.uses[0].opacity, 1);
  EXPECT_EQ(file.uses[1].color, "#0000ff");
}

TEST(ThreeMf, APartNumberNamesWhatHasNoName) {
  const MeshFile file = test::read_bytes(
      archive(model("<object id=\"2\" partnumber=\"A-117\">" + mesh(kThreemfBox) + "</object>",
                    "<item objectid=\"2\"/>")),
      "a.3mf");
  ASSERT_EQ(file.uses.size(), 1u);
  EXPECT_EQ(file.uses[0].name, "A-117");
}

TEST(ThreeMf, ItemsThatAreNotPrintedAreLeftOut) {
  const std::string boxes =
      model_object(1, "a", mesh(kThreemfBox)) + model_object(2, "b", mesh(kThreemfBox));
  const auto read = [&](const char* first, const char* second) {
    return test::read_scene(
        archive(model(boxes, fmt::format("<item objectid=\"1\" printable=\"{}\"/>"
                                         "<item objectid=\"2\" printable=\"{}\"/>",
                                         first, second))),
        "a.3mf");
  };
  const Scene some = read("1", "0");
  ASSERT_EQ(some.parts.size(), 1U);
  EXPECT_EQ(some.parts[0].name, "a");
  EXPECT_EQ(some.diagnostics.entries().front().code, "3mf.not_printable");
  EXPECT_EQ(read("0", "0").parts.size(), 2U) << "a file that prints nothing is drawn whole";
  EXPECT_EQ(read("1", "1").parts.size(), 2U);
}

}  // namespace
}  // namespace burin
