#include "style_table.h"

#include <burin/base/error.h>
#include <burin/base/nearest.h>

#include <fmt/format.h>

namespace burin::detail {
namespace {

using options::append;
using options::flag;
using options::number;

std::vector<OptionRow<LineOptions>> line_rows() {
  const NumberRange width{0.01, 10, "mm"};
  return {
      number("outer", &LineOptions::outer, width,
             "width of the outer outline, against the empty paper, in mm"),
      number("contour", &LineOptions::contour, width, "width of inner contours, in mm"),
      number("crease", &LineOptions::crease, width, "width of sharp edges, in mm"),
      number("boundary", &LineOptions::boundary, width,
             "width of the borders of open surfaces, in mm"),
      number("smooth", &LineOptions::smooth, width,
             "width of smooth edges and seams of CAD parts, in mm"),
      number("intersection", &LineOptions::intersection, width,
             "width of lines where parts pass through each other, in mm"),
      number("hidden", &LineOptions::hidden, width, "width of hidden lines, in mm"),
  };
}

std::vector<OptionRow<HatchStyle>> hatch_rows() {
  std::vector<OptionRow<HatchStyle>> rows = {
      flag("enabled", &HatchStyle::enabled, "draw strokes that carry the tone")};
  append(rows, "", &HatchStyle::field, field::field_option_rows());
  return rows;
}

std::vector<OptionRow<HaloStyle>> halo_rows() {
  return {
      number("gap", &HaloStyle::gap, {0, 10, "mm"},
             "white beside a line where another passes behind it, in mm; 0 = off"),
      options::word("lines", &HaloStyle::lines, {"occluding", "features", "all"},
                    "what interrupts lines behind it: where the surface turns away, every feature, "
                    "strokes too"),
      flag("hidden", &HaloStyle::hidden,
           "draw hidden lines in full: haloes alone tell what is behind"),
  };
}

std::vector<OptionRow<DepthOptions>> depth_rows() {
  return {
      number("near", &DepthOptions::near, {0.05, 10},
             "factor of all widths at the nearest point of the scene; 1 = off"),
      number("far", &DepthOptions::far, {0.05, 10},
             "factor of all widths at the farthest point of the scene; 1 = off"),
      number("ink", &DepthOptions::ink, {0, 1},
             "share of the strokes' ink that is left at the farthest point; 1 = off"),
  };
}

std::vector<OptionRow<SheetStyle>> sheet_rows() {
  return {flag("clip", &SheetStyle::clip,
               "cut what runs off the sheet at its edge; strokes end a few mm beyond it either "
               "way")};
}

std::vector<StyleRow> all_rows() {
  std::vector<StyleRow> rows;
  append(rows, "line.", &Style::line, line_rows());
  std::vector<OptionRow<SvgOptions>> dashes;
  append(dashes, "", &SvgOptions::dashes, dash_option_rows());
  append(rows, "line.", &Style::svg, dashes);
  append(rows, "feature.", &Style::feature, feature_option_rows());
  append(rows, "hatch.", &Style::hatch, hatch_rows());
  append(rows, "hatch.", &Style::hatch, hatch_option_rows());
  append(rows, "halo.", &Style::halo, halo_rows());
  append(rows, "depth.", &Style::depth, depth_rows());
  append(rows, "tone.", &Style::tone, tone::tone_option_rows());
  append(rows, "sheet.", &Style::sheet, sheet_rows());
  append(rows, "svg.", &Style::svg, svg_option_rows());
  append(rows, "json.", &Style::json, json_option_rows());
  append(rows, "png.", &Style::png, png_option_rows());
  append(rows, "dxf.", &Style::dxf, dxf_option_rows());
  return rows;
}

}  // namespace

const std::vector<StyleRow>& style_rows() {
  static const std::vector<StyleRow> rows = all_rows();
  return rows;
}

const StyleRow& find_row(std::string_view name) {
  std::vector<std::string> names;
  for (const StyleRow& row : style_rows()) {
    if (row.name == name) return row;
    names.push_back(row.name);
  }
  throw UsageError(fmt::format("unknown style key '{}'; the nearest is '{}' (all: `style_keys`)",
                               name, nearest(name, names)));
}

}  // namespace burin::detail
