#include <burin/converters/mesh_info.h>

#include "reading.h"

#include <nlohmann/json.hpp>

namespace burin {
namespace {

FileInfo inspect(const std::string& bytes, const std::string& name) {
  const test::TempFile file(name, bytes);
  RunContext context;
  return inspect_mesh(file.path(), context);
}

TEST(Info, MeasuresABox) {
  const FileInfo info = inspect(test::stl_binary(test::box({1, 2, 3}, {3, 5, 7})), "a.stl");
  EXPECT_EQ(info.format, "STL (binary)");
  ASSERT_EQ(info.parts.size(), 1u);
  const PartInfo& p = info.parts[0];
  EXPECT_EQ(p.triangles, 12);
  EXPECT_EQ(p.vertices, 8);
  EXPECT_EQ(p.faces, 6);
  EXPECT_EQ(p.components, 1);
  EXPECT_TRUE(p.closed());
  EXPECT_EQ(p.self_intersections, 0);
  EXPECT_DOUBLE_EQ(p.volume, 24);
  EXPECT_DOUBLE_EQ(p.area, 52);
  EXPECT_EQ(p.bounds.min, Vec3(1, 2, 3));
  EXPECT_EQ(p.bounds.max, Vec3(3, 5, 7));
  EXPECT_TRUE(info.diagnostics.empty());
}

TEST(Info, APartAloneIsNamedWhereItIsNotCalledAsItsFile) {
  const std::string bytes = test::obj(test::box({-1, -1, -1}, {0, 0, -0.0}));
  EXPECT_EQ(to_text(inspect(bytes, "a.obj")).find("part 0"), std::string::npos);
  const std::string text = to_text(inspect("o lid\n" + bytes, "a.obj"));
  EXPECT_NE(text.find("part 0      lid: 12 triangles, 6 faces"), std::string::npos) << text;
  EXPECT_NE(text.find("to (0, 0, 0)"), std::string::npos) << text;
}

TEST(Info, InstancesShareAShape) {
  std::string model = test::zipped(
      {{"3D/3dmodel.model",
        "<model unit=\"millimeter\"><resources><basematerials id=\"9\"><base "
        "displaycolor=\"#ff000080\"/></basematerials><object id=\"1\" name=\"wedge\" pid=\"9\" "
        "pindex=\"0\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" "
        "z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices>"
        "<triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
        "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles>"
        "</mesh></object></resources><build><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 7 0 "
        "0\"/><item objectid=\"1\" transform=\"0 2 0 -2 0 0 0 0 2 9 0 0\"/></build></model>"}});
  const FileInfo info = inspect(model, "a.3mf");
  ASSERT_EQ(info.parts.size(), 2u);
  const PartInfo &one = info.parts[0], &two = info.parts[1];
  EXPECT_EQ(one.triangles, 4);
  EXPECT_EQ(one.vertices, 4);
  EXPECT_EQ(one.faces, 4);
  EXPECT_EQ(one.same_shape_as, -1);
  EXPECT_EQ(two.same_shape_as, 0);
  EXPECT_NEAR(one.volume, 1.0 / 6, 1e-12);
  EXPECT_NEAR(two.volume, 8.0 / 6, 1e-12);
  EXPECT_NEAR(two.area, 4 * one.area, 1e-12);
  EXPECT_NEAR(one.bounds.min.x, 7, 1e-12);
  EXPECT_NEAR(two.bounds.min.x, 7, 1e-12);
  EXPECT_NEAR(two.bounds.max.z, 2, 1e-12);
  EXPECT_EQ(two.color, "#ff0000");
  EXPECT_NEAR(two.opacity, 128 / 255.0, 1e-12);
  const auto json = nlohmann::json::parse(to_json({&info, 1}));
  EXPECT_NEAR(json["files"][0]["parts"][1]["opacity"].get<double>(), 128 / 255.0, 1e-12);
  EXPECT_NE(to_text(info).find("#ff0000, opacity 0.502"), std::string::npos) << to_text(info);
}

TEST(Info, CountsCrossingTriangles) {
  // A blade through one side of a box, of two triangles that each cross two of it.
  TriMesh m = test::box({0, 0, 0}, {4, 4, 4});
  const auto n = static_cast<std::uint32_t>(m.positions.size());
  m.positions.insert(m.positions.end(), {{1, 1, 3}, {2, 1, 3}, {1.5, 1, 5}});
  m.triangles.push_back({n, n + 1, n + 2});
  const FileInfo info = inspect(test::obj(m), "a.obj");
  EXPECT_EQ(info.parts.at(0).self_intersections, 1);
  EXPECT_EQ(info.parts[0].components, 2);
  EXPECT_EQ(info.parts[0].boundary_edges, 3);
  EXPECT_FALSE(info.parts[0].closed());
  EXPECT_EQ(test::count_of(info.diagnostics, "mesh.self_intersections"), 1);
  EXPECT_EQ(test::count_of(info.diagnostics, "mesh.open"), 3);
}

TEST(Info, FoldedNeighboursOverlap) {
  const FileInfo fold = inspect("v 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 2 0\nf 1 2 3\nf 2 1 4\n", "a.obj");
  EXPECT_EQ(fold.parts.at(0).self_intersections, 1);
  const FileInfo flat = inspect("v 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 -2 0\nf 1 2 3\nf 2 1 4\n", "a.obj");
  EXPECT_EQ(flat.parts.at(0).self_intersections, 0);
}

TEST(Info, DistantAndTinyModelsMeasureTheSame) {
  for (const double scale : {1e-3, 1.0, 1e4}) {
    const TriMesh m = test::mapped(test::ellipsoid({3, 2, 1}, 40, 20),
                                   [&](Vec3 p) { return scale * p + Vec3(1e5); });
    const FileInfo info = inspect(test::obj(m), "a.obj");
    const double expected = test::numbers(test::ellipsoid({3, 2, 1}, 40, 20)).volume;
    EXPECT_NEAR(info.parts.at(0).volume / std::pow(scale, 3) / expected, 1, 1e-6);
    EXPECT_EQ(info.parts[0].self_intersections, 0);
  }
}

TEST(Info, TextNamesWhatWasFoundAndDone) {
  TriMesh m = test::box({0, 0, 0}, {1, 1, 1});
  std::swap(m.triangles[3][0], m.triangles[3][1]);
  const std::string text = to_text(inspect(test::obj(m), "cube.obj"));
  for (const char* part :
       {"cube.obj: OBJ\n", "triangles   12\n", "faces       6 ", "surface     closed",
        "1 x 1 x 1 mm", "mesh.flipped_faces: triangles were turned over"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST(Info, JsonHoldsAllOfIt) {
  const std::string two =
      "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 4 5 6\n";
  const std::vector<FileInfo> files = {inspect(two, "two.obj"),
                                       inspect(test::off(test::torus(5, 2, 20, 10)), "t.off")};
  const nlohmann::json json = nlohmann::json::parse(to_json(files));
  EXPECT_EQ(json["format"], "burin-info");
  EXPECT_EQ(json["version"], 1);
  ASSERT_EQ(json["files"].size(), 2u);
  const auto& f = json["files"][0];
  EXPECT_EQ(f["format"], "OBJ");
  EXPECT_EQ(f["triangles"], 2);
  EXPECT_EQ(f["closed"], false);
  EXPECT_EQ(f["boundary_edges"], 6);
  EXPECT_EQ(f["bounds"]["max"], nlohmann::json({6.0, 1.0, 0.0}));
  EXPECT_EQ(f["parts"][1]["name"], "b");
  EXPECT_EQ(f["parts"][1]["triangles"], 1);
  EXPECT_EQ(f["diagnostics"][0]["code"], "mesh.open");
  EXPECT_EQ(json["files"][1]["closed"], true);
}

}  // namespace
}  // namespace burin
