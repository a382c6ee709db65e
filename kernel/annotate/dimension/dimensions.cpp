#include <burin/annotate/dimensions.h>
#include <burin/drawing/font.h>

#include "missing_letters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace burin {
namespace {

struct UnitName {
  /// Model mm.
  double length;
  const char* behind;
};

/// In the order of DimensionOptions::Unit.
constexpr std::array<UnitName, 4> kUnits{{{1, ""}, {10, " cm"}, {1000, " m"}, {25.4, " in"}}};

std::string number_text(double value, const DimensionOptions& style) {
  std::string text = fmt::format("{:.{}f}", value, static_cast<int>(style.decimals));
  if (style.decimals > 0) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  if (style.sign == DimensionOptions::Sign::Comma) std::ranges::replace(text, '.', ',');
  return text;
}

}  // namespace

std::vector<OptionRow<DimensionOptions>> dimension_option_rows() {
  using options::number;
  OptionRow<DimensionOptions> decimals{
      {"decimals", "places after the point of dimensions; zeros at the end are left out",
       WholeRange{0, 6}},
      [](const DimensionOptions& s) { return OptionValue(s.decimals); },
      [](DimensionOptions& s, const OptionValue& v) { s.decimals = std::get<std::uint64_t>(v); }};
  return {
      number("height", &DimensionOptions::height, {1, 50, "mm"},
             "height of the numbers of dimensions, in mm"),
      number("line", &DimensionOptions::line, {0.01, 10, "mm"},
             "width of the lines of dimensions, in mm"),
      std::move(decimals),
      options::word("sign", &DimensionOptions::sign, {"point", "comma"},
                    "the sign before the decimals of dimensions"),
      options::word("unit", &DimensionOptions::unit, {"mm", "cm", "m", "inch"},
                    "the unit of dimensions; all but mm are written behind the number"),
  };
}

std::string dimension_text(double length, const DimensionOptions& style) {
  const UnitName& unit = kUnits[static_cast<std::size_t>(style.unit)];
  return number_text(length / unit.length, style) + unit.behind;
}

std::string angle_text(double degrees, const DimensionOptions& style) {
  return number_text(degrees, style) + "\u00b0";
}

bool is_seen_square(const Mat3& axes, Vec3 length) {
  constexpr double kSquare = 1e-6;
  return glm::length(Vec2(axes * length)) > (1 - kSquare) * glm::length(length);
}

namespace {

/// How many texts run off the sheet.
std::int64_t off_sheet(const Layer& layer, const Drawing& drawing) {
  const Box2 sheet{Vec2(0), {drawing.paper_width, drawing.paper_height}};
  return std::ranges::count_if(layer.texts, [&](const Text& text) {
    const Box2 box = text_box(text);
    return !sheet.contains(box.min) || !sheet.contains(box.max);
  });
}

void add_layer(Layer layer, const char* code, const char* what, Drawing& drawing) {
  if (layer.paths.empty() && layer.texts.empty()) return;
  if (const std::int64_t cut = off_sheet(layer, drawing); cut > 0) {
    drawing.diagnostics.add(Severity::Warning, code, cut, what);
  }
  drawing.layers.push_back(std::move(layer));
}

}  // namespace

void lay_dimensions(Drawing& drawing, const Camera& camera, const ViewDimensions& dimensions,
                    const DimensionOptions& style) {
  if (dimensions.list.empty() || camera.perspective()) return;
  const PaperView view{camera.axes(), camera.scale(), camera.to_paper(Vec3(0))};
  LaidDimensions laid = lay_out(dimensions, view, style, &drawing);
  std::vector<std::string> texts;
  for (const Text& text : laid.notes.texts) texts.push_back(text.text);
  detail::report_missing_letters(texts, drawing.diagnostics);
  for (Area& area : laid.areas) {
    // Without a colour of its own it has that of lines, wherever a page changes this.
    area.role = area.fill.empty() ? "pmi" : "symbol";
    if (area.fill.empty()) area.fill = drawing.ink_color;
    drawing.areas.push_back(std::move(area));
  }
  add_layer(std::move(laid.layer), "dimensions.off_sheet",
            "numbers of dimensions run off the sheet: a larger `paper` or smaller "
            "`dimension.height` has room for them",
            drawing);
  add_layer(std::move(laid.notes), "notes.off_sheet",
            "notes run off the sheet: a larger `paper`, a smaller `dimension.height` or shorter "
            "lines (\\n) have room for them",
            drawing);
}

}  // namespace burin
