// Colours of meshes: those of parts, and of faces where they differ.
#include <burin/forms/recognised/recognised_form.h>

#include "reading.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

using test::read_scene;

const std::string kOff = "4 4 0\n";
const std::string kPoints = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

Part only(const Scene& scene) {
  EXPECT_EQ(scene.parts.size(), 1u);
  return scene.parts.at(0);
}

/// Of a tetrahedron whose last face differs from the others.
void expect_last_face(const Part& part, const std::string& color) {
  ASSERT_TRUE(part.face_colors);
  EXPECT_EQ(part.face_colors->colors, std::vector<std::string>{color});
  RunContext context;
  const auto surface = part.form->realise({}, context);
  const ProxyMesh& proxy = surface->proxy();
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const bool last = std::ranges::none_of(proxy.mesh.triangles[f], [&](std::uint32_t v) {
      return glm::length(proxy.mesh.positions[v]) == 0;
    });
    EXPECT_EQ(part.face_colors->at(proxy.face_source(f)), last ? 0 : -1);
  }
}

std::string off_faces(const std::string& color, const std::string& last) {
  return "3 0 2 1 " + color + "\n3 0 1 3 " + color + "\n3 0 3 2 " + color + "\n3 1 2 3 " + last +
         "\n";
}

TEST(Look, FacesOfOff) {
  const auto read = [](const std::string& color, const std::string& last) {
    return read_scene("OFF\n" + kOff + kPoints + off_faces(color, last), "a.off");
  };
  EXPECT_EQ(only(read("255 128 0", "255 128 0")).color, "#ff8000");
  const Part glass = only(read("1.0 0.5 0 0.25", "1.0 0.5 0 0.25"));
  EXPECT_EQ(glass.color, "#ff8000");
  EXPECT_NEAR(glass.opacity, 0.25, 1 / 255.0);
  const Scene uneven = read("255 0 0", "0 0 255");
  EXPECT_EQ(only(uneven).color, "#ff0000");
  expect_last_face(only(uneven), "#0000ff");
  EXPECT_EQ(only(read("7", "7")).color, "");  // a place in a table
  EXPECT_EQ(only(read("", "")).color, "");
}

TEST(Look, VerticesOfOff) {
  const std::string points = "0 0 0 0 0 255 255\n1 0 0 0 0 255 255\n0 1 0 0 0 255 255\n";
  const Scene scene =
      read_scene("COFF\n" + kOff + points + "0 0 1 0 0 255 255\n" + off_faces("", ""), "a.off");
  EXPECT_EQ(only(scene).color, "#0000ff");
}

std::string ply(const std::string& type, const std::string& vertices, const std::string& of_face,
                const std::string& faces) {
  const auto channels = [&](const std::string& kind) {
    return "property " + kind + " red\nproperty " + kind + " green\nproperty " + kind + " blue\n";
  };
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
         "float z\n" +
         (type.empty() ? "" : channels(type)) +
         "element face 4\nproperty list uchar int vertex_indices\n" +
         (of_face.empty() ? "" : channels(of_face)) + "end_header\n" + vertices + faces;
}

TEST(Look, VerticesAndFacesOfPly) {
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const auto points = [](const std::string& color) {
    return "0 0 0 " + color + "\n1 0 0 " + color + "\n0 1 0 " + color + "\n0 0 1 " + color + "\n";
  };
  EXPECT_EQ(only(read_scene(ply("uchar", points("255 128 0"), "", faces), "a.ply")).color,
            "#ff8000");
  EXPECT_EQ(only(read_scene(ply("float", points("1 0.5 0"), "", faces), "a.ply")).color, "#ff8000");
  const std::string blue = "3 0 2 1 0 0 255\n3 0 1 3 0 0 255\n3 0 3 2 0 0 255\n3 1 2 3 0 0 255\n";
  EXPECT_EQ(only(read_scene(ply("uchar", points("255 128 0"), "uchar", blue), "a.ply")).color,
            "#0000ff");
  EXPECT_EQ(only(read_scene(ply("", kPoints, "", faces), "a.ply")).color, "");
  const std::string mixed = "0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n0 0 1 9 9 8\n";
  const Scene uneven = read_scene(ply("uchar", mixed, "", faces), "a.ply");
  // Faces have the colour of two of their corners.
  EXPECT_EQ(only(uneven).color, "#090909");
  EXPECT_FALSE(only(uneven).face_colors);
  const std::string gold = "3 0 2 1 0 0 255\n3 0 1 3 0 0 255\n3 0 3 2 0 0 255\n3 1 2 3 255 215 0\n";
  const Scene scene = read_scene(ply("", kPoints, "uchar", gold), "a.ply");
  EXPECT_EQ(only(scene).color, "#0000ff");
  expect_last_face(only(scene), "#ffd700");
}

