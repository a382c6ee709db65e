// Drawing files: our own byte for byte, those of others, broken ones in one line each.
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include "writing.h"

#include <burin_test/mutated.h>
#include <burin_test/shapes.h>

#include <cmath>
#include <limits>
#include <memory>

namespace burin {
namespace {

using test::least;
using test::parsed;
using test::refusal;
using test::written;

Drawing full_drawing() {
  Drawing d = test::sample_drawing();
  d.parts[1].assembly = {"pump", "rotor \"left\" \xC3\xA4"};
  d.parts[1].color = "#ff8040";
  d.layers[2].paths[0].faces = {{0, 12}, {7, -1}, {90, 3}};
  d.layers[1].paths[0].in_full = true;
  d.view.projection = "perspective";
  d.view.eye = {1.5, -1e-3, 7e9};
  d.view.field_of_view = 33.3;
  d.seed = std::numeric_limits<std::uint64_t>::max();
  d.layers.push_back({"empty", {}});
  Path none;
  none.points = {{1, 2}};
  d.layers.push_back({"odd \n\t\"\\", {none}});
  d.stats.tone_gamma = 0.75;
  d.stats.verify.emplace();
  d.stats.verify->spans = 12;
  d.stats.verify->length = 345.6;
  d.stats.verify->contradicted = 1.25;
  d.stats.verify->count = 1;
  d.stats.verify->contradictions.push_back({.what = "covered",
                                            .kind = LineClass::Crease,
                                            .source = {1, 2, 3},
                                            .length = 1.25,
                                            .at = {10.5, 20.25},
                                            .model = {1, -2, 3e-7}});
  d.stats.verify->area = 123.25;
  d.stats.verify->wrong_area = 0.75;
  d.stats.verify->wrong_patches = 1;
  d.stats.verify->contradictions.push_back({.what = "wrong_tone",
                                            .source = {1, 4, -1},
                                            .size = 0.75,
                                            .at = {11, 21.5},
                                            .model = {1, 2, 3}});
  const double third = 1.0 / 3;
  d.areas = {{.part = 0, .rings = {{{third, 0}, {10, third}, {10, 2 * third}}}},
             {.part = 1,
              .face = 7,
              .tone = 2,
              .fill = "#12ab34",
              .opacity = third,
              .rings = {{{0, 0}, {20.00004, 0}, {20, 1e-4}, {-5e-5, 9}},
                        {{1, 1}, {1, 2}, {2 * third, 1}}}}};
  return d;
}

TEST(ReadDrawing, GivesBackTheBytesThatWereWritten) {
  for (const Drawing& d : {test::sample_drawing(), full_drawing(), Drawing()}) {
    const std::string text = written(d, "json");
    EXPECT_EQ(written(parsed(text), "json"), text);
    WriteOptions flat;
    put(flat.formats, JsonOptions{.points3 = false});
    const std::string shorter = written(d, "json", flat);
    EXPECT_EQ(written(parsed(shorter), "json"), shorter);
  }
}

TEST(ReadDrawing, KeepsEveryField) {
  const Drawing a = full_drawing(), b = parsed(written(a, "json"));
  EXPECT_EQ(b.paper_width, 200);
  EXPECT_EQ(b.seed, a.seed);
  EXPECT_EQ(b.view.eye, a.view.eye);
  EXPECT_EQ(b.parts[1].assembly, a.parts[1].assembly);
  ASSERT_EQ(b.layers.size(), a.layers.size());
  const Path& p = b.layers[2].paths[0];
  EXPECT_EQ(p.kind, LineClass::Contour);
  EXPECT_EQ(p.source, (SourceId{1, 12, -1}));
  EXPECT_TRUE(p.closed);
  ASSERT_EQ(p.faces.size(), 3u);
  EXPECT_EQ(p.faces[2].first_point, 90u);
  EXPECT_FALSE(b.layers[1].paths[0].visible);
  EXPECT_TRUE(b.layers[1].paths[0].in_full);
  EXPECT_EQ(b.layers[0].paths[3].field, "smoothed");
  EXPECT_EQ(b.layers[0].paths[3].points.size(), 200u);
  EXPECT_EQ(b.diagnostics.entries()[0].count, 3);
  EXPECT_EQ(b.stats.coverage_delta, 0.8);
  EXPECT_EQ(b.stats.tone_gamma, 0.75);
}

// Places of areas and of lines are rounded alike, so that a border which lies on a line stays
// there.
TEST(ReadDrawing, AreasKeepToTheirLines) {
  Drawing a = full_drawing();
  Path line;
  line.points = a.areas[1].rings[0];
  line.width = {0.25};
  a.layers.push_back({"borders", {line}});
  const Drawing b = parsed(written(a, "json"));
  ASSERT_EQ(b.areas.size(), 2u);
  EXPECT_EQ(b.layers.back().paths[0].points, b.areas[1].rings[0]);
  ASSERT_EQ(b.areas[1].rings.size(), 2u);
  EXPECT_EQ(b.areas[1].face, 7);
  EXPECT_EQ(b.areas[1].tone, 2);
  EXPECT_EQ(b.areas[1].fill, "#12ab34");
  EXPECT_EQ(b.areas[1].opacity, 1.0 / 3);
  EXPECT_EQ(b.stats.verify->wrong_area, 0.75);
  EXPECT_EQ(b.stats.verify->contradictions[1].size, 0.75);
  EXPECT_EQ(written(b, "svg"), written(parsed(written(b, "json")), "svg"));
}

TEST(ReadDrawing, OtherProgramsMayLeaveOutAndAdd) {
  const Drawing d = parsed(least());
  ASSERT_EQ(d.layers.size(), 1u);
  const Path& p = d.layers[0].paths.at(0);
  EXPECT_EQ(p.points, (std::vector<Vec2>{{0, 0}, {100, 50}}));
  EXPECT_EQ(p.width, (std::vector<double>{0.25}));
  EXPECT_EQ(p.source, SourceId());
  EXPECT_TRUE(p.visible);
  const Drawing other = parsed(R"({"layers": [
    {"shade": "red", "paths": [{"points": [[1, 2], [3, 4], [5, 6]], "width": 0.5, "tags": {"paths": [{}]},
       "part": null, "kind": "crease"}], "name": "late"}, {}],
    "extra": [[{"paths": [{}]}]], "paper": {"height": 1.5, "width": 2e1, "color": "white"},
    "version": 1, "format": "burin-drawing"})");
  ASSERT_EQ(other.layers.size(), 2u);
  EXPECT_EQ(other.layers[0].name, "late");
  EXPECT_EQ(other.layers[0].paths.at(0).width, (std::vector<double>{0.5}));
  EXPECT_EQ(other.layers[0].paths[0].kind, LineClass::Crease);
  EXPECT_EQ(other.paper_width, 20);
}

