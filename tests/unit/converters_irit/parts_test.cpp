// From objects to parts: what welds, names, colours, what is left out.
#include <burin/forms/mesh/mesh_form.h>

#include "reading.h"

#include <algorithm>

namespace burin {
namespace {

using test::square;

std::string part_object(const std::string& name, const std::string& inside) {
  return "[OBJECT " + name + "\n" + inside + "]\n";
}

/// "file" where a part has the name of its file.
std::vector<std::string> names(const Scene& scene) {
  std::vector<std::string> all;
  for (const Part& p : scene.parts) {
    all.push_back(p.name == std::filesystem::path(p.source).stem() ? "file" : p.name);
  }
  return all;
}

TEST(IritParts, NamedObjectsApartAreParts) {
  const Scene scene = test::scene_of(part_object("A", square({0, 0, 0}) + square({1, 0, 0})) +
                                     part_object("B", square({9, 0, 0})));
  EXPECT_EQ(names(scene), (std::vector<std::string>{"A", "B"}));
  EXPECT_EQ(test::patches_of(scene.parts[0]).size(), 2u);
  EXPECT_TRUE(scene.diagnostics.empty());
}

TEST(IritParts, ObjectsWithoutNamesAreOnePart) {
  const Scene scene =
      test::scene_of(part_object("NONE", square({0, 0, 0})) + part_object("B", square({5, 0, 0})) +
                     part_object("NONE", square({9, 0, 0})));
  EXPECT_EQ(names(scene), (std::vector<std::string>{"file", "B"}));
  EXPECT_EQ(test::patches_of(scene.parts[0]).size(), 2u);
}

TEST(IritParts, SidesThatFitMakeOnePart) {
  // A2 lies beside A1, with six digits; C touches A1 at a corner alone.
  const std::string list = part_object("A1", square({0, 0, 0})) +
                           part_object("A2", square({1 + 1e-6, 0, 0})) +
                           part_object("C", square({-1, -1, 0}));
  const Scene scene = test::scene_of(part_object("VASE", list));
  EXPECT_EQ(names(scene), (std::vector<std::string>{"A1", "C"}));
  EXPECT_EQ(test::patches_of(scene.parts[0]).size(), 2u);
  EXPECT_EQ(scene.parts[0].assembly, std::vector<std::string>{"VASE"});
  const Scene whole = test::scene_of(part_object(
      "VASE", part_object("A1", square({0, 0, 0})) + part_object("A2", square({0, 1, 0}))));
  EXPECT_EQ(names(whole), std::vector<std::string>{"VASE"});
  EXPECT_TRUE(whole.parts[0].assembly.empty());
}

TEST(IritParts, AStripIsTheTrianglesOfItsPoints) {
  // Round a tetrahedron: its four faces, which close.
  const Scene scene = test::scene_of(part_object(
      "TET", "[POLYSTRIP 6 [0 0 0] [1 0 0] [0 1 0] [0 0 1] [[NORMAL 1 0 0] 0 0 0] [1 0 0]]\n"));
  ASSERT_EQ(names(scene), std::vector<std::string>{"TET"});
  RunContext context;
  const auto surface = scene.parts[0].form->realise({}, context);
  EXPECT_EQ(surface->proxy().mesh.triangles.size(), 4u);
  EXPECT_EQ(surface->proxy().topology.component_closed.size(), 1u);
  EXPECT_TRUE(surface->proxy().topology.component_closed[0]);
}

TEST(IritParts, Colours) {
  const Scene scene = test::scene_of(
      part_object("[COLOR 4] A", square({0, 0, 0})) +
      part_object("[RGB \"1,16,255\"] [COLOR 4] B", square({3, 0, 0})) +
      part_object("[COLOR 14] L", part_object("C", square({6, 0, 0}))) +
      part_object("D", square({9, 0, 0})) + part_object("[COLOR 99] E", square({12, 0, 0})));
  ASSERT_EQ(scene.parts.size(), 5u);
  EXPECT_EQ(scene.parts[0].color, "#aa0000");
  EXPECT_EQ(scene.parts[1].color, "#0110ff");
  EXPECT_EQ(scene.parts[2].color, "#ffff55");
  EXPECT_EQ(scene.parts[3].color, "");
  EXPECT_EQ(scene.parts[4].color, "");
}

TEST(IritParts, PolygonsBecomeMeshes) {
  const Scene scene = test::scene_of(
      part_object("TETRA",
                  "[POLYGON 3 [0 0 0] [0 1 0] [1 0 0]] [POLYGON 3 [0 0 0] [1 0 0] [0 0 1]]\n"
                  "[POLYGON 3 [0 0 0] [0 0 1] [0 1 0]] [POLYGON 3 [1 0 0] [0 1 0] [0 0 1]]\n"));
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "TETRA");
  const TriMesh& mesh = dynamic_cast<const MeshForm&>(*scene.parts[0].form).mesh();
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 4u);
}

TEST(IritParts, WhatIsLeftOutIsTold) {
  const Scene scene =
      test::scene_of(part_object("A", square({0, 0, 0})) +
                     part_object("T", "[TRISRF " + square({0, 0, 0}) + "[TRIMCRV]]") +
                     part_object("U", "[TRISRF " + square({0, 0, 0}) + "]") +
                     part_object("C", "[CURVE BEZIER 2 E3 [0 0 0] [1 0 0]]") +
                     part_object("P", "[POLYGON 2 [0 0 0] [1 0 0]]") +
                     part_object("[INVISIBLE 1] I", square({0, 0, 9})));
  EXPECT_EQ(names(scene), std::vector<std::string>{"A"});
  const auto& reported = scene.diagnostics.entries();
  ASSERT_EQ(reported.size(), 4u);
  const auto find = [&](const std::string& code) {
    return *std::ranges::find(reported, code, &Diagnostic::code);
  };
  EXPECT_EQ(find("irit.unread").count, 2);
  EXPECT_EQ(find("irit.unread").severity, Severity::Warning);
  EXPECT_NE(find("irit.unread").message.find("TRISRF (triangular patch)"), std::string::npos);
  EXPECT_NE(find("irit.unread").message.find("line 5"), std::string::npos);
  EXPECT_EQ(find("irit.no_surface").count, 1);
  EXPECT_EQ(find("irit.no_surface").severity, Severity::Warning);
  EXPECT_TRUE(std::ranges::any_of(reported, [](const Diagnostic& d) {
    return d.message.starts_with("POLYGON of fewer than three corners is no surface");
  }));
  EXPECT_EQ(find("irit.invisible").count, 1);
}

}  // namespace
}  // namespace burin
