// Texture coordinates of mesh files: read, and found again on the surface.
#include "../../../converters/mesh/texture.h"

#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/recognised/recognised_form.h>

#include "reading.h"

#include <fmt/format.h>

#include <cmath>

namespace burin {
namespace {

using test::read_bytes;

using Points = std::vector<glm::vec2>;

const std::string kSquare = "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\n";

Points texture(const std::string& bytes, const std::string& name) {
  return read_bytes(bytes, name).objects.at(0).texture;
}

std::shared_ptr<const Surface> surface(const Scene& scene) {
  RunContext context;
  return scene.parts.at(0).form->realise({.tolerance = 0.01}, context);
}

TEST(Texture, OfObjIsThatOfCorners) {
  const std::string points = "vt 0 0\nvt 1 0.25 0\nvt .5 1\nvt 0.25\n";
  EXPECT_EQ(texture(kSquare + points + "f 1/1 2/2 3/-2\nf 1/1/7 3/3/8 4/4\n", "a.obj"),
            (Points{{0, 0}, {1, 0.25}, {0.5, 1}, {0, 0}, {0.5, 1}, {0.25, 0}}));
  EXPECT_TRUE(texture(kSquare + "f 1 2 3\n", "a.obj").empty());
  EXPECT_TRUE(texture(kSquare + points + "f 1 2 3\n", "a.obj").empty());
  EXPECT_TRUE(texture(kSquare + "f 1/1 2/2 3/3\n", "a.obj").empty());
}

TEST(Texture, OfObjGoesWithItsGroup) {
  const MeshFile file = read_bytes("o a\n" + kSquare +
                                       "vt 0 0\nvt 1 0\nvt 1 1\no b\nf 1/3 3/2 4/1\n"
                                       "o c\nf 1/1 2/2 3/3# a word\n",
                                   "a.obj");
  ASSERT_EQ(file.objects.size(), 2u);
  EXPECT_EQ(file.objects[0].texture, (Points{{1, 1}, {1, 0}, {0, 0}}));
  EXPECT_EQ(file.objects[1].texture, (Points{{0, 0}, {1, 0}, {1, 1}}));
}

TEST(Texture, ThatIsDamagedIsNoneAndTold) {
  const MeshFile file =
      read_bytes(kSquare + "vt 0 0\nvt -nan(ind) 1\nf 1/1 2/2 3/9\nf 1/-8 3/ 4/x\n", "a.obj");
  const Points& got = file.objects.at(0).texture;
  ASSERT_EQ(got.size(), 6u);
  EXPECT_EQ(got[0], glm::vec2(0));
  for (std::size_t i = 1; i < 6; ++i) EXPECT_TRUE(std::isnan(got[i].x)) << i;
  EXPECT_EQ(test::count_of(file.diagnostics, "obj.bad_texture"), 2);
  const Scene scene = test::read_scene(kSquare + "vt 0 0\nf 1/1 2/1 3/1\nf 1 3 4\n", "a.obj");
  EXPECT_EQ(test::count_of(scene.diagnostics, "mesh.partly_textured"), 1);
  const auto s = surface(scene);
  EXPECT_TRUE(s->parameters({.position = {3, 0.5, 0}}));
  EXPECT_FALSE(s->parameters({.position = {1, 1.5, 0}}));
}

TEST(Texture, ThatOneObjectHasIsNotMissedByOthers) {
  const Scene scene = test::read_scene(
      "o a\n" + kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\no b\nf 1 3 4\n", "a.obj");
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(test::count_of(scene.diagnostics, "mesh.partly_textured"), 0);
}

TEST(Texture, OfPlyIsThatOfVerticesOrOfCorners) {
  const std::string vertices =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
      "property float {}\nproperty float y\nproperty float {}\n"
      "property float z\nelement face 1\n"
      "property list uchar int vertex_indices\n{}end_header\n"
      "0 0.5 0 0.25 0\n1 0.75 0 0.125 0\n1 1 1 0 0\n{}\n";
  const std::string corners = "property list uchar float texcoord\n";
  for (const auto& [u, v] : {std::pair("s", "t"), {"u", "v"}, {"texture_u", "texture_v"}}) {
    EXPECT_EQ(texture(fmt::format(fmt::runtime(vertices), u, v, "", "3 0 1 2"), "a.ply"),
              (Points{{0.5, 0.25}, {0.75, 0.125}, {1, 0}}));
  }
  EXPECT_TRUE(
      texture(fmt::format(fmt::runtime(vertices), "s", "b", "", "3 0 1 2"), "a.ply").empty());
  EXPECT_EQ(texture(fmt::format(fmt::runtime(vertices), "a", "b", corners, "3 2 1 0 6 0 1 2 3 4 5"),
                    "a.ply"),
            (Points{{0, 1}, {2, 3}, {4, 5}}));
}

TEST(Texture, OfOffIsTheEndOfTheLine) {
  EXPECT_EQ(texture("STCOFF\n3 1 3\n0 0 0 1 0 0 0.5 0.25\n1 0 0 1 0 0 1 0 # red\n1 1 0 9 9 9 0 1\n"
                    "3 0 1 2\n",
                    "a.off"),
            (Points{{0.5, 0.25}, {1, 0}, {0, 1}}));
  EXPECT_TRUE(
      texture("COFF\n3 1 3\n0 0 0 1 0 0\n1 0 0 1 0 0\n1 1 0 9 9 9\n3 0 1 2\n", "a.off").empty());
}

std::string threemf_model(const std::string& triangles, const std::string& object = "") {
  return "<model xmlns:m=\"m\"><resources><m:texture2dgroup id=\"5\" texid=\"6\">"
         "<m:tex2coord u=\"0\" v=\"1\"/><m:tex2coord u=\"0.5\" v=\"0.25\"/>"
         "<m:tex2coord u=\"1\" v=\"0\"/></m:texture2dgroup><basematerials id=\"7\"/>"
         "<object id=\"1\"" +
         object +
         "><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
         "<vertex x=\"1\" y=\"1\" z=\"0\"/></vertices><triangles>" +
         triangles + "</triangles></mesh></object></resources><build><item objectid=\"1\" " +
         "transform=\"1 0 0 0 -1 0 0 0 1 0 0 0\"/></build></model>";
}

std::string threemf(const std::string& triangles, const std::string& object = "") {
  return test::zipped({{"3D/here.model", threemf_model(triangles, object)}});
}

TEST(Texture, OfThreeMfIsThatOfItsGroup) {
  const std::string corners = "<triangle v1=\"0\" v2=\"1\" v3=\"2\"";
  // As it is written; the item turns it over.
  EXPECT_EQ(texture(threemf(corners + " pid=\"5\" p1=\"0\" p2=\"1\" p3=\"2\"/>"), "a.3mf"),
            (Points{{0, 1}, {0.5, 0.25}, {1, 0}}));
  EXPECT_EQ(texture(threemf(corners + " pid=\"5\" p1=\"1\"/>"), "a.3mf"), (Points(3, {0.5, 0.25})));
  EXPECT_EQ(texture(threemf(corners + "/>", " pid=\"5\" pindex=\"2\""), "a.3mf"),
            (Points(3, {1, 0})));
  EXPECT_TRUE(texture(threemf(corners + " pid=\"7\" p1=\"0\"/>"), "a.3mf").empty());
  EXPECT_TRUE(texture(threemf(corners + " pid=\"5\" p1=\"9\"/>"), "a.3mf").empty());
  // Texture that cannot be read is none; the model is drawn.
  std::string bad = threemf_model(corners + " pid=\"5\" p1=\"1\"/>");
  bad.replace(bad.find("u=\"0.5\""), 7, "u=\"wide\"");
  EXPECT_TRUE(texture(test::zipped({{"3D/here.model", bad}}), "a.3mf").empty());
}

// A tube of 24 sides with u around and v up, some of its polygons quads.
std::string tube() {
  std::string text;
  constexpr int kSides = 24;
  for (int i = 0; i < kSides; ++i) {
    const double a = 2 * M_PI * i / kSides;
    for (const int z : {0, 30}) {
      text += fmt::format("v {} {} {}\n", 10 * std::cos(a), 10 * std::sin(a), z);
    }
  }
  for (int i = 0; i <= kSides; ++i) {
    for (const int v : {0, 1}) text += fmt::format("vt {} {}\n", double(i) / kSides, v);
  }
  for (int i = 0; i < kSides; ++i) {
    const int a = 2 * i + 1, b = 2 * ((i + 1) % kSides) + 1, t = 2 * i + 1;
    text += fmt::format("f {}/{} {}/{} {}/{} {}/{}\n", a, t, b, t + 2, b + 1, t + 3, a + 1, t + 1);
  }
  return text;
}

TEST(Texture, IsFoundAgainOnTheSurfaceHoweverItsFacetsAreDrawn) {
  const Scene scene = test::read_scene(tube(), "a.obj");
  const auto& form = dynamic_cast<const MeshForm&>(*scene.parts.at(0).form);
  RunContext context;
  const RecognisedForm healed(form.mesh(), context, form.texture());
  EXPECT_EQ(healed.faces().cylinders, 1);
  const RealiseOptions fine{.tolerance = 0.001};
  for (const auto& s : {form.realise(fine, context), healed.realise(fine, context)}) {
    int asked = 0;
    for (const SurfacePoint& p : s->cover({.count = 500}, context)) {
      const auto uv = s->parameters(p);
      ASSERT_TRUE(uv);
      ++asked;
      const double turn = std::atan2(p.position.y, p.position.x) / (2 * M_PI);
      EXPECT_NEAR(uv->x, turn - std::floor(turn), 5e-4);  // of a chord, not its arc
      EXPECT_NEAR(uv->y, p.position.z / 30, 1e-6);
    }
    EXPECT_EQ(asked, 500);
  }
}

TEST(Texture, OfPolygonsWithCornersInsideIsThatOfTheirInside) {
  // An L whose corner is cut away: u, v are x, y.
  const Scene scene = test::read_scene(
      "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 1 1 0\nv 1 4 0\nv 0 4 0\nvt 0 0\nvt 4 0\nvt 4 1\nvt 1 1\n"
      "vt 1 4\nvt 0 4\nf 1/1 2/2 3/3 4/4 5/5 6/6\n",
      "a.obj");
  const auto s = surface(scene);
  for (const Vec2 p : {Vec2(3.5, 0.5), Vec2(0.5, 3.5), Vec2(0.5, 0.5), Vec2(1.01, 0.9)}) {
    const auto uv = s->parameters({.position = Vec3(p, 0)});
    ASSERT_TRUE(uv);
    EXPECT_NEAR(uv->x, p.x, 1e-6);
    EXPECT_NEAR(uv->y, p.y, 1e-6);
  }
}

}  // namespace
}  // namespace burin