TEST(ReadDrawing, SaysWhatIsWrongWhere) {
  const auto path = [](const std::string& text) { return refusal(least(text)); };
  EXPECT_EQ(refusal("{}"), "a.json: is no drawing file: \"format\": \"burin-drawing\" is missing");
  EXPECT_EQ(refusal("[1]"), refusal("{}"));
  EXPECT_EQ(refusal(R"({"version": 2, "layers": 7, "format": "burin-drawing"})"),
            "a.json: version: is 2; this program reads version 1, a newer one may read it");
  EXPECT_EQ(refusal(R"({"format": "burin-drawing", "version": 1, "paper": {"width": 0}})"),
            "a.json: paper.width: takes a side over 0 and up to 10000 mm");
  EXPECT_EQ(refusal(R"({"format": "burin-drawing", "version": 1, "paper": {"width": 1}})"),
            "a.json: paper: lacks \"height\"");
  const auto area = [](const std::string& text) {
    return refusal(R"({"format": "burin-drawing", "version": 1, "paper": {"width": 1, "height": 1},
                       "areas": [)" +
                   text + R"(], "layers": []})");
  };
  EXPECT_EQ(area(R"({"part": 0, "fill": "red"})"), "a.json: areas[0].fill: takes a colour #rrggbb");
  EXPECT_EQ(area(R"({"part": 0, "opacity": 1.5})"),
            "a.json: areas[0].opacity: takes an opacity from 0 to 1");
  EXPECT_EQ(area(R"({"part": 0, "rings": [[[0, 0], [1, 1]]]})"),
            "a.json: areas[0].rings[0]: holds 2 points; a ring has 3");
  EXPECT_EQ(path(R"({"points": [[0, 0], [1, NaN]]})"),
            "a.json:3: NaN and Infinity are no numbers of JSON");
  EXPECT_EQ(path(R"({"points": [[0, 0], [1, -Infinity]]})"),
            "a.json:3: NaN and Infinity are no numbers of JSON");
  EXPECT_EQ(path(R"({"points": [[0, 0], [1, 1e999]]})"),
            "a.json: broken JSON: a number is too large");
  EXPECT_EQ(path(R"({"points": [[0, 0]]}, {"points": [[0, 0], [1, null]]})"),
            "a.json: layers[0].paths[1].points[1][1]: takes a number");
  EXPECT_EQ(path(R"({"points": [[0, 0], [1, 2, 3]]})"),
            "a.json: layers[0].paths[0].points[1]: takes 2 numbers [...]");
  EXPECT_EQ(path(R"({"points": [[0, 2e9]]})"),
            "a.json: layers[0].paths[0].points[0]: is more than 1e9 mm from the sheet");
  EXPECT_EQ(path("{}"), "a.json: layers[0].paths[0]: lacks \"points\"");
  EXPECT_EQ(path("7"), "a.json: layers[0].paths[0]: takes an object {...}");
  EXPECT_EQ(path("[]"), "a.json: layers[0].paths[0]: takes an object {...}");
  EXPECT_EQ(
      path(R"({"points": [[0, 0], [1, 1]], "width": [1, 2, 3]})"),
      "a.json: layers[0].paths[0].width: holds 3 numbers; takes one, or one for each of the 2 "
      "points");
  EXPECT_EQ(path(R"({"points": [], "width": -1})"),
            "a.json: layers[0].paths[0].width: takes a width from 0 to 10000 mm");
  EXPECT_EQ(path(R"({"points": [], "kind": "creese"})"),
            "a.json: layers[0].paths[0].kind: no such kind of line; the nearest is \"crease\"");
  EXPECT_EQ(path(R"({"points": [[0, 0], [1, 1]], "points3": [[0, 0, 0]]})"),
            "a.json: layers[0].paths[0].points3: holds 1 points of 2");
  EXPECT_EQ(path(R"({"points": [], "part": 0.5})"),
            "a.json: layers[0].paths[0].part: takes a whole number from -2147483648 to 2147483647");
  EXPECT_EQ(path(R"({"points": [], "closed": 1})"),
            "a.json: layers[0].paths[0].closed: takes true or false");
  EXPECT_EQ(path(R"({"points": [[0, 0], [1, 1]], "faces": [[0, 1], [2, 1]]})"),
            "a.json: layers[0].paths[0].faces[1]: begins at a wrong point; runs begin at point 0 "
            "and follow each other");
  EXPECT_EQ(refusal(least().substr(0, 110)).substr(0, 22), "a.json:3: broken JSON:");
  EXPECT_EQ(refusal(std::string(100000, '[')), "a.json: is nested deeper than 100");
}

