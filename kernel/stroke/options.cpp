#include <burin/base/catalogue.h>
#include <burin/stroke/options.h>

#include "placing.h"

#include <string>

namespace burin {
namespace {

constexpr const char* kFormula = "a formula";

std::vector<OptionRow<HatchOptions>> rows() {
  using options::number;
  std::string meaning;
  for (const detail::Placing& placing : detail::placings()) {
    meaning += (meaning.empty() ? "how strokes are placed: " : "; ") + std::string(placing.meaning);
  }
  std::vector<OptionRow<HatchOptions>> rows = {
      options::word("placing", &HatchOptions::placing, names_of(detail::placings()), meaning),
      number("spacing_min", &HatchOptions::spacing_min, {0.05, 50, "mm"},
             "distance of strokes where the tone is darkest, in mm", "spacing_max"),
      number("spacing_max", &HatchOptions::spacing_max, {0.05, 50, "mm"},
             "distance of strokes where the tone is lightest, in mm"),
      number("width_min", &HatchOptions::width_min, {0.01, 10, "mm"}, "thinnest stroke, in mm",
             "width_max"),
      number("width_max", &HatchOptions::width_max, {0.01, 10, "mm"}, "widest stroke, in mm"),
      number("tone_min", &HatchOptions::tone_min, {0, 1},
             "share of ink below which the paper stays white"),
      number("cross_from", &HatchOptions::cross_from, {0, 2},
             "share of ink from which a second family crosses the first; over 1 = never"),
      number("cross_angle", &HatchOptions::cross_angle, {30, 90, "degrees"},
             "angle on the surface between the two families, in degrees; 90 follows the field's "
             "own second direction"),
      number("length_min", &HatchOptions::length_min, {0, 1000, "mm"}, "shortest stroke, in mm",
             "length_max"),
      number("length_max", &HatchOptions::length_max, {0.1, 100000, "mm"}, "longest stroke, in mm"),
      number("length", &HatchOptions::length, {0.1, 1000, "mm"},
             "about how long strokes on points are, in mm (hatch.placing points, discs)"),
      number(
          "level_step", &HatchOptions::level_step, {0, 1e6},
          "between lines at whole steps of height, depth, side or cosine (hatch.placing levels; "
          "fields planes, silhouette, screen-vertical in model mm; isophotes); 0 = a round number "
          "of about hatch.spacing_min on paper"),
      options::text("ink_law", &HatchOptions::ink_law,
                    "what strokes cover of the paper, of the ink that the tone asks for", kFormula),
      options::text("density_law", &HatchOptions::density_law,
                    "factor of the density of strokes; none where it is 0 or less", kFormula),
      options::text("width_law", &HatchOptions::width_law, "factor of the width of strokes",
                    kFormula),
      options::text("length_law", &HatchOptions::length_law,
                    "factor of the length of strokes on points", kFormula),
      options::text("presence_law", &HatchOptions::presence_law,
                    "the chance of each stroke to be drawn, from 0 to 1", kFormula),
      options::text("motif", &HatchOptions::motif,
                    "what is drawn at each point instead of a stroke, hatch.length large along "
                    "its longer side (hatch.placing points, discs)",
                    "path data of SVG (M0 0L1 1), the name of an .svg file, or none"),
      options::text("image", &HatchOptions::image,
                    "a picture that laws know as image(u, v), from 0 black to 1 white, and that "
                    "hatch.field texture-image runs across the gradient of",
                    "the name of a .png file, or none"),
      number("taper", &HatchOptions::taper, {0, 1000, "mm"},
             "length over which the end of a stroke thins out, in mm"),
      number("foreshortening", &HatchOptions::foreshortening, {0, 1},
             "0 spaces strokes evenly on the paper, 1 on the surface"),
  };
  options::append_declared(rows, &HatchOptions::declared, mark_kinds());
  return rows;
}

}  // namespace

const std::vector<OptionRow<HatchOptions>>& hatch_option_rows() {
  static MadeOfCatalogues<std::vector<OptionRow<HatchOptions>>> all;
  return all.get(rows);
}

}  // namespace burin
