#include "symbols.h"

#include <burin/drawing/color.h>

#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace burin::python {
namespace {

using Pairs = std::vector<std::array<double, 2>>;

std::vector<Vec2> paper_points(const Pairs& given) {
  std::vector<Vec2> out;
  for (const auto& [x, y] : given) {
    if (!std::isfinite(x + y))
      throw pybind11::value_error("a symbol has a point that is no number");
    out.emplace_back(x, y);
  }
  return out;
}

}  // namespace

Label label_of(const pybind11::dict& given) {
  Label out;
  const auto at = [&](const char* key) {
    return pybind11::object(given.attr("get")(key, pybind11::tuple()));
  };
  out.size = paper_points({given["size"].cast<std::array<double, 2>>()}).front();
  if (!(out.size.x > 0 && out.size.y > 0))
    throw pybind11::value_error("\"size\" is two numbers over 0");
  out.shoulder = given.attr("get")("shoulder", 0.5 * out.size.y).cast<double>();
  out.underlined = given.attr("get")("underlined", false).cast<bool>();
  for (const auto& [points, width] : at("lines").cast<std::vector<std::pair<Pairs, double>>>()) {
    Path path;
    path.kind = LineClass::Frame;
    path.points = paper_points(points);
    path.width = {width};
    if (path.points.size() > 1) out.paths.push_back(std::move(path));
  }
  for (const auto& [rings, color] :
       at("fills").cast<std::vector<std::pair<std::vector<Pairs>, std::string>>>()) {
    Area area;
    area.fill = color;
    if (!color.empty() && !rgb_of(color)) throw pybind11::value_error("a fill is #rrggbb or \"\"");
    for (const Pairs& ring : rings) area.rings.push_back(paper_points(ring));
    out.areas.push_back(std::move(area));
  }
  for (const auto& [x, y, height, text] :
       at("texts").cast<std::vector<std::tuple<double, double, double, std::string>>>()) {
    out.texts.push_back(
        {paper_points({{x, y}}).front(), height, TextAnchor::Start, text, "note", 0});
  }
  return out;
}

}  // namespace burin::python
