#include <burin/base/catalogue.h>
#include <burin/drawing/format_options.h>

#include <utility>

namespace burin {

using options::flag;
using options::number;

namespace {

GrowingCatalogue<FormatOptions>& options_catalogue() {
  static GrowingCatalogue<FormatOptions> formats(
      {options_of<SvgOptions>(), options_of<JsonOptions>()});
  return formats;
}

}  // namespace

std::vector<OptionRow<DashOptions>> dash_option_rows() {
  return {
      number("dash", &DashOptions::dash, {0.05, 100, "mm"},
             "length of the dashes of hidden lines, in mm"),
      number("gap", &DashOptions::gap, {0.05, 100, "mm"}, "length of the gaps between them, in mm"),
  };
}

std::vector<std::string> line_order_words() { return {"drawing", "travel"}; }

std::string line_order_meaning() {
  return "which line of a layer comes next: as in the drawing, or the nearest, so that a pen "
         "travels little";
}

std::vector<OptionRow<SvgOptions>> SvgOptions::rows() {
  return {
      flag("flatten", &SvgOptions::flatten,
           "polylines: plain polylines of constant width, for plotters and lasers",
           {"polylines", "none"}),
      flag("merge", &SvgOptions::merge, "one element a layer and pen, without sources of lines"),
      options::word("order", &SvgOptions::order, line_order_words(),
                    line_order_meaning() + "; then there are no groups of parts"),
      number("fit_tolerance", &SvgOptions::fit_tolerance, {0.001, 1, "mm"},
             "how far fitted curves may be from the computed lines, in mm"),
  };
}

std::vector<OptionRow<JsonOptions>> JsonOptions::rows() {
  return {
      flag("points3", &JsonOptions::points3, "write model coordinates beside those of the paper")};
}

std::span<const FormatOptions> format_options() { return options_catalogue().rows(); }

void add(FormatOptions options) { options_catalogue().add(std::move(options)); }

}  // namespace burin