TEST(Look, SoManyColoursAreNoneOfFaces) {
  std::string points, faces;
  for (int i = 0; i < 65; ++i) {
    for (const char* at : {" 0 0 ", " 1 0 ", " 0 1 "}) points += std::to_string(i) + at + "\n";
    faces += "3 " + std::to_string(3 * i) + " " + std::to_string(3 * i + 1) + " " +
             std::to_string(3 * i + 2) + " " + std::to_string(i) + " 0 0\n";
  }
  const auto read = [&](const std::string& last) {
    return read_scene("OFF\n195 65 0\n" + points + faces.substr(0, faces.rfind("64 0 0")) + last,
                      "a.off");
  };
  const Scene many = read("64 0 0\n"), fewer = read("63 0 0\n");
  EXPECT_EQ(only(many).color, "");
  EXPECT_FALSE(only(many).face_colors);
  EXPECT_EQ(test::count_of(many.diagnostics, "mesh.many_colors"), 1);
  ASSERT_TRUE(only(fewer).face_colors);
  EXPECT_EQ(only(fewer).face_colors->colors.size(), 63u);
  EXPECT_EQ(test::count_of(fewer.diagnostics, "mesh.many_colors"), 0);
}

TEST(Look, MaterialsOfObj) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string closed = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const std::string library =
      "# by hand\nnewmtl red paint\nKd 1 0 0\nKa 0 0 0\n\nnewmtl glass\r\nKd 0 0 1\r\nd -halo "
      "0.25\r\n"
      "newmtl worn\nKd 1 1 1\nTr 0.5\nmap_Kd wood.png\nnewmtl mist\nkd 0.5\ntr 0.75\n";
  const test::Folder folder;
  folder.write("my colours.mtl", library);
  const auto read = [&](const std::string& text) {
    const RunContext context;
    return read_mesh(folder.write("a.obj", text), context);
  };
  const Scene scene =
      read("mtllib C:\\models\\my colours.mtl\n" + points + "o a\nusemtl red paint\n" + closed +
           "o b\nusemtl glass\n" + closed + "o c\nusemtl worn\n" + closed + "o d\nusemtl mist\n" +
           closed + "o e\nusemtl glass\nf 1 3 2\nf 1 2 4\n" +
           "usemtl red paint\nf 1 4 3\nf 2 3 4\no f\nusemtl lost\n" + closed);
  ASSERT_EQ(scene.parts.size(), 6u);
  const std::vector<std::string> colors = {"#ff0000", "#0000ff", "", "#808080", "#ff0000", ""};
  for (std::size_t i = 0; i < colors.size(); ++i) EXPECT_EQ(scene.parts[i].color, colors[i]) << i;
  EXPECT_NEAR(scene.parts[1].opacity, 0.25, 1 / 255.0);
  EXPECT_NEAR(scene.parts[3].opacity, 0.25, 1 / 255.0);
  EXPECT_EQ(scene.parts[2].opacity, 1);
  ASSERT_TRUE(scene.parts[4].face_colors);
  EXPECT_EQ(scene.parts[4].face_colors->colors, std::vector<std::string>{"#0000ff40"});
  EXPECT_EQ(scene.parts[4].opacity, 1) << "a part of it is solid";

  const Scene lost = read("mtllib gone.mtl\n" + points + "usemtl x\n" + closed);
  EXPECT_EQ(only(lost).color, "");
  EXPECT_EQ(test::count_of(lost.diagnostics, "obj.no_materials"), 1);
}

