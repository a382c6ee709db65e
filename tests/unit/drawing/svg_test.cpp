#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/drawing/writers.h>

#include "polyline_support.h"

#include <burin_test/drawings.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace burin {
namespace {

std::string svg_text(const Drawing& drawing, const SvgOptions& options = {}) {
  std::ostringstream out;
  write_svg(drawing, options, out, RunContext());
  return out.str();
}

pugi::xml_document parsed(const std::string& text) {
  pugi::xml_document doc;
  const auto result = doc.load_string(text.c_str());
  EXPECT_TRUE(result) << result.description();
  return doc;
}

std::string attribute(const pugi::xml_node& node, const char* name) {
  return node.attribute(name).value();
}

/// What SVG inherits: of the element or of the nearest group that says it.
std::string inherited(pugi::xml_node node, const char* name) {
  while (node && !node.attribute(name)) node = node.parent();
  return node.attribute(name).value();
}

/// The points of a path's data, curves sampled, in paper coordinates (y up). Knows the commands the
/// writer uses.
std::vector<Vec2> path_points(const std::string& d, double height, bool* has_curves = nullptr) {
  std::vector<Vec2> out;
  const char* at = d.c_str();
  Vec2 here(0);
  const auto number = [&] {
    while (*at == ' ' || *at == ',') ++at;
    char* end = nullptr;
    const double x = std::strtod(at, &end);
    EXPECT_NE(end, at) << d;
    at = end;
    return x;
  };
  const auto pair = [&] {
    const double x = number();
    return Vec2(x, number());
  };
  char command = 0;
  while (*at) {
    if (std::isalpha(static_cast<unsigned char>(*at))) command = *at++;
    switch (command) {
      case 'M':
        here = pair();
        break;
      case 'h':
        here.x += number();
        break;
      case 'v':
        here.y += number();
        break;
      case 'l':
        here += pair();
        break;
      case 'c': {
        const Vec2 a = here + pair(), b = here + pair(), c = here + pair();
        for (int k = 1; k < 64; ++k) out.push_back(evaluate({here, a, b, c}, k / 64.0));
        here = c;
        if (has_curves) *has_curves = true;
        break;
      }
      case 'z':
        continue;
      default:
        ADD_FAILURE() << "command " << command << " in " << d;
        return out;
    }
    out.push_back(here);
  }
  for (Vec2& p : out) p.y = height - p.y;
  return out;
}

TEST(SvgWriter, SheetIsInMillimetres) {
  const auto doc = parsed(svg_text(test::sample_drawing()));
  const auto svg = doc.child("svg");
  EXPECT_EQ(attribute(svg, "width"), "200mm");
  EXPECT_EQ(attribute(svg, "height"), "150mm");
  EXPECT_EQ(attribute(svg, "viewBox"), "0 0 200 150");
  Drawing odd = test::sample_drawing();
  odd.paper_width = 215.9;
  odd.paper_height = 279.4;
  const auto letter = parsed(svg_text(odd));
  EXPECT_EQ(attribute(letter.child("svg"), "viewBox"), "0 0 215.9 279.4");
  EXPECT_EQ(attribute(letter.child("svg"), "width"), "215.9mm");
}

TEST(SvgWriter, OneGroupALayerInsideItOneGroupAPart) {
  const auto doc = parsed(svg_text(test::sample_drawing()));
  std::vector<std::string> layers, ids, titles;
  std::size_t paths = 0;
  for (const auto& layer : doc.child("svg").children("g")) {
    layers.push_back(attribute(layer, "inkscape:label"));
    ids.push_back(attribute(layer, "id"));
    EXPECT_EQ(attribute(layer, "inkscape:groupmode"), "layer");
    for (const auto& part : layer.children()) {
      ASSERT_STREQ(part.name(), "g");
      ids.push_back(attribute(part, "id"));
      titles.push_back(part.child_value("title"));
      EXPECT_STREQ(part.first_child().name(), "title");
      for (const auto& path : part.children("path")) {
        ++paths;
        EXPECT_EQ(attribute(path, "class"), attribute(path, "data-kind"));
        EXPECT_EQ(attribute(path, "data-part"), attribute(part, "data-part"));
        EXPECT_FALSE(attribute(path, "data-face").empty());
        EXPECT_FALSE(attribute(path, "data-edge").empty());
      }
    }
  }
  EXPECT_EQ(layers, (std::vector<std::string>{"stroke-1", "hidden", "contour"}));
  EXPECT_EQ(titles,
            (std::vector<std::string>{"bracket <A&B>", "part 1", "bracket <A&B>", "part 1"}));
  EXPECT_EQ(paths, 15u);
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
}

TEST(SvgWriter, PathsCarryTheirSource) {
  const auto doc = parsed(svg_text(test::sample_drawing()));
  const auto circle = doc.select_node("//g[@id='contour']//path[@class='contour']").node();
  EXPECT_EQ(attribute(circle, "data-part"), "1");
  EXPECT_EQ(attribute(circle, "data-face"), "12");
  EXPECT_EQ(attribute(circle, "data-edge"), "-1");
  EXPECT_EQ(attribute(circle, "stroke-width"), "0.7");
  const auto crease = doc.select_node("//g[@id='contour']//path[@class='crease']").node();
  EXPECT_EQ(attribute(crease, "data-edge"), "7");
  EXPECT_EQ(attribute(crease, "stroke-width"), "0.25");
  const auto layer = doc.select_node("//g[@id='contour']").node();
  EXPECT_EQ(attribute(layer, "stroke-linecap"), "round");
  EXPECT_EQ(attribute(layer, "stroke-linejoin"), "round");
  EXPECT_EQ(inherited(layer, "fill"), "none");
}

TEST(SvgWriter, StraightLinesStayLinesAndYPointsDown) {
  const auto doc = parsed(svg_text(test::sample_drawing()));
  const auto crease = doc.select_node("//g[@id='contour']//path[@class='crease']").node();
  EXPECT_EQ(attribute(crease, "d"), "M20 90h40v-40l-40-30");
}

TEST(SvgWriter, CurvesKeepTheTolerance) {
  const Drawing drawing = test::sample_drawing();
  const auto doc = parsed(svg_text(drawing));
  const auto circle = doc.select_node("//path[@class='contour']").node();
  bool curves = false;
  const auto points = path_points(attribute(circle, "d"), 150, &curves);
  EXPECT_TRUE(curves);
  EXPECT_EQ(attribute(circle, "d").back(), 'z');
  const auto& given = drawing.layers[2].paths[0].points;
  EXPECT_LE(test::farthest(points, given, true), 0.02);
  EXPECT_LE(test::farthest(given, points, true), 0.02);
}

TEST(SvgWriter, StrokesOfVaryingWidthAreFilledOutlines) {
  const Drawing drawing = test::sample_drawing();
  const auto doc = parsed(svg_text(drawing));
  const auto paths = doc.select_nodes("//g[@id='stroke-1']//path");
  ASSERT_EQ(paths.size(), 12u);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    EXPECT_EQ(inherited(paths[i].node(), "fill"), "#000");
    EXPECT_EQ(inherited(paths[i].node(), "stroke"), "none");
    const Path& p = drawing.layers[0].paths[i];
    double ink = 0;
    for (std::size_t k = 1; k < p.points.size(); ++k) {
      ink += 0.5 * (p.width[k] + p.width[k - 1]) * glm::distance(p.points[k], p.points[k - 1]);
    }
    const auto outline = path_points(attribute(paths[i].node(), "d"), 150);
    EXPECT_NEAR(std::abs(test::signed_area(outline)), ink, 0.02 * ink);
    EXPECT_LT(attribute(paths[i].node(), "d").size(), 3000u);
  }
}