TEST(ReadDrawing, LayersAndPathsMustStandWhereTheyBelong) {
  const std::string head =
      R"({"format": "burin-drawing", "version": 1, "paper": {"width": 9, "height": 9})";
  const std::string path = R"({"points": [[0, 0], [1, 1]]})";
  EXPECT_EQ(refusal(head + "}"), "a.json: the drawing lacks \"layers\"");
  EXPECT_EQ(refusal(head + R"(, "layers": {"a": {"paths": []}}})"),
            "a.json: layers: takes a list [...]");
  EXPECT_EQ(refusal(head + R"(, "layers": [[{"paths": []}]]})"),
            "a.json: layers[0]: takes an object {...}");
  EXPECT_EQ(refusal(head + R"(, "layers": [{"paths": {}}]})"),
            "a.json: layers[0].paths: takes a list [...]");
  // The last of two keys counts, as it does for most readers of JSON.
  const Drawing d = parsed(head + R"(, "layers": [{}, {}, {}], "layers": [{"paths": [)" + path +
                           "," + path + R"(], "paths": [)" + path + "]}]}");
  ASSERT_EQ(d.layers.size(), 1u);
  EXPECT_EQ(d.layers[0].paths.size(), 1u);
}

TEST(ReadDrawing, FilesThatAreNoneAreRefused) {
  EXPECT_THROW(read_drawing("/nowhere/a.json", RunContext()), InputError);
  EXPECT_THROW(read_drawing("/", RunContext()), InputError);
  RunContext cancelled;
  cancelled.cancel();
  EXPECT_THROW(parse_drawing(least(), "a", cancelled), Cancelled);
}

