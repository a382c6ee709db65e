// HPGL and G-code, read back by a reader of their own: every line of the drawing, once, in its
// place.
#include <burin/illustrate/style.h>

#include "writing.h"

#include <burin_test/command.h>
#include <burin_test/plotted.h>

#include <random>

namespace burin {
namespace {

using test::Lines;
using test::parsed;
using test::Plotted;
using test::written;

// Half a unit of 0.025 mm each way is 0.018 mm, thinned points 0.005.
constexpr double kNear = 0.025;

WriteOptions options_of(const std::vector<std::pair<std::string, std::string>>& keys,
                        const std::string& style = "technical") {
  Style made = builtin_style(style);
  for (const auto& [key, value] : keys) set_style_key(made, key, value);
  check_style(made);
  return write_options(made);
}

std::vector<std::string> reported(const Drawing& drawing, std::string_view format,
                                  WriteOptions options = {}) {
  std::vector<std::string> codes;
  options.report = [&](const Diagnostic& one) {
    if (one.severity != Severity::Info) codes.push_back(one.code);
  };
  written(drawing, format, options);
  return codes;
}

/// Every line of the drawing is drawn, nothing else is, and nothing twice.
void expect_all_once(const Plotted& plotted, const Lines& lines, double most_longer) {
  const Lines drawn = test::lines_of(plotted);
  EXPECT_LE(test::Segments(drawn).farthest(lines), kNear);
  EXPECT_LE(test::Segments(lines).farthest(drawn), kNear);
  const double length = test::length_of(lines);
  EXPECT_NEAR(plotted.drawn, length, most_longer * length + 0.5);
}

/// A sheet of 200 x 150 mm with lines of all sorts, most of them on it.
Drawing random_drawing(unsigned seed) {
  std::mt19937 random(seed);
  const auto any = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 100'000) / 100'000;
  };
  Drawing d;
  d.paper_width = 200;
  d.paper_height = 150;
  for (const char* name : {"stroke-1", "crease", "outline"}) {
    Layer& layer = d.layers.emplace_back(Layer{name, {}});
    for (int i = 0; i < 60; ++i) {
      Path& path = layer.paths.emplace_back();
      path.kind = i % 2 == 0 ? LineClass::Stroke : LineClass::Crease;
      Vec2 at(any(5, 195), any(5, 145));
      // Some begin where the one before ended.
      if (i % 3 == 1) at = layer.paths[layer.paths.size() - 2].points.back();
      const int n = 2 + static_cast<int>(random() % 30);
      for (int k = 0; k < n; ++k) {
        path.points.push_back(at);
        const Vec2 step(any(-6, 6), any(-6, 6)), next = at + step;
        // Off an edge, not along it: what runs there and back on one line may be drawn once.
        const Vec2 inside = glm::clamp(next, Vec2(0), Vec2(200, 150));
        at = inside == next ? next : glm::mix(at, Vec2(100, 75), 0.1);
      }
      path.closed = n > 3 && random() % 5 == 0;
      path.width = {any(0.1, 0.6)};
    }
  }
  return d;
}

TEST(Pens, DrawEveryLineOnceInItsPlace) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Drawing drawing = random_drawing(seed);
    const Lines lines = test::visible_lines(drawing);
    const Plotted hpgl = test::read_hpgl(written(drawing, "hpgl"));
    const Plotted gcode = test::read_gcode(written(drawing, "gcode"));
    expect_all_once(hpgl, lines, 0.002);
    expect_all_once(gcode, lines, 0.0002);
    EXPECT_LT(gcode.travel, 0.35 * test::travel_of(lines));
    EXPECT_NEAR(hpgl.travel, gcode.travel, 0.01 * gcode.travel + 1);
    ASSERT_FALSE(HasFailure()) << seed;
  }
}