TEST(SvgWriter, HiddenLinesAreDashedInTheirOwnLayer) {
  Drawing drawing = test::sample_drawing();
  drawing.layers.erase(drawing.layers.begin() + 1);
  drawing.layers[1].paths[0].visible = false;  // the circle, in the layer of contours
  const auto doc = parsed(svg_text(drawing, {.dashes = {1.5, 0.75}}));
  const auto first = doc.child("svg").child("g");
  EXPECT_EQ(attribute(first, "inkscape:label"), "hidden");
  EXPECT_EQ(attribute(first, "stroke-dasharray"), "1.5 0.75");
  EXPECT_EQ(first.select_nodes(".//path").size(), 1u);
  EXPECT_TRUE(doc.select_nodes("//g[@id='contour']//path[@class='contour']").empty());
}

TEST(SvgWriter, FlattenGivesPlainPolylines) {
  const Drawing drawing = test::sample_drawing();
  const std::string text = svg_text(drawing, {.flatten = true});
  const auto doc = parsed(text);
  EXPECT_TRUE(doc.select_nodes("//path").empty());
  const auto lines = doc.select_nodes("//polyline");
  ASSERT_EQ(lines.size(), 15u);
  const auto crease = doc.select_node("//g[@id='contour']//polyline[@class='crease']").node();
  EXPECT_EQ(attribute(crease, "points"), "20,90 60,90 60,50 20,20");
  const auto circle = doc.select_node("//polyline[@class='contour']").node();
  const std::string points = attribute(circle, "points");
  EXPECT_EQ(points.substr(0, points.find(' ')), points.substr(points.rfind(' ') + 1));
  const auto stroke = doc.select_node("//polyline[@class='stroke']").node();
  EXPECT_NEAR(std::stod(inherited(stroke, "stroke-width")), 0.3, 0.03);
}