TEST(ReadDrawing, ReadsOrRefusesAnyDamage) {
  constexpr std::string_view kSpice[] = {"-1", "0",     "99999999999", "NaN",         "1e999",
                                         "\n", "[",     "]",           "{",           "}",
                                         ",",  "null",  "true",        "\"",          "\\",
                                         ":",  "1e-99", "\"layers\":", "\"paths\":[", "\xFF"};
  Drawing small = full_drawing();
  small.layers[0].paths.resize(1);
  small.layers[0].paths[0].points.resize(4);
  small.layers[0].paths[0].points3.resize(4);
  small.layers[0].paths[0].width.resize(4);
  small.layers[1].paths.clear();
  small.layers[2].paths.erase(small.layers[2].paths.begin());
  const std::string good = written(small, "json");
  ASSERT_LT(good.size(), 4000u);
  const Rng rng(5);
  std::uint64_t n = 0;
  int read = 0, refused = 0;
  for (int i = 0; i < 5000; ++i) {
    const std::string bytes = test::mutated(good, kSpice, rng, n);
    try {
      const Drawing d = parsed(bytes);
      ++read;
      if (i % 10 == 0) {
        for (const char* f : {"svg", "eps", "dxf", "pdf"}) {
          if (f == std::string("pdf") && std::max(d.paper_width, d.paper_height) > 5000) continue;
          EXPECT_GT(written(d, f).size(), 100u);
        }
      }
    } catch (const InputError& e) {
      const std::string what = e.what();
      EXPECT_FALSE(what.empty());
      for (const char c : what) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << what;
      ++refused;
    }
  }
  EXPECT_EQ(read + refused, 5000);
  EXPECT_GT(refused, 1000);
  EXPECT_GT(read, 200);
}

TEST(ReadDrawing, GivesBackWhatIsDrawnInEveryStyle) {
  Scene scene;
  scene.parts.push_back(
      {"box", "box", std::make_shared<MeshForm>(test::box({0, 0, 0}, {40, 30, 20}))});
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.paper = Paper::named("A6")});
  for (const StyleInfo& info : builtin_styles()) {
    RunContext context;
    const Drawing drawing = illustrate(scene, camera, builtin_style(info.name),
                                       {.hidden = HiddenLines::Dashed}, context);
    const std::string json = written(drawing, "json");
    EXPECT_EQ(written(parsed(json), "json"), json) << info.name;
  }
}

}  // namespace
}  // namespace burin