TEST(Pens, OfTheDrawingOfACouplingTravelAFifth) {
  const test::Folder folder;
  const std::string source = BURIN_SOURCE_DIR "/samples/coupling.step";
  test::Command draw(
      folder, {"draw", source, "--style", "technical", "--quiet", "-o", folder / "a.json", "-o",
               folder / "a.hpgl", "-o", folder / "a.gcode"});
  ASSERT_EQ(draw.wait(), 0) << draw.std_err;
  const Drawing drawing = read_drawing(folder / "a.json", RunContext());
  const Lines lines = test::visible_lines(drawing);
  const Plotted hpgl = test::read_hpgl(test::slurp(folder / "a.hpgl"));
  const Plotted gcode = test::read_gcode(test::slurp(folder / "a.gcode"));
  expect_all_once(hpgl, lines, 0.005);
  expect_all_once(gcode, lines, 0.001);
  const double before = test::travel_of(lines);
  EXPECT_GT(before, 20'000);
  EXPECT_LT(hpgl.travel, 0.2 * before);
  EXPECT_LT(gcode.travel, 0.2 * before);
  RecordProperty("drawn_mm", std::to_string(gcode.drawn));
  RecordProperty("travel_mm", std::to_string(gcode.travel));
  RecordProperty("travel_before_mm", std::to_string(before));
  // The drawing file gives the same, but for its rounding.
  test::Command convert(folder, {"convert", folder / "a.json", "-o", folder / "b.hpgl", "--quiet"});
  ASSERT_EQ(convert.wait(), 0) << convert.std_err;
  expect_all_once(test::read_hpgl(test::slurp(folder / "b.hpgl")), lines, 0.005);
  // SVG and DXF draw the same lines in that order; the layers stay.
  for (const char* format : {"svg", "dxf"}) {
    const std::string key = std::string(format) + ".order";
    const std::string usual = written(drawing, format);
    EXPECT_EQ(written(drawing, format, options_of({{key, "drawing"}})), usual);
    EXPECT_NE(written(drawing, format, options_of({{key, "travel"}})), usual);
  }
}

TEST(Pens, AreThoseOfTheLayers) {
  Drawing d;
  for (const auto& [name, width] :
       {std::pair("stroke-1", 0.18), {"crease", 0.25}, {"contour", 0.25}, {"outline", 0.5}}) {
    Layer& layer = d.layers.emplace_back(Layer{name, {}});
    const double y = 20.0 * static_cast<double>(d.layers.size());
    layer.paths.emplace_back();
    layer.paths[0].points = {{10, y}, {50, y}};
    layer.paths[0].width = {width};
  }
  const auto pens_of = [&](const std::string& pens) {
    std::vector<int> numbers(4, 0);
    const WriteOptions options = options_of({{"hpgl.pens", pens}});
    for (const test::PlottedLine& line : test::read_hpgl(written(d, "hpgl", options)).lines) {
      numbers[static_cast<std::size_t>(std::lround(line.points[0].y / 20)) - 1] = line.pen;
    }
    return numbers;
  };
  EXPECT_EQ(pens_of("auto"), (std::vector{3, 2, 2, 1}));
  EXPECT_EQ(pens_of("layers"), (std::vector{1, 2, 3, 4}));
  EXPECT_EQ(pens_of("one"), (std::vector{1, 1, 1, 1}));
  EXPECT_EQ(pens_of("outline = 5; c*=7;*=0"), (std::vector{0, 7, 7, 5}));
  EXPECT_EQ(pens_of("outline=5"), (std::vector{1, 1, 1, 5}));
  EXPECT_EQ(reported(d, "hpgl", options_of({{"hpgl.pens", "outline=5"}})),
            std::vector<std::string>{"pen.unnamed"});
  const std::string gcode = written(
      d, "gcode", options_of({{"gcode.pen_change", "M5; T{pen} M6"}, {"gcode.tool", "laser"}}));
  EXPECT_NE(gcode.find("; pen 2: 0.25 mm, crease, contour\nM5\nT2 M6\n"), std::string::npos)
      << gcode;
}

TEST(Pens, SayWhatIsWrongWithTheirTexts) {
  for (const auto& [key, value] : {std::pair("hpgl.pens", "outline"),
                                   {"hpgl.pens", "outline=red"},
                                   {"gcode.pens", "outline=65"},
                                   {"hpgl.pens", ""},
                                   {"gcode.pens", "=1"},
                                   {"gcode.down", "M3\nS1"},
                                   {"gcode.up", "M\xc3\xbc"},
                                   {"hpgl.speed", "-1"},
                                   {"hpgl.speed", "fast"},
                                   {"gcode.feed", "0"},
                                   {"gcode.tool", "knife"},
                                   {"svg.order", "random"},
                                   {"hpgl.join", "nan"}}) {
    try {
      options_of({{key, value}});
      ADD_FAILURE() << key << "=" << value;
    } catch (const UsageError& e) {
      EXPECT_NE(std::string(e.what()).find(key), std::string::npos) << e.what();
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    }
  }
}

TEST(Pens, AreCutAtTheSheet) {
  Drawing d =
      parsed(R"({"format": "burin-drawing", "version": 1, "paper": {"width": 2000, "height": 100},
    "layers": [{"name": "contour", "paths": [
      {"points": [[-50, 50], [2050, 50]], "width": 0.5},
      {"points": [[1990, 90], [2010, 90], [2010, 80], [1990, 80]], "closed": true, "width": 0.5},
      {"points": [[10, -5], [20, -5]], "width": 0.5}]}]})");
  const Lines kept{
      {{0, 50}, {2000, 50}}, {{1990, 90}, {2000, 90}}, {{2000, 80}, {1990, 80}, {1990, 90}}};
  expect_all_once(test::read_hpgl(written(d, "hpgl")), kept, 0);
  expect_all_once(test::read_gcode(written(d, "gcode")), kept, 0);
  EXPECT_EQ(reported(d, "hpgl"), std::vector<std::string>{"pen.cut"});
  const std::string middle = written(d, "gcode", options_of({{"gcode.origin", "middle"}}));
  EXPECT_NE(middle.find("X-1000 Y0"), std::string::npos);
}