TEST(SvgWriter, NothingButPlainVectors) {
  const std::string text = svg_text(test::sample_drawing());
  for (const char* word : {"<image", "clip", "<script", "href", "<use", "url(", "<style", "mask"}) {
    EXPECT_EQ(text.find(word), std::string::npos) << word;
  }
}

TEST(SvgWriter, SameBytesForAnyNumberOfThreads) {
  Drawing drawing = test::sample_drawing();
  for (int i = 0; i < 400; ++i) {
    drawing.layers[0].paths.push_back(test::wavy_stroke({10, 0.3 * i}, 60 + 0.3 * i, 0.005 * i));
  }
  const std::string all = svg_text(drawing);
  EXPECT_EQ(all, svg_text(drawing));
  const ThreadLimit one(1);
  EXPECT_EQ(all, svg_text(drawing));
}

TEST(SvgWriter, DegenerateDrawings) {
  EXPECT_TRUE(parsed(svg_text(Drawing())).child("svg"));
  Drawing d = test::sample_drawing();
  d.layers = {{"odd name/\xff\x01", {}}, {"1", {}}, {"1", {}}, {"", {}}};
  Path dot = test::feature_line(LineClass::Contour, {{5, 5}, {5, 5}}, false, 0.5);
  Path lost = dot, single = dot;
  lost.points[1].x = std::numeric_limits<double>::quiet_NaN();
  single.points.resize(1);
  d.layers[0].paths = {dot, lost, single};
  d.layers[0].paths[0].source.part = -1;
  const std::string text = svg_text(d);
  const auto doc = parsed(text);
  EXPECT_EQ(doc.select_nodes("//path").size(), 1u);
  EXPECT_EQ(attribute(doc.select_node("//path").node(), "d"), "M5 145h0");
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(SvgWriter, StopsWhenCancelled) {
  RunContext context;
  context.cancel();
  std::ostringstream out;
  EXPECT_THROW(write_svg(test::sample_drawing(), {}, out, context), Cancelled);
}

/// All path data of a file, one sorted list of subpaths for each pair of layer and pen.
std::map<std::pair<std::string, std::string>, std::multiset<std::string>> subpaths(
    const std::string& text) {
  std::map<std::pair<std::string, std::string>, std::multiset<std::string>> out;
  const pugi::xml_document doc = parsed(text);
  for (const auto& found : doc.select_nodes("//path")) {
    const pugi::xml_node path = found.node();
    std::string layer;
    for (pugi::xml_node g = path.parent(); g; g = g.parent()) {
      if (g.attribute("inkscape:label")) layer = attribute(g, "inkscape:label");
    }
    const std::string d = attribute(path, "d");
    for (std::size_t from = 0; from < d.size();) {
      const std::size_t to = std::min(d.find('M', from + 1), d.size());
      out[{layer, inherited(path, "stroke-width")}].insert(d.substr(from, to - from));
      from = to;
    }
  }
  return out;
}

TEST(Svg, MergedFilesHaveOneElementAPenAndTheSameInk) {
  Drawing drawing;
  drawing.layers = {{"contour", {}}, {"stroke-1", {}}};
  for (int i = 0; i < 40; ++i) {
    Path line;
    line.source.part = i % 3;
    line.width = {i % 2 ? 0.35 : 0.7};
    for (int k = 0; k < 8; ++k) line.points.emplace_back(10 + 3 * k, 10 + i + std::sin(k));
    drawing.layers[0].paths.push_back(line);
    line.kind = LineClass::Stroke;
    line.width.assign(8, 0.1);
    line.width[4] = 0.4;
    drawing.layers[1].paths.push_back(line);
  }
  const std::string merged = svg_text(drawing, {.merge = true});
  EXPECT_EQ(parsed(merged).select_nodes("//path").size(), 3u);
  EXPECT_EQ(subpaths(merged), subpaths(svg_text(drawing)));
}

/// The elements that Qt makes of path data: one a move, a line and a closing, three a curve.
std::size_t elements(const std::string& d) {
  std::size_t count = 0, numbers = 0;
  char command = 0;
  const auto finish = [&] {
    if (command == 'M' || command == 'l') count += numbers / 2;
    if (command == 'h' || command == 'v') count += numbers;
    if (command == 'c') count += numbers / 2;
    if (command == 'z') count += 1;
    numbers = 0;
  };
  bool in_number = false;
  for (const char c : d) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      finish();
      command = c;
      in_number = false;
    } else if (c == ' ' || c == '-') {
      in_number = c == '-';
      if (in_number) ++numbers;
    } else if (!in_number) {
      in_number = true;
      ++numbers;
    }
  }
  finish();
  return count;
}

