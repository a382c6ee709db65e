#include <burin/base/parallel.h>
#include <burin/base/version.h>
#include <burin/drawing/writers.h>

#include <burin_test/drawings.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <sstream>

namespace burin {
namespace {

using nlohmann::json;

std::string json_text(const Drawing& drawing, const JsonOptions& options = {}) {
  std::ostringstream out;
  write_json(drawing, options, out, RunContext());
  return out.str();
}

TEST(JsonWriter, HeadHasEveryFieldOfTheContract) {
  const json j = json::parse(json_text(test::sample_drawing()));
  EXPECT_EQ(j.at("format"), "burin-drawing");
  EXPECT_EQ(j.at("version"), 1);
  EXPECT_EQ(j.at("generator"), std::string("burin ") + version());
  EXPECT_EQ(j.at("seed"), 42);
  EXPECT_EQ(j.at("style"), "engraving");
  EXPECT_EQ(j.at("paper"), json::parse(R"({"width": 200.0, "height": 150.0, "unit": "mm"})"));
  const json& view = j.at("view");
  EXPECT_EQ(view.at("projection"), "orthographic");
  EXPECT_EQ(view.at("direction"), json::parse("[0,0,1]"));
  EXPECT_EQ(view.at("right"), json::parse("[1,0,0]"));
  EXPECT_EQ(view.at("up"), json::parse("[0,1,0]"));
  EXPECT_EQ(view.at("scale"), 2.0);
  EXPECT_EQ(view.at("center"), json::parse("[1,2,3]"));
  EXPECT_EQ(view.at("offset"), json::parse("[100,75]"));
  EXPECT_FALSE(view.contains("eye"));
  EXPECT_EQ(j.at("parts")[0], json::parse(R"json({"id": 0, "name": "bracket <A&B>",
      "source": "dir/br\"acket.stl", "triangles": 1234, "faces": 4})json"));
  EXPECT_EQ(j.at("parts")[1].at("source"), "second.obj");
  EXPECT_EQ(j.at("diagnostics"), json::parse(R"json([{"severity": "warning",
      "code": "mesh.nonmanifold_edges", "count": 3, "message": "3 edges \"mended\""}])json"));
  EXPECT_EQ(j.at("stats"), json::parse(R"({"triangles": 1246, "strokes": 12,
      "coverage_points": 1000, "coverage_delta": 0.8})"));
}

TEST(JsonWriter, PartsOfAssembliesSayWhereTheyBelong) {
  Drawing drawing = test::sample_drawing();
  drawing.parts[1].assembly = {"pump", "rotor \"left\""};
  drawing.parts[1].color = "#ff8040";
  const json j = json::parse(json_text(drawing));
  EXPECT_FALSE(j.at("parts")[0].contains("assembly"));
  EXPECT_FALSE(j.at("parts")[0].contains("color"));
  EXPECT_EQ(j.at("parts")[1].at("assembly"), json::parse(R"(["pump", "rotor \"left\""])"));
  EXPECT_EQ(j.at("parts")[1].at("color"), "#ff8040");
}

TEST(JsonWriter, PathsHaveEveryFieldOfTheContract) {
  const Drawing drawing = test::sample_drawing();
  const json j = json::parse(json_text(drawing));
  ASSERT_EQ(j.at("layers").size(), 3u);
  for (std::size_t l = 0; l < 3; ++l) {
    const Layer& layer = drawing.layers[l];
    const json& written = j.at("layers")[l];
    EXPECT_EQ(written.at("name"), layer.name);
    ASSERT_EQ(written.at("paths").size(), layer.paths.size());
    for (std::size_t i = 0; i < layer.paths.size(); ++i) {
      const Path& p = layer.paths[i];
      const json& w = written.at("paths")[i];
      EXPECT_EQ(w.at("kind"), to_string(p.kind));
      EXPECT_EQ(w.at("visible"), p.visible);
      EXPECT_EQ(w.at("part"), p.source.part);
      EXPECT_EQ(w.at("face"), p.source.face);
      EXPECT_EQ(w.at("edge"), p.source.edge);
      EXPECT_EQ(w.at("closed"), p.closed);
      EXPECT_EQ(w.contains("field"), p.kind == LineClass::Stroke);
      if (p.kind == LineClass::Stroke) {
        EXPECT_EQ(w.at("field"), "smoothed");
        EXPECT_EQ(w.at("family"), 1);
      }
      ASSERT_EQ(w.at("points").size(), p.points.size());
      ASSERT_EQ(w.at("points3").size(), p.points.size());
      ASSERT_EQ(w.at("width").size(), p.width.size());
      for (std::size_t k = 0; k < p.points.size(); ++k) {
        EXPECT_NEAR(w.at("points")[k][0].get<double>(), p.points[k].x, 0.51e-4);
        EXPECT_NEAR(w.at("points")[k][1].get<double>(), p.points[k].y, 0.51e-4);
        for (int c = 0; c < 3; ++c) {
          EXPECT_NEAR(w.at("points3")[k][c].get<double>(), p.points3[k][c], 1e-6);
        }
      }
      for (std::size_t k = 0; k < p.width.size(); ++k) {
        EXPECT_NEAR(w.at("width")[k].get<double>(), p.width[k], 0.51e-4);
      }
    }
  }
}

TEST(JsonWriter, FacesAreNamedWhereAPathRunsOverSeveral) {
  Drawing drawing = test::sample_drawing();
  EXPECT_EQ(json_text(drawing).find("\"faces\": [["), std::string::npos);
  drawing.layers[0].paths[0].faces = {{0, 12}, {1, 7}};
  const json j = json::parse(json_text(drawing));
  EXPECT_EQ(j.at("layers")[0].at("paths")[0].at("faces"), json::parse("[[0,12],[1,7]]"));
}

TEST(JsonWriter, PerspectiveTellsEyeAndField) {
  Drawing d = test::sample_drawing();
  d.view.projection = "perspective";
  d.view.eye = {0.5, -100.25, 1e-7};
  d.view.field_of_view = 35;
  const json view = json::parse(json_text(d)).at("view");
  EXPECT_EQ(view.at("eye"), json::parse("[0.5, -100.25, 1e-7]"));
  EXPECT_EQ(view.at("field_of_view"), 35);
}

TEST(JsonWriter, ModelCoordinatesFollowTheScaleOfTheDrawing) {
  // The same part a thousand times smaller and far from the origin keeps a millionth of a paper mm.
  Drawing d = test::sample_drawing();
  d.view.scale = 2000;
  d.layers.resize(1);
  d.layers[0].paths.resize(1);
  for (Vec3& p : d.layers[0].paths[0].points3) p = p * 1e-3 + Vec3(100, 0, 0);
  const json j = json::parse(json_text(d));
  const json& written = j["layers"][0]["paths"][0]["points3"];
  for (std::size_t k = 0; k < written.size(); ++k) {
    const double x = d.layers[0].paths[0].points3[k].x;
    EXPECT_NEAR(written[k][0].get<double>() * 2000, x * 2000, 1.1e-6);
  }
  // And a huge one is written in full where no decimals are left.
  d.view.scale = 1e-4;
  d.layers[0].paths[0].points3[0] = {1.5e20, -3e18, 12345678.9};
  const json huge = json::parse(json_text(d))["layers"][0]["paths"][0]["points3"][0];
  EXPECT_EQ(huge[0], 1.5e20);
  EXPECT_EQ(huge[1], -3e18);
  EXPECT_NEAR(huge[2].get<double>(), 12345678.9, 0.05);
}

TEST(JsonWriter, Points3MayBeLeftOut) {
  const json j = json::parse(json_text(test::sample_drawing(), {.points3 = false}));
  EXPECT_FALSE(j["layers"][0]["paths"][0].contains("points3"));
  EXPECT_EQ(j["layers"][0]["paths"][0]["points"].size(), 200u);
}

TEST(JsonWriter, NumbersAreFiniteAndNamesAreText) {
  Drawing d = test::sample_drawing();
  d.layers[0].paths[0].points3[5].z = std::numeric_limits<double>::infinity();
  d.layers[0].paths[1].width[0] = std::numeric_limits<double>::quiet_NaN();
  d.layers[0].paths[2].points[0] = {-1e-9, 4.00005};
  d.parts[0].name = "caf\xe9 \xc3\xa9\n\t\\";
  const std::string text = json_text(d);
  const json j = json::parse(text);
  EXPECT_EQ(j["layers"][0]["paths"].size(), 10u);
  EXPECT_EQ(j["parts"][0]["name"], "caf\xef\xbf\xbd \xc3\xa9\n\t\\");
  EXPECT_EQ(j["diagnostics"].back()["code"], "drawing.not_finite");
  EXPECT_EQ(j["diagnostics"].back()["count"], 2);
  EXPECT_NE(text.find("\"points\": [[0,4.0001]"), std::string::npos);
}

TEST(JsonWriter, SameBytesForAnyNumberOfThreads) {
  Drawing d = test::sample_drawing();
  for (int i = 0; i < 300; ++i)
    d.layers[0].paths.push_back(test::wavy_stroke({10, 0.3 * i}, 80, 1));
  const std::string all = json_text(d);
  const ThreadLimit one(1);
  EXPECT_EQ(all, json_text(d));
  EXPECT_EQ(json::parse(all)["layers"][0]["paths"].size(), 312u);
}

TEST(JsonWriter, EmptyDrawing) {
  const json j = json::parse(json_text(Drawing()));
  EXPECT_TRUE(j.at("layers").empty());
  EXPECT_TRUE(j.at("parts").empty());
  EXPECT_TRUE(j.at("diagnostics").empty());
}

}  // namespace
}  // namespace burin
