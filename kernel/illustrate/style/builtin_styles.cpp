#include <burin/base/error.h>
#include <burin/illustrate/style.h>
#include <burin/options/meant.h>

#include "stroke_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace burin {
namespace {

/// Features, and light hatching where the light does not reach: what a style is by default.
Style technical() { return {}; }

/// Strokes for every tone between white and black, should the style draw any.
Style full_tone() {
  Style s;
  s.hatch.spacing_min = 0.6;
  s.hatch.spacing_max = 1.4;
  s.hatch.width_max = 0.5;
  s.hatch.tone_min = 0.05;
  s.hatch.cross_from = 0.45;
  s.tone.ambient = 0.12;
  s.tone.highlight = 0.9;
  s.tone.rim = 0.15;
  return s;
}

/// Features alone, three clear widths after ISO 128.
Style outline() {
  Style s = full_tone();
  s.line = {.outer = 0.7,
            .contour = 0.35,
            .crease = 0.25,
            .boundary = 0.35,
            .smooth = 0.18,
            .intersection = 0.25,
            .hidden = 0.18};
  s.hatch.enabled = false;
  return s;
}

/// Full tone by swelling, crossing strokes; the lines of features stay thin.
Style engraving() {
  Style s = full_tone();
  s.line.outer = 0.4;
  s.line.contour = 0.25;
  s.line.crease = 0.18;
  s.line.boundary = 0.25;
  s.line.intersection = 0.2;
  s.feature.smooth = false;
  s.hatch.spacing_min = 0.55;
  s.hatch.spacing_max = 1.1;
  s.hatch.width_min = 0.05;
  s.hatch.width_max = 0.42;
  s.hatch.tone_min = 0.06;
  s.hatch.cross_from = 0.68;
  s.tone.ambient = 0.34;
  s.tone.diffuse = 0.62;
  s.tone.reflected = 0.14;
  s.tone.highlight = 0.92;
  s.tone.rim = 0.05;
  s.tone.median_min = 0.28;
  s.tone.median_max = 0.4;
  s.tone.contrast = 0.12;
  s.tone.gradient = 0.08;
  return s;
}

/// Full tone by many short, thin strokes, laid as a hand lays them.
Style pencil() {
  Style s = engraving();
  s.line.outer = 0.35;
  s.line.crease = 0.2;
  s.line.smooth = 0.13;
  detail::pencilled(s.hatch);
  s.hatch.cross_from = 0.45;
  return s;
}

/// Full tone by dots, as patents and naturalists have it.
Style stipple() {
  Style s = engraving();
  s.line.outer = 0.35;
  s.line.crease = 0.2;
  detail::dotted(s.hatch);
  s.tone.ambient = 0.3;
  s.tone.diffuse = 0.66;
  return s;
}

/// Few, broad strokes that swell from nothing to almost black; no second family.
Style woodcut() {
  Style s = engraving();
  s.line.outer = 0.8;
  s.line.contour = 0.5;
  s.line.crease = 0.4;
  s.line.boundary = 0.5;
  s.line.intersection = 0.4;
  s.hatch.spacing_min = 1.1;
  s.hatch.spacing_max = 1.3;
  s.hatch.width_min = 0.09;
  s.hatch.width_max = 1;
  s.hatch.tone_min = 0.06;
  s.hatch.cross_from = 1.1;
  s.hatch.taper = 3;
  s.hatch.length_min = 4;
  s.tone.ambient = 0.08;
  s.tone.diffuse = 0.9;
  s.tone.highlight = 0.75;
  s.tone.reflected = 0;
  s.tone.median_min = 0;
  s.tone.median_max = 1;
  s.tone.contrast = 0;
  s.tone.gradient = 0;
  s.tone.rim = 0.15;
  return s;
}

/// White lines scraped out of black: ink stands for light.
Style scratchboard() {
  Style s = engraving();
  s.line.outer = 0.3;
  s.hatch.spacing_min = 0.6;
  s.hatch.spacing_max = 1.6;
  s.hatch.width_max = 0.5;
  s.hatch.tone_min = 0.06;
  s.hatch.cross_from = 0.75;
  s.tone.ink = tone::ToneOptions::Ink::Light;
  s.tone.ambient = 0.04;
  s.tone.diffuse = 0.85;
  s.tone.highlight = 1;
  s.tone.reflected = 0.1;
  s.tone.rim = 0;
  s.sheet.ink = "#ffffff";
  s.sheet.paper = "#000000";
  return s;
}

/// Lines at whole steps of height, as maps have them.
Style contour_map() {
  Style s = outline();
  s.line.outer = 0.4;
  s.line.contour = 0.25;
  s.line.boundary = 0.25;
  s.hatch.enabled = true;
  s.hatch.field.name = "planes";
  s.hatch.field.direction = {0, 0, 1};
  s.hatch.placing = "levels";
  s.hatch.spacing_min = s.hatch.spacing_max = 1.6;
  s.hatch.width_min = s.hatch.width_max = 0.13;
  s.hatch.taper = 0;
  s.hatch.tone_min = 0;
  s.hatch.cross_from = 2;
  s.tone = {.law = "constant", .ambient = 0.89, .highlight = 1, .rim = 0};
  return s;
}

/// White lines on blue, as plans were copied; what lies in shade is hatched.
Style blueprint() {
  Style s = technical();
  s.line = {.outer = 0.5,
            .contour = 0.3,
            .crease = 0.25,
            .boundary = 0.3,
            .smooth = 0.13,
            .intersection = 0.25,
            .hidden = 0.18};
  s.hatch.width_min = 0.1;
  s.hatch.width_max = 0.2;
  s.sheet.ink = "#ffffff";
  s.sheet.paper = "#1c4480";
  return s;
}

/// As patent offices ask for it: black lines of two widths, a little shading in lines that stay
/// apart when they are copied at two thirds.
Style patent() {
  Style s = technical();
  s.line = {.outer = 0.5,
            .contour = 0.35,
            .crease = 0.35,
            .boundary = 0.35,
            .smooth = 0.25,
            .intersection = 0.35,
            .hidden = 0.25};
  s.hatch.spacing_min = 1.2;
  s.hatch.spacing_max = 2;
  s.hatch.width_min = 0.18;
  s.hatch.width_max = 0.25;
  s.hatch.tone_min = 0.3;
  s.hatch.taper = 0;
  s.hatch.length_min = 3;
  s.callout.circle = false;
  return s;
}

/// One pen: all lines are as wide, the tone is the distance between them.
Style plotter() {
  constexpr double kPen = 0.3;
  Style s = engraving();
  s.line = {.outer = kPen,
            .contour = kPen,
            .crease = kPen,
            .boundary = kPen,
            .smooth = kPen,
            .intersection = kPen,
            .hidden = kPen};
  s.hatch.width_min = s.hatch.width_max = kPen;
  s.hatch.spacing_min = 0.6;
  s.hatch.spacing_max = 2.4;
  s.hatch.tone_min = 0.08;
  s.hatch.cross_from = 0.4;
  s.hatch.taper = 0;
  put(s.formats, SvgOptions{.flatten = true});
  return s;
}

/// Light strokes; lines behind others stand clear of them, and what is far is thin.
Style haloed() {
  Style s = technical();
  s.line.contour = 0.4;
  s.line.crease = 0.3;
  s.hatch.tone_min = 0.2;
  s.halo.gap = 0.6;
  s.depth.near = 1.25;
  s.depth.far = 0.45;
  return s;
}

/// Every feature line, hidden or not; haloes and widths alone tell what is before what.
Style wireframe() {
  Style s = outline();
  s.line = {.outer = 0.4,
            .contour = 0.4,
            .crease = 0.35,
            .boundary = 0.4,
            .smooth = 0.2,
            .intersection = 0.3,
            .hidden = 0.3};
  s.feature.smooth = false;
  s.halo = {.gap = 0.6, .lines = HaloStyle::Lines::Features, .hidden = true};
  s.depth.near = 1.3;
  s.depth.far = 0.4;
  return s;
}

/// Parts in their colours under lines of three widths.
Style flat() {
  Style s = outline();
  s.line.outer = 0.5;
  s.line.contour = 0.3;
  s.line.crease = 0.2;
  s.fill.color = "part";
  // Of the two sides that an isometric view shows of a box, two tones leave the left one in light.
  s.tone.light = {-0.6, 0.5, 0.62};
  return s;
}

/// The same with the light on them, in two tones, and with all shadows.
Style shaded() {
  Style s = flat();
  s.fill.steps = 2;
  s.fill.darkest = 0.8;
  s.shadow = {.cast = true, .ground = true};
  return s;
}

/// Three tones and a bold outline, as in comics.
Style cel() {
  Style s = flat();
  s.line.outer = 1;
  s.line.contour = 0.5;
  s.line.boundary = 0.5;
  s.line.crease = 0.25;
  s.fill.steps = 3;
  s.fill.darkest = 0.6;
  s.shadow.cast = true;
  return s;
}

/// White parts with pale grey shade, which any printer and copier keeps.
Style manual() {
  Style s = flat();
  s.fill.color = "#ffffff";
  s.fill.steps = 2;
  s.fill.darkest = 0.87;
  return s;
}

/// Black lines over tints of one ink, for printing with two plates.
Style duotone() {
  Style s = flat();
  s.fill.color = "#0078bf";
  s.fill.ink = "Spot";
  s.fill.tint = 0.15;
  s.fill.steps = 3;
  return s;
}
struct Builtin {
  std::string_view name, meaning;
  Style (*make)();
};

constexpr std::array kBuiltin{
    Builtin{"outline", "feature lines alone: thick outer outline, thin inner lines (ISO 128)",
            outline},
    Builtin{"technical", "feature lines, and light hatching where the part lies in shade",
            technical},
    Builtin{"engraving", "full tone: swelling strokes along the form, crossed where it is dark",
            engraving},
    Builtin{"pencil", "full tone: many short, thin strokes along the form, as a hand lays them",
            pencil},
    Builtin{"stipple", "full tone by dots, small where it is light, dense where it is dark",
            stipple},
    Builtin{"woodcut", "bold: few broad strokes that swell from white to almost black", woodcut},
    Builtin{"scratchboard", "white on black: strokes carry the light, as a scraper lays them",
            scratchboard},
    Builtin{"contour-map", "lines of equal height over the whole form, like a map's", contour_map},
    Builtin{"blueprint", "white lines on blue, light hatching where the part lies in shade",
            blueprint},
    Builtin{"patent", "lines of two widths, shaded sparsely, that bear copying and scaling down",
            patent},
    Builtin{"plotter", "one pen: lines of one width as plain polylines, closer where it is dark",
            plotter},
    Builtin{"haloed", "light strokes; lines behind others keep clear of them, far lines are thin",
            haloed},
    Builtin{"wireframe", "all feature lines, hidden ones too: haloes and widths alone show depth",
            wireframe},
    Builtin{"flat", "parts in their colours under the lines", flat},
    Builtin{"shaded", "parts in their colours, two tones of each, under the lines", shaded},
    Builtin{"cel", "parts in their colours, three tones of each, and a bold outline", cel},
    Builtin{"manual", "white parts with pale grey shade, for printed instructions", manual},
    Builtin{"duotone", "black lines over three tints of one spot ink, for two printing plates",
            duotone},
};

// What other programs and people call such drawings.
std::vector<std::string> other_names(std::string_view style) {
  struct Row {
    std::string_view style;
    std::vector<std::string> names;
  };
  static const std::vector<Row> rows = {
      {"outline",
       {"line", "line art", "lineart", "contour", "silhouette", "plain", "ink", "clean"}},
      {"technical", {"default", "standard", "iso", "cad", "mechanical"}},
      {"engraving", {"engrave", "etching", "hatching", "hatched", "crosshatch", "banknote"}},
      {"pencil", {"sketch", "hand drawn", "handdrawn", "drawing", "graphite"}},
      {"stipple", {"dots", "dotted", "pointillism", "halftone"}},
      {"woodcut", {"linocut", "bold", "block print"}},
      {"scratchboard", {"white on black", "dark", "inverted", "negative", "chalk"}},
      {"contour-map", {"topographic", "topo", "height lines", "isolines", "map"}},
      {"blueprint", {"cyanotype", "blue"}},
      {"patent", {"uspto", "patent office"}},
      {"plotter", {"pen plotter", "single line", "axidraw", "laser"}},
      {"haloed", {"halo", "depth"}},
      {"flat", {"color", "colour", "colored", "coloured", "colors", "colours"}},
      {"shaded", {"shade", "shading", "rendered", "tones"}},
      {"cel", {"toon", "cartoon", "comic", "cel shading"}},
      {"manual", {"instructions", "instruction manual", "ikea", "lego"}},
      {"duotone", {"two color", "two colour", "spot color", "spot colour", "risograph", "riso"}},
      {"wireframe", {"wire", "hidden", "xray", "x-ray", "skeleton"}},
  };
  const auto row = std::ranges::find(rows, style, &Row::style);
  return row == rows.end() ? std::vector<std::string>() : row->names;
}

}  // namespace

std::vector<StyleInfo> builtin_styles() {
  std::vector<StyleInfo> styles;
  for (const Builtin& b : kBuiltin) styles.push_back({std::string(b.name), std::string(b.meaning)});
  return styles;
}

Style builtin_style(std::string_view name) {
  std::vector<std::string> names;
  std::vector<KnownWord> known;
  for (const Builtin& b : kBuiltin) {
    if (b.name == name) {
      Style style = b.make();
      style.name = b.name;
      return style;
    }
    names.emplace_back(b.name);
    known.push_back({names.back(), other_names(names.back())});
  }
  throw UsageError(fmt::format("unknown style '{}'{} (built in: {}; or the path of a style file)",
                               name, hint(name, known), fmt::join(names, ", ")));
}

}  // namespace burin
