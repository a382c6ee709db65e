#include <burin/drawing/format_options.h>

namespace burin {

using options::flag;
using options::number;

namespace {

constexpr const char* kOrder =
    "which line of a layer comes next: as in the drawing, or the nearest, so that a pen travels "
    "little";

std::vector<std::string> order_words() { return {"drawing", "travel"}; }

}  // namespace

std::vector<OptionRow<DashOptions>> dash_option_rows() {
  return {
      number("dash", &DashOptions::dash, {0.05, 100, "mm"},
             "length of the dashes of hidden lines, in mm"),
      number("gap", &DashOptions::gap, {0.05, 100, "mm"}, "length of the gaps between them, in mm"),
  };
}

std::vector<OptionRow<SvgOptions>> svg_option_rows() {
  return {
      flag("flatten", &SvgOptions::flatten,
           "polylines: plain polylines of constant width, for plotters and lasers",
           {"polylines", "none"}),
      flag("merge", &SvgOptions::merge, "one element a layer and pen, without sources of lines"),
      options::word("order", &SvgOptions::order, order_words(),
                    std::string(kOrder) + "; then there are no groups of parts"),
      number("fit_tolerance", &SvgOptions::fit_tolerance, {0.001, 1, "mm"},
             "how far fitted curves may be from the computed lines, in mm"),
  };
}

std::vector<OptionRow<JsonOptions>> json_option_rows() {
  return {
      flag("points3", &JsonOptions::points3, "write model coordinates beside those of the paper")};
}

std::vector<OptionRow<PngOptions>> png_option_rows() {
  return {
      number("dpi", &PngOptions::dpi, {10, 4800}, "pixels an inch"),
      options::word("background", &PngOptions::background, {"white", "transparent"},
                    "what is no ink"),
  };
}

std::vector<OptionRow<DxfOptions>> dxf_option_rows() {
  return {flag("arcs", &DxfOptions::arcs,
               "circles, ellipses and their arcs as CIRCLE, ARC and ELLIPSE; else polylines"),
          flag("splines", &DxfOptions::splines,
               "other smooth curves as SPLINE, not as LWPOLYLINE; OpenSCAD reads no SPLINE"),
          options::word("order", &DxfOptions::order, order_words(), kOrder)};
}

}  // namespace burin