/// A zigzag: as many lines as it has points less one.
Path zigzag(int points, double width) {
  Path line;
  line.kind = LineClass::Crease;
  line.width = {width};
  for (int k = 0; k < points; ++k) line.points.emplace_back(10 + 0.01 * k, 10 + 3 * (k % 2));
  return line;
}

TEST(Svg, NoMergedPathHasMoreElementsThanQtReads) {
  Drawing drawing;
  drawing.paper_width = drawing.paper_height = 1000;
  drawing.layers = {{"crease", std::vector<Path>(200, zigzag(500, 0.35))}};
  const std::string merged = svg_text(drawing, {.merge = true});
  const pugi::xml_document doc = parsed(merged);
  const auto paths = doc.select_nodes("//path");
  EXPECT_EQ(paths.size(), 4u);  // 100,000 elements
  std::size_t all = 0;
  for (const auto& path : paths) {
    all += elements(attribute(path.node(), "d"));
    EXPECT_LE(elements(attribute(path.node(), "d")), 30'000u);
  }
  EXPECT_EQ(all, 100'000u);
  EXPECT_EQ(subpaths(merged), subpaths(svg_text(drawing)));
  EXPECT_EQ(doc.select_nodes("/svg/g/g/path").size(), 4u) << "a group a pen";
}

TEST(Svg, AMergedPathThatIsTooLongByItselfIsParted) {
  for (const bool closed : {false, true}) {
    for (const bool tapered : {false, true}) {
      Path line = zigzag(35'000, 0.05);
      line.closed = closed;
      if (tapered) {
        line.width.assign(line.points.size(), 0.05);
        for (std::size_t i = 0; i < line.width.size(); i += 1000) line.width[i] = 0.2;
      }
      Drawing drawing;
      drawing.paper_width = drawing.paper_height = 1000;
      drawing.layers = {{"crease", {line}}};
      const pugi::xml_document doc = parsed(svg_text(drawing, {.merge = true}));
      std::size_t all = 0;
      for (const auto& path : doc.select_nodes("//path")) {
        const std::size_t count = elements(attribute(path.node(), "d"));
        EXPECT_LE(count, 30'000u);
        all += count;
      }
      EXPECT_GE(all, line.points.size());
    }
  }
}

TEST(Svg, MergedFilesTellWhereTheirInkIs) {
  Drawing drawing;
  drawing.paper_width = 100;
  drawing.paper_height = 50;
  Path line;
  line.points = {{10, 5}, {30, 5}, {30, 40}};
  line.width = {0.5};
  drawing.layers = {{"crease", {line}}};
  EXPECT_EQ(attribute(parsed(svg_text(drawing, {.merge = true})).child("svg"), "data-ink"),
            "9.750 9.750 30.250 45.250");
  drawing.layers.clear();
  EXPECT_FALSE(parsed(svg_text(drawing, {.merge = true})).child("svg").attribute("data-ink"));
}

TEST(Svg, MergedFilesHoldTheColours) {
  Drawing drawing;
  drawing.paper_width = 100;
  drawing.paper_height = 50;
  Path line;
  line.points = {{10, 5}, {30, 5}, {30, 40}};
  drawing.layers = {{"crease", {line}}};
  Area red, glass, bare;
  red.rings = {{{5, 5}, {40, 5}, {40, 45}}, {{20, 10}, {25, 10}, {25, 15}}};
  glass.rings = bare.rings = {{{10, 5}, {30, 5}, {30, 40}}};
  red.fill = "#ff0000";
  glass.fill = "#0000ff";
  glass.opacity = 0.5;
  Area air = glass;
  air.opacity = 0;
  drawing.areas = {red, glass, bare, air};
  const pugi::xml_document doc = parsed(svg_text(drawing, {.merge = true}));
  const pugi::xml_node areas = doc.child("svg").child("g");
  EXPECT_EQ(attribute(areas, "fill-rule"), "evenodd");
  const auto paths = areas.select_nodes("path");
  ASSERT_EQ(paths.size(), 2u) << "what has no colour that is seen is not painted";
  EXPECT_EQ(attribute(paths[0].node(), "fill"), "#ff0000");
  EXPECT_EQ(attribute(paths[0].node(), "stroke"), "#ff0000") << "seams are covered";
  EXPECT_EQ(attribute(paths[1].node(), "fill-opacity"), "0.5");
  const pugi::xml_document whole = parsed(svg_text(drawing));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(attribute(paths[i].node(), "d"),
              attribute(whole.child("svg").child("g").select_nodes("path")[i].node(), "d"));
  }
  EXPECT_EQ(attribute(doc.child("svg"), "data-ink"), "5.000 5.000 40.000 45.000");
}

TEST(Svg, FacesOfTheirOwnColourHaveAClassOfTheirOwn) {
  Drawing drawing;
  drawing.paper_width = drawing.paper_height = 100;
  for (const char* fill : {"#ff0000", "#0000ff", "#ff0000"}) {
    Area area;
    area.part = 0;
    area.fill = fill;
    area.rings = {{{5, 5}, {40, 5}, {40, 45}}};
    drawing.areas.push_back(area);
  }
  const std::string text = svg_text(drawing);
  const pugi::xml_document doc = parsed(text);
  const auto paths = doc.select_nodes("//path");
  ASSERT_EQ(paths.size(), 3u);
  const std::string first = attribute(paths[0].node(), "class"),
                    second = attribute(paths[1].node(), "class");
  EXPECT_EQ(attribute(paths[2].node(), "class"), first);
  EXPECT_EQ(second, first + " color_2");
  // Of rules without specificity the last one counts.
  const auto rule = [&](const char* of) { return text.find(of); };
  EXPECT_LT(rule(".part_0){fill:var(--part-0,#ff0000)"),
            rule(".part_0.color_2){fill:var(--part-0-color-2,#0000ff)"));
  EXPECT_NE(rule(".part_0.color_2)"), std::string::npos);
}

}  // namespace
}  // namespace burin