TEST(Pens, DrawCirclesAndTheirDashesAsArcs) {
  Drawing d;
  d.paper_width = 200;
  d.paper_height = 150;
  d.layers.push_back({"crease", {}});
  for (int i = 0; i < 2; ++i) {
    Path& path = d.layers[0].paths.emplace_back();
    path.closed = true;
    path.visible = i == 0;
    path.width = {0.25};
    for (int k = 0; k < 180; ++k) {
      const double t = 2 * 3.14159265358979323846 * k / 180;
      path.points.push_back(Vec2(60.007 + 70 * i, 71.013) + 30.0 * Vec2(std::cos(t), std::sin(t)));
    }
  }
  const Lines circle = test::visible_lines(d);
  d.layers[0].paths[1].visible = true;
  const Lines both = test::visible_lines(d);
  d.layers[0].paths[1].visible = false;
  const Plotted gcode = test::read_gcode(written(d, "gcode"));
  const Plotted hpgl = test::read_hpgl(written(d, "hpgl"));
  EXPECT_EQ(gcode.lines.size(), 1u + 63);  // 188.5 mm in periods of 3
  EXPECT_EQ(gcode.arcs, 2 + 63);
  EXPECT_GT(hpgl.arcs, 50);
  for (const Plotted* plotted : {&gcode, &hpgl}) {
    EXPECT_LE(test::Segments(both).farthest(test::lines_of(*plotted)), kNear);
    EXPECT_LE(test::Segments(test::lines_of(*plotted)).farthest(circle), kNear);
  }
  EXPECT_LE(test::Segments(both).farthest(test::lines_of(gcode)), 0.01);
  const std::string plain = written(d, "gcode", options_of({{"gcode.arcs", "false"}}));
  EXPECT_EQ(plain.find("G17"), std::string::npos);
  EXPECT_EQ(test::read_gcode(plain).arcs, 0);
  EXPECT_EQ(test::read_hpgl(written(d, "hpgl", options_of({{"hpgl.arcs", "false"}}))).arcs, 0);
  EXPECT_LT(3 * written(d, "gcode").size(), 4 * plain.size());
}

