// AMF: objects, volumes, materials, constellations, units.
#include "reading.h"

namespace burin {
namespace {

using test::read_scene;
using Strings = std::vector<std::string>;

std::string vertices(const TriMesh& m) {
  std::string out = "<vertices>";
  for (const Vec3& p : m.positions) {
    out +=
        fmt::format("<vertex><coordinates><x>{}</x><y> {}\n</y><z>{}</z></coordinates></vertex>\n",
                    p.x, p.y, p.z);
  }
  return out + "</vertices>";
}

std::string volume(const TriMesh& m, const std::string& attributes, const std::string& name) {
  std::string out = "<volume " + attributes + ">";
  if (!name.empty()) out += "<metadata type=\"name\">" + name + "</metadata>";
  for (const Triangle& t : m.triangles) {
    out +=
        fmt::format("<triangle><v1>{}</v1><v2>{}</v2><v3>{}</v3></triangle>\n", t[0], t[1], t[2]);
  }
  return out + "</volume>";
}

const TriMesh kBox = test::box({0, 0, 0}, {1, 2, 3});

std::string object(const std::string& id, const std::string& name, const std::string& volumes) {
  return "<object id=\"" + id + "\"><metadata type=\"name\">" + name + "</metadata><mesh>" +
         vertices(kBox) + volumes + "</mesh></object>\n";
}

std::string amf(const std::string& content, const std::string& unit = "millimeter") {
  return "<?xml version=\"1.0\"?>\n<!-- by a program -->\n<amf unit=\"" + unit + "\">\n" + content +
         "</amf>\n";
}

std::string instance(const std::string& id, const std::string& place) {
  return "<instance objectid=\"" + id + "\">" + place + "</instance>";
}

void expect_box(const Part& part, Vec3 low, Vec3 high) {
  const Box3 box = part.form->bounds(Mat3(1));
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(box.min[k], low[k], 1e-9) << part.name;
    EXPECT_NEAR(box.max[k], high[k], 1e-9) << part.name;
  }
}

TEST(Amf, AnObjectHasNameUnitAndColour) {
  const std::string text =
      amf(object("1", "Lid", volume(kBox, "materialid=\"7\"", "")) +
              "<material id=\"7\"><color><r>1</r><g>0</g><b>0</b><a>0.2</a></color></material>",
          "inch");
  for (const std::string& bytes : {text, test::zipped({{"model.amf", text}})}) {
    const Scene scene = read_scene(bytes, "lid.amf");
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(scene.parts[0].name, "Lid");
    EXPECT_EQ(scene.parts[0].color, "#ff0000");
    EXPECT_NEAR(scene.parts[0].opacity, 0.2, 1e-9);
    expect_box(scene.parts[0], {0, 0, 0}, {25.4, 50.8, 76.2});
  }
  // The bytes tell, whatever the name is.
  EXPECT_EQ(test::read_bytes(text, "lid.stl").format, "AMF");
  EXPECT_EQ(test::read_bytes(test::zipped({{"model.amf", text}}), "lid.zip").format, "AMF");
}

TEST(Amf, VolumesAreThePartsOfTheirObject) {
  const Scene scene =
      read_scene(amf(object("1", "Pump",
                            volume(kBox, "", "Case") + volume(kBox, "type=\"support\"", "Foot") +
                                volume(kBox, "", "Gasket"))),
                 "pump.amf");
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(scene.parts[0].name, "Case");
  EXPECT_EQ(scene.parts[1].name, "Gasket");
  EXPECT_EQ(scene.parts[1].assembly, Strings{"Pump"});
  ASSERT_EQ(scene.diagnostics.entries().size(), 1u);
  EXPECT_EQ(scene.diagnostics.entries()[0].code, "amf.supports");
}

TEST(Amf, ConstellationsPlaceObjectsAgainAndAgain) {
  const Scene scene = read_scene(
      amf(object("1", "Bolt", volume(kBox, "", "")) + object("2", "Alone", volume(kBox, "", "")) +
          "<constellation id=\"3\"><metadata type=\"name\">Pair</metadata>" +
          instance("1", "<deltax>10</deltax>") + instance("1", "<deltay>20</deltay><rz>90</rz>") +
          "</constellation><constellation id=\"4\">" + instance("3", "") +
          instance("3", "<deltaz>100</deltaz><rx>90</rx><rz>90</rz>") + "</constellation>"),
      "bolts.amf");
  ASSERT_EQ(scene.parts.size(), 5u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(scene.parts[i].name, "Bolt");
    EXPECT_EQ(scene.parts[i].assembly, Strings{"Pair"});
    EXPECT_TRUE(scene.parts[i].form->definition().same(scene.parts[0].form->definition()) || i > 1);
  }
  expect_box(scene.parts[0], {10, 0, 0}, {11, 2, 3});
  // (x, y) -> (-y, 20 + x)
  expect_box(scene.parts[1], {-2, 20, 0}, {0, 21, 3});
  // About x, then about z: (x, y, z) -> (x, -z, y) -> (z, x, y).
  expect_box(scene.parts[2], {0, 10, 100}, {3, 11, 102});
  EXPECT_EQ(scene.parts[4].name, "Alone");
  expect_box(scene.parts[4], {0, 0, 0}, {1, 2, 3});
}

TEST(Amf, DamageIsToldInOneLine) {
  test::expect_error("<?xml version=\"1.0\"?><amf><object></amf>", "a.amf", 0, "no readable AMF");
  test::expect_error(amf("", "parsec"), "b.amf", 0, "line 3: 'parsec' is no unit of AMF");
  test::expect_error(amf(""), "c.amf", 0, "holds no triangles");
  test::expect_error("solid\n", "d.amf", 0, "");
  const std::string box = object("1", "Lid", volume(kBox, "", ""));
  test::expect_error(
      amf(box + "<constellation id=\"2\">" + instance("3", "") +
          "</constellation><constellation id=\"3\">" + instance("4", "") +
          "</constellation><constellation id=\"4\">" + instance("3", "") + "</constellation>"),
      "f.amf", 0, "contain each other");
}

TEST(Amf, WhatTheFileDoesNotHoldIsLeftOutAndTold) {
  const std::string box = object("1", "Lid", volume(kBox, "", ""));
  const Scene scene = test::read_scene(
      amf(box + "<constellation id=\"2\">" + instance("9", "") + "</constellation>"), "a.amf");
  EXPECT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(test::count_of(scene.diagnostics, "amf.missing"), 1);
}

}  // namespace
}  // namespace burin