TEST(Look, FacesOfGlassMakeAPartOfGlassWhereAllAre) {
  const auto read = [](const std::string& color, const std::string& last) {
    return only(read_scene("OFF\n" + kOff + kPoints + off_faces(color, last), "a.off"));
  };
  // Three faces of 0.5 and one of 0.87.
  const Part glass = read("255 0 0 128", "0 0 255 64");
  EXPECT_EQ(glass.color, "#ff0000");
  EXPECT_NEAR(glass.opacity, 0.5, 1 / 255.0);
  expect_last_face(glass, "#0000ff40");
  const Part window = read("255 0 0", "0 0 255 64");
  EXPECT_EQ(window.color, "#ff0000");
  EXPECT_EQ(window.opacity, 1);
  expect_last_face(window, "#0000ff40");
  const Part mostly = read("255 0 0 128", "0 0 255");
  EXPECT_EQ(mostly.color, "#0000ff") << "the colour of what is solid";
  EXPECT_EQ(mostly.opacity, 1);
  ASSERT_TRUE(mostly.face_colors);
  EXPECT_EQ(mostly.face_colors->colors, std::vector<std::string>{"#ff000080"});
}

/// Of a cylinder about z with 32 facets: a half of its wall is red, as is its top; the rest is
/// green.
TEST(Look, FacesThatAreRecognisedKeepTheirs) {
  const TriMesh mesh = test::cylinder(10, 20, 32);
  std::string text = "OFF\n" + std::to_string(mesh.positions.size()) + " " +
                     std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3& p : mesh.positions)
    text += fmt::format("{:.17g} {:.17g} {:.17g}\n", p.x, p.y, p.z);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    const Vec3 n = mesh.normal(t);
    const bool red = n.z > 0.5 || (std::abs(n.z) < 0.5 && n.x > 0);
    text += fmt::format("3 {} {} {} {}\n", c[0], c[1], c[2], red ? "255 0 0" : "0 255 0");
  }
  const test::TempFile file("a.off", text);
  RunContext context;
  const Part part = only(read_mesh(file.path(), context, Facets::Recognised));
  ASSERT_TRUE(dynamic_cast<const RecognisedForm*>(part.form.get()));
  ASSERT_TRUE(part.face_colors);
  ASSERT_EQ(part.face_colors->colors.size(), 1u);
  const bool own_is_red = part.color == "#ff0000";
  const auto surface = part.form->realise({.tolerance = 0.01}, context);
  const ProxyMesh& proxy = surface->proxy();
  EXPECT_GT(proxy.mesh.triangles.size(), mesh.triangles.size());
  double red = 0, green = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const bool own = part.face_colors->at(proxy.face_source(f)) < 0;
    const Vec3 n = proxy.mesh.normal(f);
    (own == own_is_red ? red : green) += proxy.mesh.area(f);
    if (n.z < -0.5 || n.x < -0.2) {
      EXPECT_NE(own, own_is_red) << f;
    }
    if (n.z > 0.5 || n.x > 0.2) {
      EXPECT_EQ(own, own_is_red) << f;
    }
  }
  EXPECT_NEAR(red / green, 1, 1e-3);
}

TEST(Look, VerticesOfObj) {
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const auto read = [&](const std::string& color, const std::string& last) {
    return read_scene("v 0 0 0 " + color + "\nv 1 0 0 " + color + "\nv 0 1 0 " + color +
                          "\nv 0 0 1 " + last + "\n" + faces,
                      "a.obj");
  };
  EXPECT_EQ(only(read("1 0.5 0", "1 0.5 0 # end")).color, "#ff8000");
  EXPECT_EQ(only(read("255 128 0", "255 128 0")).color, "#ff8000");
  EXPECT_EQ(only(read("1.0", "1.0")).color, "");  // a weight
  for (const char* last : {"0 0 1", ""}) {
    const Scene uneven = read("1 0 0", last);
    EXPECT_EQ(only(uneven).color, "#ff0000");
    EXPECT_FALSE(only(uneven).face_colors) << "two corners of three are red";
  }
}

TEST(Look, MaterialsOfObjThatGiveTransparencyTwice) {
  const test::Folder folder;
  folder.write("a.mtl",
               "newmtl full\nKd 1 0 0\nd 1.0\nTr 1.0\nnewmtl late\nKd 1 0 0\nTr 1\nd 0.5\n"
               "newmtl lone\nKd 1 0 0\nTr 0.75\n");
  const auto opacity = [&](const std::string& material) {
    const std::string file = folder.write(
        "a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl " + material + "\nf 1 2 3\n");
    const RunContext context;
    return only(read_mesh(file, context)).opacity;
  };
  EXPECT_EQ(opacity("full"), 1);
  EXPECT_NEAR(opacity("late"), 0.5, 1 / 255.0);
  EXPECT_NEAR(opacity("lone"), 0.25, 1 / 255.0);
}

}  // namespace
}  // namespace burin
