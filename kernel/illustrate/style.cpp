#include <burin/base/error.h>
#include <burin/drawing/color.h>
#include <burin/illustrate/style.h>
#include <burin/options/meant.h>

#include "style_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace burin {
namespace {

/// Dots that no neighbour comes too near.
void dotted(HatchStyle& hatch) {
  hatch.placing = "dots";
  hatch.spacing_min = 0.3;
  hatch.width_min = 0.16;
  hatch.width_max = 0.4;
  hatch.tone_min = 0.02;
  hatch.length_min = 0;
}

/// Short, thin strokes.
void pencilled(HatchStyle& hatch) {
  hatch.placing = "discs";
  hatch.length = 5;
  hatch.taper = 2;
  hatch.width_min = 0.09;
  hatch.width_max = 0.2;
  hatch.tone_min = 0.02;
}

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
  pencilled(s.hatch);
  s.hatch.cross_from = 0.45;
  return s;
}

/// Full tone by dots, as patents and naturalists have it.
Style stipple() {
  Style s = engraving();
  s.line.outer = 0.35;
  s.line.crease = 0.2;
  dotted(s.hatch);
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

struct Kind {
  std::string_view name, meaning;
  void (*make)(StrokeKind&);
};

constexpr std::array kKinds{
    Kind{"hatching", "long lines at even distances",
         [](StrokeKind& k) {
           k.hatch.placing = "even";
           k.hatch.cross_from = 2;
         }},
    Kind{"pencil", "short, thin strokes on points that keep clear of each other",
         [](StrokeKind& k) {
           pencilled(k.hatch);
           k.hatch.cross_from = 2;
         }},
    Kind{"dots", "dots on points that keep clear of each other",
         [](StrokeKind& k) { dotted(k.hatch); }},
    Kind{"silhouette", "short strokes along the silhouettes, dense beside them",
         [](StrokeKind& k) {
           pencilled(k.hatch);
           k.hatch.cross_from = 2;
           k.hatch.field.name = "silhouette";
           k.tone.law = "silhouette";
         }},
};

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

std::vector<StyleInfo> stroke_kinds() {
  std::vector<StyleInfo> kinds;
  for (const Kind& k : kKinds) kinds.push_back({std::string(k.name), std::string(k.meaning)});
  return kinds;
}

std::size_t stroke_kind_count(const Style& style) { return 1 + style.strokes.size(); }

const HatchStyle& hatch_of(const Style& style, std::size_t number) {
  return number == 1 ? style.hatch : style.strokes.at(number - 2).hatch;
}

const tone::ToneOptions& tone_of(const Style& style, std::size_t number) {
  return number == 1 ? style.tone : style.strokes.at(number - 2).tone;
}

bool has_strokes(const Style& style) {
  return style.hatch.enabled || std::any_of(style.strokes.begin(), style.strokes.end(),
                                            [](const StrokeKind& k) { return k.hatch.enabled; });
}

namespace detail {

StrokeKind next_kind(const Style& style) {
  if (stroke_kind_count(style) >= kMostStrokeKinds) {
    throw UsageError(fmt::format("a style has at most {} kinds of strokes", kMostStrokeKinds));
  }
  StrokeKind kind{style.hatch, style.tone};
  kind.hatch.enabled = true;
  kind.hatch.select = HatchStyle().select;
  kind.hatch.share = HatchStyle().share;
  return kind;
}

void become(std::string_view kind, StrokeKind& strokes) {
  std::vector<std::string> names;
  for (const Kind& k : kKinds) {
    if (k.name == kind) return k.make(strokes);
    names.emplace_back(k.name);
  }
  throw UsageError(fmt::format("unknown kind of strokes '{}'{} (all: {})", kind,
                               hint(kind, known_words(names)), fmt::join(names, ", ")));
}

}  // namespace detail

namespace {

template <class S>
void set_row(const OptionRow<S>& row, const std::string& name, std::string_view text, S& to) {
  const auto value = parse_value(row, text);
  if (!value) {
    throw UsageError(fmt::format("style key '{}' takes {}, not '{}'", name, takes_text(row), text));
  }
  row.set(to, *value);
}

// The kind whose number is one more than that of the last is made.
void set_kind_key(Style& style, const detail::KindKey& key, std::string_view text) {
  StrokeKind kind = key.number == 1                          ? StrokeKind{style.hatch, style.tone}
                    : key.number <= stroke_kind_count(style) ? style.strokes[key.number - 2]
                                                             : detail::next_kind(style);
  if (key.number > stroke_kind_count(style) + 1) {
    throw UsageError(
        fmt::format("style key 'strokes.{}.{}': the style has {} kinds of strokes; "
                    "the next is number {}",
                    key.number, key.name, stroke_kind_count(style), stroke_kind_count(style) + 1));
  }
  if (key.name == "kind") {
    detail::become(text, kind);
  } else {
    set_row(detail::find_kind_row(key.name, key.number),
            fmt::format("strokes.{}.{}", key.number, key.name), text, kind);
  }
  if (key.number == 1) {
    style.hatch = std::move(kind.hatch);
    style.tone = std::move(kind.tone);
  } else if (key.number <= stroke_kind_count(style)) {
    style.strokes[key.number - 2] = std::move(kind);
  } else {
    style.strokes.push_back(std::move(kind));
  }
}

}  // namespace

void set_style_key(Style& style, std::string_view key, std::string_view text) {
  if (const auto kind = detail::kind_key(key)) return set_kind_key(style, *kind, text);
  const detail::StyleRow& row = detail::find_row(key);
  set_row(row, row.name, text, style);
}

int setting_rank(std::string_view key) {
  if (!key.starts_with("strokes.")) return 0;
  return key.ends_with(".kind") ? 1 : 2;
}

namespace {

std::optional<std::string> first_fault(const Style& style) {
  const std::vector<detail::StyleRow> rows = detail::all_rows_of(style);
  return options::first_fault(std::vector<OptionRow<Style>>(rows.begin(), rows.end()), style);
}

/// `nothing`: how the error names it that there may be none; empty: there must be a colour.
void check_color(const std::string& key, const std::string& color,
                 std::string_view nothing = " or nothing") {
  if (rgb_of(color) || (!nothing.empty() && color.empty())) return;
  throw UsageError(
      fmt::format("style key '{}' takes a colour #rrggbb, a name such as {}{}, not '{}'", key,
                  color_names().front(), nothing, color));
}

}  // namespace

void check_style(const Style& style) {
  if (stroke_kind_count(style) > kMostStrokeKinds) {
    throw UsageError(fmt::format("a style has at most {} kinds of strokes", kMostStrokeKinds));
  }
  const auto fault = first_fault(style);
  if (fault) throw UsageError("style key " + *fault);
  check_color("sheet.ink", style.sheet.ink, "");
  check_color("sheet.paper", style.sheet.paper, "");
  check_color("line.color", style.line.color);
  check_color("shadow.color", style.shadow.color);
  if (style.fill.color != "part" && style.fill.color != "none" && !rgb_of(style.fill.color)) {
    throw UsageError(fmt::format(
        "style key 'fill.color' takes a colour #rrggbb, a name such as {}, part or none, not '{}'",
        color_names().front(), style.fill.color));
  }
  if (const std::string wrong = fault_of_ink(style.fill.ink);
      !style.fill.ink.empty() && !wrong.empty()) {
    throw UsageError("style key 'fill.ink' " + wrong);
  }
  if (style.fill.hatch.color != "fill") {
    check_color("fill.hatch_color", style.fill.hatch.color, ", fill or nothing");
  }
  for (const FormatOptions& format : format_options()) {
    if (format.check) format.check(style.formats);
  }
  for (std::size_t number = 1; number <= stroke_kind_count(style); ++number) {
    check_color(detail::kind_group(number) + "color", hatch_of(style, number).color);
    check_texts(hatch_of(style, number), detail::kind_group(number));
    field::check_texts(hatch_of(style, number).field, detail::kind_group(number));
  }
}

std::vector<StyleKey> style_keys(const Style& style) {
  std::vector<StyleKey> keys;
  for (const detail::StyleRow& row : detail::all_rows_of(style)) {
    keys.push_back(
        {row, value_text(row, row.get(style)), row.of_whole, detail::other_names_of(row.name)});
  }
  return keys;
}

std::vector<std::string> keys_without_effect(const Style& style, const Style& whole) {
  const Style plain;
  std::vector<std::string> keys;
  for (const detail::StyleRow& row : detail::style_rows()) {
    const OptionValue value = row.get(style);
    if (row.of_whole && value != row.get(whole) && value != row.get(plain)) {
      keys.push_back(row.name);
    }
  }
  return keys;
}

}  // namespace burin