TEST(Pens, DashHiddenLinesAsTheStyleSays) {
  Drawing d =
      parsed(R"({"format": "burin-drawing", "version": 1, "paper": {"width": 200, "height": 100},
    "layers": [{"name": "crease", "paths": [
      {"points": [[10, 50], [60, 50], [60, 90]], "width": 0.25, "visible": false}]}]})");
  const WriteOptions options = options_of({{"line.dash", "6"}, {"line.gap", "3"}});
  const Plotted plotted = test::read_gcode(written(d, "gcode", options));
  // 87 mm are nine of nine and one dash more, which are stretched to the 90 of the line.
  EXPECT_EQ(plotted.lines.size(), 10u);
  EXPECT_NEAR(plotted.drawn, 60.0 * 90 / 87, 0.005 * 10);
  EXPECT_LE(test::Segments({{{10, 50}, {60, 50}, {60, 90}}}).farthest(test::lines_of(plotted)),
            1e-9);
}

TEST(Pens, TellWhatTheyCannotShow) {
  Drawing d = test::sample_drawing();
  EXPECT_EQ(reported(d, "hpgl"), std::vector<std::string>{"pen.width"});
  EXPECT_EQ(reported(Drawing(), "gcode"), std::vector<std::string>{"pen.empty"});
  EXPECT_EQ(test::read_hpgl(written(Drawing(), "hpgl")).lines.size(), 0u);
  EXPECT_EQ(test::read_gcode(written(Drawing(), "gcode")).lines.size(), 0u);
  // Letters are outlines, the dot of a leader is a disc as large as it is.
  d = {};
  Layer& layer = d.layers.emplace_back(Layer{"callouts", {}});
  layer.texts.push_back({{50, 50}, 5, TextAnchor::Middle, "8", "callout", 1});
  Path& leader = layer.paths.emplace_back();
  leader.kind = LineClass::Leader;
  leader.points = {{50, 60}, {80, 60}};
  leader.width = {0.2};
  Path& dot = layer.paths.emplace_back(leader);
  dot.points = {{100, 60}, {100.02, 60}};
  dot.width = {1};
  const Lines lines = test::lines_of(test::read_hpgl(written(d, "hpgl")));
  EXPECT_GE(lines.size(), 3u + 1 + 1);  // an 8 has three outlines
  const test::Segments segments(lines);
  EXPECT_LE(segments.distance({65, 60}), kNear);
  for (int i = 0; i < 100; ++i) {
    const double r = 0.49 * std::sqrt(i / 100.0);
    EXPECT_LE(segments.distance(Vec2(100.01, 60) + r * Vec2(std::cos(2.4 * i), std::sin(2.4 * i))),
              0.13);
  }
}

TEST(Pens, OfALaserAndOfAServoAreWhatTheOptionsSay) {
  Drawing d;
  d.layers.push_back({"contour", {}});
  Path& path = d.layers[0].paths.emplace_back();
  path.points = {{10, 20}, {30, 20}};
  path.width = {0.3};
  const auto body = [&](const std::vector<std::pair<std::string, std::string>>& keys) {
    const std::string text = written(d, "gcode", options_of(keys));
    return text.substr(text.find("G21"));
  };
  EXPECT_EQ(body({}),
            "G21\nG90\nG17\nG0 Z3\nG0 X10 Y20 F6000\nG1 Z0 F1500\nG1 X30 Y20 F1500\nG0 Z3\n"
            "G0 X0 Y0 F6000\nM2\n");
  EXPECT_EQ(
      body({{"gcode.tool", "laser"}, {"gcode.power", "250"}, {"gcode.feed", "900.5"}}),
      "G21\nG90\nG17\nM5\nG0 X10 Y20 F6000\nM3 S250\nG1 X30 Y20 F900.5\nM5\nG0 X0 Y0 F6000\nM2\n");
  EXPECT_EQ(body({{"gcode.down", "M3 S90; G4 P0.2"}, {"gcode.up", "M3 S30;G4 P0.2;"}}),
            "G21\nG90\nG17\nM3 S30\nG4 P0.2\nG0 X10 Y20 F6000\nM3 S90\nG4 P0.2\nG1 X30 Y20 F1500\n"
            "M3 S30\nG4 P0.2\nG0 X0 Y0 F6000\nM2\n");
  EXPECT_EQ(written(d, "hpgl", options_of({{"hpgl.speed", "12.5"}})),
            "IN;\nSP1;\nVS12.5;\nPU400,800;\nPD1200,800;\nPU0,0;\nSP0;\n");
}

}  // namespace
}  // namespace burin
