// Every format in true millimetres, the same bytes each time, and nothing lost on nasty drawings.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/base/version.h>

#include "dxf_options.h"
#include "png_options.h"
#include "writing.h"

#include <burin_test/command.h>
#include <burin_test/folder.h>
#include <burin_test/pictures.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>

namespace burin {
namespace {

using test::parsed;
using test::written;

/// A sheet of 200 x 150 with a line of 100 mm and a closed square of 40 mm.
Drawing ruler() {
  return parsed(R"({"format": "burin-drawing", "version": 1, "paper": {"width": 200, "height": 150},
    "layers": [{"name": "contour", "paths": [
      {"points": [[50, 30], [150, 30]], "width": 0.5, "part": 0, "face": 4, "edge": 7, "kind": "crease"},
      {"points": [[50, 60], [90, 60], [90, 100], [50, 100]], "closed": true, "width": 0.25}]}]})");
}

int number_at(const std::string& bytes, std::size_t at) {
  int n = 0;
  for (std::size_t i = 0; i < 4; ++i) n = n << 8 | static_cast<unsigned char>(bytes[at + i]);
  return n;
}

TEST(WriteDrawing, FormatsHaveNames) {
  ASSERT_NE(format_named("PDF"), nullptr);
  EXPECT_EQ(format_named("PDF")->name, "pdf");
  for (const Format& f : formats()) EXPECT_EQ(format_named(f.name), &f);
  EXPECT_EQ(format_named("bmp"), nullptr);
  // What machines and pages call them.
  for (const char* suffix : {"plt", "HPG", "hpgl"}) {
    EXPECT_EQ(format_named(suffix), format_named("hpgl")) << suffix;
  }
  for (const char* suffix : {"nc", "ngc", "gco", "tap"}) {
    EXPECT_EQ(format_named(suffix), format_named("gcode")) << suffix;
  }
  EXPECT_EQ(format_named("htm"), format_named("html"));
  EXPECT_FALSE(is_own_format("plt")) << "a plug-in may have it";
  EXPECT_EQ(format_list(), ".svg, .pdf, .eps, .png, .dxf, .hpgl, .gcode, .json or .html");
}

TEST(Formats, KnowWhichKeysOfAStyleConcernThemAlone) {
  EXPECT_EQ(only_format_of("png.dpi"), format_named("png"));
  EXPECT_EQ(only_format_of("svg.merge"), format_named("svg"));
  EXPECT_EQ(only_format_of("svg.fit_tolerance"), nullptr);  // curves of every format
  EXPECT_EQ(only_format_of("line.outer"), nullptr);
  EXPECT_TRUE(is_about_files("svg.fit_tolerance"));
  EXPECT_TRUE(is_about_files("json.points3"));
  EXPECT_TRUE(is_about_files("line.dash"));
  EXPECT_FALSE(is_about_files("line.outer"));
}

TEST(Formats, DeclareTheirOptionsAsKeysOfStyles) {
  const std::vector<StyleKey> keys = style_keys(Style());
  std::map<std::string, std::size_t> options;
  for (const StyleKey& key : keys) {
    const std::string group = key.name.substr(0, key.name.find('.'));
    if (!format_named(group)) continue;
    ++options[group];
    EXPECT_FALSE(key.meaning.empty()) << key.name;
    EXPECT_FALSE(takes_text(key).empty()) << key.name;
    EXPECT_STREQ(key.scope(), "drawing") << key.name;
    // Commands of a machine that has none of its own.
    EXPECT_EQ(key.value.empty(), key.name == "gcode.down" || key.name == "gcode.up") << key.name;
  }
  EXPECT_EQ(options,
            (std::map<std::string, std::size_t>{
                {"dxf", 3}, {"gcode", 13}, {"hpgl", 4}, {"json", 1}, {"png", 2}, {"svg", 4}}));
  const auto dpi = std::ranges::find(keys, "png.dpi", &StyleKey::name);
  ASSERT_NE(dpi, keys.end());
  EXPECT_EQ(dpi->value, "300");
  EXPECT_EQ(std::ranges::count(dpi->also, "resolution"), 1);
}

TEST(Formats, TakeTheirOptionsFromAStyle) {
  Style style;
  set_style_key(style, "png.dpi", "72");
  set_style_key(style, "svg.flatten", "polylines");
  set_style_key(style, "line.dash", "5");
  const WriteOptions options = write_options(style);
  EXPECT_EQ(values_in<PngOptions>(options.formats).dpi, 72);
  EXPECT_TRUE(options.svg.flatten);
  EXPECT_EQ(options.svg.dashes.dash, 5);
  const auto refused = [&](const char* key, const char* value) {
    try {
      set_style_key(style, key, value);
      check_style(style);
    } catch (const UsageError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused("png.dpi", "5000"), "style key 'png.dpi' takes 10 to 4800, not '5000'");
  EXPECT_EQ(refused("hpgl.pens", "outline=65"),
            "style key 'hpgl.pens' takes auto, layers, one or LAYER=PEN;..., not 'outline=65': "
            "'outline=65': pens are numbers from 0 to 64");
  EXPECT_TRUE(refused("gcode.fed", "9").find("'gcode.feed'") != std::string::npos);
  // Back at what it was: nothing differs from a style that was never changed.
  for (const auto& [key, value] : {std::pair{"png.dpi", "300"},
                                   {"svg.flatten", "none"},
                                   {"line.dash", "2"},
                                   {"hpgl.pens", "auto"}}) {
    set_style_key(style, key, value);
  }
  EXPECT_EQ(style, Style());
}

TEST(Formats, CannotDifferByPart) {
  const Style whole;
  for (const char* key : {"\"svg.flatten\": true", "\"png.dpi\": 99", "\"hpgl.speed\": 9",
                          "\"dxf.splines\": true", "\"gcode.feed\": 9"}) {
    try {
      parse_style("{" + std::string(key) + "}", "red.json", Style(), &whole);
      FAIL() << key;
    } catch (const UsageError& e) {
      EXPECT_NE(std::string(e.what()).find("cannot differ by part"), std::string::npos) << e.what();
    }
  }
}

TEST(WriteDrawing, SameBytesEachTimeForAnyNumberOfThreads) {
  const Drawing drawing = test::sample_drawing();
  for (const Format& f : formats()) {
    const std::string text = written(drawing, f.name);
    EXPECT_GT(text.size(), 1000u);
    EXPECT_EQ(written(drawing, f.name), text);
    const ThreadLimit one(1);
    EXPECT_EQ(written(drawing, f.name), text) << f.name;
  }
}

TEST(WriteDrawing, CancelledRunsStop) {
  const Drawing drawing = test::sample_drawing();
  RunContext cancelled;
  cancelled.cancel();
  for (const Format& f : formats()) {
    std::ostringstream out;
    EXPECT_THROW(write_drawing(drawing, f, {}, out, cancelled), Cancelled) << f.name;
  }
}

TEST(WriteDrawing, NastyDrawingsAreWritten) {
  Drawing d;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto add = [&](std::vector<Vec2> points, std::vector<double> width, bool closed = false) {
    Path p;
    p.points = std::move(points);
    p.width = std::move(width);
    p.closed = closed;
    d.layers[0].paths.push_back(p);
  };
  for (const Format& f : formats()) EXPECT_FALSE(written(d, f.name).empty());
  d.layers.push_back({"a", {}});
  for (const Format& f : formats()) EXPECT_FALSE(written(d, f.name).empty());
  add({}, {});
  add({{1, 1}}, {1});
  add({{1, 1}, {1, 1}}, {5});
  add({{1, 1}, {1, 1}, {1, 1}}, {1, 2, 3}, true);
  add({{1, 1}, {2, 2}}, {nan});
  add({{nan, 1}, {2, 2}}, {1});
  add({{1, 1}, {2, 2}}, {});
  add({{-1e9, 50}, {1e9, 50}}, {0.5});
  add({{-1e9, -1e9}, {1e9, 1e9}, {50, 1e9}}, {0.1, 9, 0.1}, true);
  add({{10, 10}, {10, 10}, {20, 10}, {10, 10}}, {0}, true);
  for (const Format& f : formats()) {
    const std::string text = written(d, f.name);
    EXPECT_EQ(text.find("nan"), std::string::npos) << f.name;
    EXPECT_GT(text.size(), f.name == "hpgl" || f.name == "gcode" ? 100u : 500u) << f.name;
  }
}

TEST(WriteDrawing, SheetsThatAFormatCannotHoldAreRefused) {
  EXPECT_NO_THROW(check_sheet(5080, 10, *format_named("pdf"), {}));
  EXPECT_THROW(check_sheet(5081, 10, *format_named("pdf"), {}), UsageError);
  EXPECT_THROW(check_sheet(0, 10, *format_named("svg"), {}), UsageError);
  WriteOptions fine;
  put(fine.formats, PngOptions{.dpi = 4800});
  EXPECT_THROW(check_sheet(297, 210, *format_named("png"), fine), UsageError);
  Drawing large = ruler();
  large.paper_width = 9000;
  EXPECT_THROW(written(large, "png"), UsageError);
}

TEST(WriteDrawing, PngHasItsSizeAndResolution) {
  WriteOptions options;
  put(options.formats, PngOptions{.dpi = 254});
  const std::string png = written(ruler(), "png", options);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(number_at(png, 16), 2000);
  EXPECT_EQ(number_at(png, 20), 1500);
  EXPECT_EQ(png[25], 0);  // grey
  const std::size_t physical = png.find("pHYs");
  ASSERT_NE(physical, std::string::npos);
  EXPECT_EQ(number_at(png, physical + 4), 10000);
  put(options.formats, PngOptions{.background = PngOptions::Background::Transparent});
  EXPECT_EQ(written(ruler(), "png", options)[25], 4);  // grey and alpha
}

TEST(WriteDrawing, EpsHasTheBoxOfTheSheetAndWholeMicrometres) {
  const std::string eps = written(ruler(), "eps");
  EXPECT_TRUE(eps.starts_with("%!PS-Adobe-3.0 EPSF-3.0\n"));
  EXPECT_NE(eps.find("%%BoundingBox: 0 0 567 426\n"), std::string::npos);
  EXPECT_NE(eps.find("%%HiResBoundingBox: 0 0 566.92913 425.19685\n"), std::string::npos);
  EXPECT_NE(eps.find("50000 30000 m\n100000 0 l\n500 w s\n"), std::string::npos);
  EXPECT_EQ(eps.find("Date"), std::string::npos);
}

TEST(WriteDrawing, PdfHasNoDateUnlessAskedFor) {
  const Drawing drawing = ruler();
  const std::string plain = written(drawing, "pdf");
  EXPECT_TRUE(plain.starts_with("%PDF-1.5"));
  ::setenv("SOURCE_DATE_EPOCH", "86400", 1);
  const std::string dated = written(drawing, "pdf");
  ::unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_EQ(plain.find("CreationDate"), std::string::npos);
  EXPECT_NE(dated, plain);
  EXPECT_EQ(written(drawing, "pdf"), plain);
  // cairo 1.18 packs what it says of the document.
  if (!test::has_program("pdfinfo")) GTEST_SKIP() << "pdfinfo (poppler-utils) is not installed";
  const test::Folder folder;
  for (const auto& [text, line] : {std::pair(plain, ""), {dated, "1970-01-02T00:00:00Z"}}) {
    const std::string file = folder.write("a.pdf", text), listed = folder / "info";
    ASSERT_TRUE(test::shell(fmt::format("pdfinfo -isodates {} >{}", file, listed)));
    const std::string info = test::slurp(listed);
    EXPECT_EQ(info.find("CreationDate") == info.npos, *line == 0) << info;
    EXPECT_NE(info.find(line), info.npos) << info;
  }
}

TEST(WriteDrawing, DxfNamesLayersWeightsAndSources) {
  Drawing d = ruler();
  d.layers.push_back(d.layers[0]);
  d.layers[1].name = "CONTOUR";
  d.layers[1].paths[0].visible = false;
  d.layers.push_back({"gr\xC3\xBC/n", {}});
  const std::string dxf = written(d, "dxf");
  const auto holds = [&](const std::string& text) {
    return dxf.find("\n" + text + "\n") != std::string::npos;
  };
  EXPECT_TRUE(holds("$ACADVER\n1\nAC1015"));
  EXPECT_TRUE(holds("$INSUNITS\n70\n4"));
  EXPECT_TRUE(holds("$EXTMIN\n10\n50.0\n20\n30.0\n30\n0.0"));
  EXPECT_TRUE(holds("$EXTMAX\n10\n150.0\n20\n100.0\n30\n0.0"));
  EXPECT_TRUE(holds("AcDbLayerTableRecord\n2\ncontour\n70\n0\n62\n7\n6\nContinuous\n370\n25"));
  EXPECT_TRUE(holds("AcDbLayerTableRecord\n2\nCONTOUR-2\n70\n0\n62\n7\n6\nContinuous\n370\n25"));
  EXPECT_TRUE(holds("AcDbLayerTableRecord\n2\nhidden\n70\n0\n62\n7\n6\nACAD_ISO02W100\n370\n50"));
  EXPECT_TRUE(holds("2\ngr___n"));
  EXPECT_TRUE(
      holds("8\ncontour\n370\n50\n100\nAcDbLine\n10\n50.0\n20\n30.0\n30\n0.0\n11\n150.0\n21\n"
            "30.0\n31\n0.0\n1001\nBURIN\n1000\ncrease\n1071\n0\n1071\n4\n1071\n7"));
  EXPECT_TRUE(holds("AcDbPolyline\n90\n4\n70\n1\n43\n0.0\n10\n50.0\n20\n60.0"));
  EXPECT_TRUE(dxf.ends_with("ENDSEC\n0\nEOF\n"));
}

TEST(WriteDrawing, DxfStrokesHaveAWidthAtEachVertex) {
  Drawing d = ruler();
  Path stroke;
  stroke.kind = LineClass::Stroke;
  stroke.points = {{10, 10}, {20, 10}, {30, 12}};
  stroke.width = {0, 0.4, 0.1};
  d.layers[0].paths = {stroke};
  EXPECT_NE(written(d, "dxf").find(
                "AcDbPolyline\n90\n3\n70\n0\n10\n10.0\n20\n10.0\n40\n0.0\n41\n0.4\n"
                "10\n20.0\n20\n10.0\n40\n0.4\n41\n0.1\n10\n30.0\n20\n12.0\n40\n0.1\n41\n0.1\n"),
            std::string::npos);
}

// A stroke shorter than half its width is a dot: round in every format.
TEST(WriteDrawing, DotsAreRound) {
  Drawing d = ruler();
  Path dot;
  dot.kind = LineClass::Stroke;
  dot.points = {{10, 10}, {10.02, 10}};
  dot.width = {0.4};
  d.layers[0].paths = {dot};
  EXPECT_NE(
      written(d, "dxf").find("AcDbPolyline\n90\n2\n70\n1\n43\n0.2\n10\n9.91\n20\n10.0\n42\n1.0\n"
                             "10\n10.11\n20\n10.0\n42\n1.0\n"),
      std::string::npos)
      << written(d, "dxf");
  const std::string svg = written(d, "svg");
  EXPECT_NE(svg.find("stroke-width=\"0.4\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("stroke-linecap=\"round\""), std::string::npos) << svg;
  d.layers[0].paths[0].points[1] = {10.3, 10};
  EXPECT_EQ(written(d, "svg").find("stroke-width=\"0.4\""), std::string::npos);
}

/// A sheet with a circle, a dashed ellipse, a slot and a stroke that is a circle.
Drawing round_things() {
  Drawing d;
  d.paper_width = 200;
  d.paper_height = 150;
  Layer& layer = d.layers.emplace_back(Layer{"crease", {}});
  const auto add = [&](Vec2 c, Vec2 radii, double from, double to, int n) -> Path& {
    Path& path = layer.paths.emplace_back();
    path.kind = LineClass::Crease;
    path.source = {2, 5, 9};
    path.width = {0.25};
    for (int i = 0; i <= n; ++i) {
      const double t = from + (to - from) * i / n;
      path.points.push_back(c + radii * Vec2(std::cos(t), std::sin(t)));
    }
    return path;
  };
  constexpr double kPi = 3.14159265358979323846;
  Path& circle = add({50, 50}, {20, 20}, 0, 2 * kPi, 120);
  circle.points.pop_back();
  circle.closed = true;
  Path& hidden = add({120, 50}, {30, 12}, 0, 2 * kPi, 180);
  hidden.points.pop_back();
  hidden.closed = true;
  hidden.visible = false;
  // Two half circles and two lines, clockwise.
  Path& slot = add({120, 110}, {8, 8}, 0.5 * kPi, -0.5 * kPi, 40);
  const Path other = add({60, 110}, {8, 8}, 1.5 * kPi, 0.5 * kPi, 40);
  layer.paths.pop_back();
  Path& whole = layer.paths.back();
  whole.points.insert(whole.points.end(), other.points.begin(), other.points.end());
  whole.closed = true;
  Path& stroke = add({170, 110}, {10, 10}, 0, 2, 60);
  stroke.kind = LineClass::Stroke;
  static_cast<void>(slot);
  return d;
}

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++count;
  return count;
}

/// An arc of 90 segments, from one angle to another.
Path arc_of(Vec2 center, Vec2 axes, double from, double to, std::int32_t edge) {
  Path path;
  path.kind = LineClass::Crease;
  path.visible = true;
  path.source = {2, 5, edge};
  path.width = {0.25};
  for (int i = 0; i <= 90; ++i) {
    const double a = from + (to - from) * i / 90;
    path.points.push_back(center + axes * Vec2(std::cos(a), std::sin(a)));
  }
  return path;
}

TEST(WriteDrawing, DxfHasOneCircleOfTwoHalves) {
  constexpr double kPi = 3.14159265358979323846;
  Drawing d = round_things();
  Layer& layer = d.layers.front();
  layer.paths.clear();
  // A circle and an ellipse in two halves each, the second halves turned round; half a circle and
  // its chord, whose ring is no circle.
  layer.paths = {arc_of({50, 50}, {20, 20}, 0, kPi, 1),
                 arc_of({120, 50}, {30, 12}, 0.25, 0.25 + kPi, 2),
                 arc_of({50, 50}, {20, 20}, 2 * kPi, kPi, 3),
                 arc_of({120, 50}, {30, 12}, 0.25 + 2 * kPi, 0.25 + kPi, 4),
                 arc_of({50, 120}, {10, 10}, 0, kPi, 5),
                 arc_of({50, 120}, {10, 0}, kPi, 2 * kPi, 6)};
  const std::string dxf = written(d, "dxf");
  EXPECT_EQ(count_of(dxf, "\nCIRCLE\n"), 1u);
  EXPECT_EQ(count_of(dxf, "\nELLIPSE\n"), 1u);
  EXPECT_EQ(count_of(dxf, "\nARC\n"), 1u);
  EXPECT_EQ(count_of(dxf, "\nLINE\n"), 1u);
  EXPECT_NE(dxf.find("100\nAcDbCircle\n10\n50.0\n20\n50.0\n30\n0.0\n40\n20.0\n"), dxf.npos);
  EXPECT_EQ(count_of(dxf, "1071\n5\n1071\n"), 4u);
}

TEST(WriteDrawing, DxfHasCirclesArcsAndEllipses) {
  const Drawing d = round_things();
  const std::string dxf = written(d, "dxf");
  EXPECT_EQ(count_of(dxf, "\nCIRCLE\n"), 1u);
  EXPECT_EQ(count_of(dxf, "\nELLIPSE\n"), 1u);
  EXPECT_EQ(count_of(dxf, "\nARC\n"), 2u);
  EXPECT_EQ(count_of(dxf, "\nLINE\n"), 2u);
  EXPECT_EQ(count_of(dxf, "\nLWPOLYLINE\n"), 1u);  // the stroke has its width
  const std::string source = "1001\nBURIN\n1000\ncrease\n1071\n2\n1071\n5\n1071\n9\n";
  EXPECT_EQ(count_of(dxf, source), 6u);
  EXPECT_NE(dxf.find("100\nAcDbCircle\n10\n50.0\n20\n50.0\n30\n0.0\n40\n20.0\n" + source),
            std::string::npos);
  EXPECT_NE(dxf.find("8\nhidden\n100\nAcDbEllipse\n10\n120.0\n20\n50.0\n"), std::string::npos);
  // Anticlockwise: from below to above on the right.
  EXPECT_NE(dxf.find("AcDbCircle\n10\n120.0\n20\n110.0\n30\n0.0\n40\n8.0\n100\nAcDbArc\n50\n270.0\n"
                     "51\n90.0\n"),
            std::string::npos);
  WriteOptions options;
  put(options.formats, DxfOptions{.arcs = false});
  const std::string plain = written(d, "dxf", options);
  EXPECT_EQ(count_of(plain, "\nCIRCLE\n") + count_of(plain, "\nARC\n"), 0u);
  EXPECT_EQ(count_of(plain, "\nLWPOLYLINE\n"), 4u);
  // Every entity has a handle of its own, below that of the next one to come.
  std::set<std::uint64_t> handles;
  std::size_t entities = 0;
  const std::string of_an_entity = "\n330\n1A\n100\nAcDbEntity\n";
  for (std::size_t at = dxf.find("ENTITIES\n"); (at = dxf.find(of_an_entity, at)) != dxf.npos;
       ++at) {
    handles.insert(std::stoull(dxf.substr(dxf.rfind('\n', at - 1) + 1), nullptr, 16));
    ++entities;
  }
  EXPECT_EQ(entities, 7u);
  EXPECT_EQ(handles.size(), entities);
  const std::size_t seed = dxf.find("$HANDSEED\n5\n") + 12;
  EXPECT_LT(*handles.rbegin(), std::stoull(dxf.substr(seed), nullptr, 16));
}

TEST(WriteDrawing, DxfSplinesOnlyWhereAskedFor) {
  const Drawing drawing = test::sample_drawing();
  WriteOptions options;
  put(options.formats, DxfOptions{.arcs = false});
  EXPECT_EQ(written(drawing, "dxf", options).find("\nSPLINE\n"), std::string::npos);
  put(options.formats, DxfOptions{.arcs = false, .splines = true});
  const std::string dxf = written(drawing, "dxf", options);
  EXPECT_NE(dxf.find("\nSPLINE\n"), std::string::npos);
  // n cubics: 3n + 5 knots, 3n + 1 control points.
  const std::size_t at = dxf.find("\n71\n3\n72\n") + 9;
  const int knots = std::stoi(dxf.substr(at));
  EXPECT_EQ((knots - 5) % 3, 0);
  EXPECT_NE(dxf.find(fmt::format("\n72\n{}\n73\n{}\n74\n0\n", knots, knots - 4)),
            std::string::npos);
}

TEST(WriteFile, WritesWholeOrNotAtAll) {
  const test::Folder folder;
  const Drawing drawing = ruler();
  const std::string path = folder / "a.eps";
  write_file(drawing, path, {}, RunContext());
  EXPECT_EQ(test::slurp(path), written(drawing, "eps"));
  RunContext cancelled;
  cancelled.cancel();
  folder.write("b.pdf", "before");
  EXPECT_THROW(write_file(drawing, folder / "b.pdf", {}, cancelled), Cancelled);
  EXPECT_EQ(test::slurp(folder / "b.pdf"), "before");
  EXPECT_THROW(write_file(drawing, folder / "a.bmp", {}, RunContext()), UsageError);
  EXPECT_THROW(write_file(drawing, folder / "none/a.svg", {}, RunContext()), OutputError);
  EXPECT_EQ(folder.count(), 2u);
}

}  // namespace
}  // namespace burin
