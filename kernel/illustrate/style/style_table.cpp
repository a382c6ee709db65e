#include "style_table.h"

#include <burin/base/catalogue.h>
#include <burin/base/error.h>
#include <burin/drawing/added_formats.h>
#include <burin/drawing/color.h>
#include <burin/options/meant.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin::detail {
namespace {

using options::append;

constexpr const char* kColor = "a colour #rrggbb";
constexpr const char* kColorOrNone = "a colour #rrggbb or nothing";

// A colour may be given by its name.
template <class T>
OptionRow<T> color(const std::string& name, std::string T::*member, const std::string& meaning,
                   const std::string& phrase) {
  OptionRow<T> row = options::text(name, member, meaning, phrase);
  row.set = [member](T& s, const OptionValue& v) {
    s.*member = without_name(std::get<std::string>(v));
  };
  return row;
}

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
      number("trail", &LineOptions::trail, width,
             "width of the lines on which parts of exploded views have come, in mm"),
      number("centre", &LineOptions::centre, width, "width of centre lines, in mm"),
      number("centre_over", &LineOptions::centre_over, {0, 50, "mm"},
             "how far centre lines go beyond the outline, in mm"),
      number("thread", &LineOptions::thread, width,
             "width of the thin lines of threads, in mm; where threads end it is that of contours"),
      number("thread_gap", &LineOptions::thread_gap, {0, 10, "mm"},
             "how far thin lines of threads stay from the outline at the least, in mm"),

      color("color", &LineOptions::color,
            "colour of the lines, of strokes too; a part in a style of its own has its "
            "own; empty = sheet.ink",
            kColorOrNone),
  };
}

std::vector<OptionRow<HatchStyle>> hatch_rows() {
  std::vector<OptionRow<HatchStyle>> rows = {
      flag("enabled", &HatchStyle::enabled, "draw strokes that carry the tone")};
  append(rows, "", &HatchStyle::field, field::field_option_rows());
  rows.push_back(options::text("select", &HatchStyle::select,
                               "parts that have these strokes: selectors as of looks, with ; "
                               "between them; * = all",
                               "selectors"));
  rows.push_back(color("color", &HatchStyle::color, "colour of these strokes; empty = line.color",
                       kColorOrNone));
  rows.push_back(
      number("share", &HatchStyle::share, {0.01, 100},
             "share of the tone that these strokes carry, if there are several kinds of strokes"));
  return rows;
}

/// Names go on after "fill.hatch".
std::vector<OptionRow<FillHatch>> fill_hatch_rows() {
  return {
      options::word("", &FillHatch::lines, {"none", "lines", "cross"},
                    "parallel lines over a region, or, with fill.color none, in its stead; cross: "
                    "more directions where it is darker"),
      number("_angle", &FillHatch::angle, {-180, 180, "degrees"},
             "degrees from these lines to the horizontal of the sheet"),
      number("_distance", &FillHatch::distance, {0.05, 20, "mm"},
             "distance of these lines, in mm; the width of a plotter's pen fills a region"),
      number("_width", &FillHatch::width, {0.01, 10, "mm"}, "width of these lines, in mm"),
      {{"_tones", "how many tones of tone.steps have these lines, from the darkest",
        WholeRange{1, 5}},
       [](const FillHatch& s) { return OptionValue(static_cast<std::uint64_t>(s.tones)); },
       [](FillHatch& s, const OptionValue& v) {
         s.tones = static_cast<int>(std::get<std::uint64_t>(v));
       }},
      color("_color", &FillHatch::color,
            "colour of these lines: fill = that of the part; empty = line.color",
            "a colour #rrggbb, fill or nothing"),
  };
}

std::vector<OptionRow<FillOptions>> fill_rows() {
  std::vector<OptionRow<FillOptions>> rows = {
      color("color", &FillOptions::color,
            "flat colour under the lines: part = that of the part, or of a palette where it "
            "has none",
            "a colour #rrggbb, part or none"),
      number("opacity", &FillOptions::opacity, {0, 1}, "opacity of that colour"),
      options::text("ink", &FillOptions::ink,
                    "spot ink of that colour in print: a plate of its own in PDF; tones are tints "
                    "of it; empty = none",
                    "a name or nothing"),
      number("tint", &FillOptions::tint, {0, 1},
             "share of the spot ink in the lightest tone; the darkest has all of it"),
      flag("legend", &FillOptions::legend, "list the colour in the legend"),
      flag("faces", &FillOptions::faces,
           "an area for each face, so that drawing files and web pages know it; also without a "
           "colour"),
      flag("shadow", &FillOptions::shadow,
           "the part casts the shadows of shadow.cast and shadow.ground"),
  };
  append(rows, "hatch", &FillOptions::hatch, fill_hatch_rows());
  return rows;
}

/// Tones of the flat colour. They stand with those of strokes, of which they know nothing.
std::vector<OptionRow<FillOptions>> fill_tone_rows() {
  const std::vector<std::string> steps = {"none", "2", "3", "4", "5"};
  return {
      {{"steps", "flat tones that the light gives a colour of fill.color", WordList{steps}},
       [](const FillOptions& s) {
         return OptionValue(static_cast<std::uint64_t>(s.steps > 1 ? s.steps - 1 : 0));
       },
       [](FillOptions& s, const OptionValue& v) {
         const auto at = static_cast<int>(std::get<std::uint64_t>(v));
         s.steps = at > 0 ? at + 1 : 0;
       }},
      number("darkest", &FillOptions::darkest, {0, 1},
             "lightness of the darkest of these tones, as a share of that of the colour"),
  };
}

std::vector<OptionRow<ShadowOptions>> shadow_rows() {
  return {
      flag("cast", &ShadowOptions::cast,
           "the shadows that parts cast on parts and on themselves, in the darkest tone of "
           "fill.color"),
      flag("ground", &ShadowOptions::ground,
           "the shadow that all parts cast on an invisible ground under them, square to z"),
      color(
          "color", &ShadowOptions::color,
          "colour of shadows on the ground and on parts without a fill.color; empty = that of the "
          "paper, darker",
          kColorOrNone),
  };
}

std::vector<OptionRow<HaloStyle>> halo_rows() {
  return {
      number("gap", &HaloStyle::gap, {0, 10, "mm"},
             "white beside a line where another passes behind it, in mm; 0 = off"),
      options::word("lines", &HaloStyle::lines, {"occluding", "features", "all"},
                    "what interrupts lines behind it: where the surface turns away, every feature, "
                    "strokes too"),
      flag("hidden", &HaloStyle::hidden,
           "draw hidden lines in full: haloes alone show what is behind"),
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
               "way"),
          color("ink", &SheetStyle::ink, "colour of all lines", kColor),

          color("paper", &SheetStyle::paper,
                "colour of the sheet; white is not painted (nor is any in DXF)", kColor)};
}

std::vector<KindRow> make_kind_rows() {
  std::vector<KindRow> rows;
  append(rows, "", &StrokeKind::hatch, hatch_rows());
  append(rows, "", &StrokeKind::hatch, hatch_option_rows());
  append(rows, "tone.", &StrokeKind::tone, tone::tone_option_rows());
  return rows;
}

std::string kind_prefix(std::size_t number) { return fmt::format("strokes.{}.", number); }

// Of a stroke kind after the first as one of the style that has it.
StyleRow lifted(const KindRow& row, std::size_t number) {
  const std::size_t at = number - 2;
  const bool of_tone = row.name.starts_with("tone.");
  StyleRow out{{{kind_prefix(number) + row.name, row.meaning, row.takes, row.phrase},
                [at, get = row.get](const Style& s) { return get(s.strokes.at(at)); },
                [at, set = row.set](Style& s, const OptionValue& v) { set(s.strokes.at(at), v); }},
               false,
               needs_of(of_tone ? row.name : kind_group(1) + row.name)};
  if (!row.at_most.empty()) out.at_most = kind_prefix(number) + row.at_most;
  return out;
}

// Rows of members that parts have in their own style, and those that hold for a whole drawing.
class Rows {
 public:
  template <class M, class T>
  void of_parts(const std::string& group, M Style::*member,
                const std::vector<OptionRow<T>>& of_member) {
    std::vector<OptionRow<Style>> more;
    append(more, group, member, of_member);
    add(more, false);
  }
  template <class M, class T>
  void of_whole(const std::string& group, M Style::*member,
                const std::vector<OptionRow<T>>& of_member) {
    std::vector<OptionRow<Style>> more;
    append(more, group, member, of_member);
    add(more, true);
  }
  void add(const std::vector<OptionRow<Style>>& more, bool of_whole) {
    for (const OptionRow<Style>& row : more) rows_.push_back({row, of_whole, needs_of(row.name)});
  }
  std::vector<StyleRow> take() { return std::move(rows_); }

 private:
  std::vector<StyleRow> rows_;
};

std::vector<StyleRow> all_rows() {
  Rows rows;
  rows.of_parts("line.", &Style::line, line_rows());
  rows.of_whole("line.", &Style::dashes, dash_option_rows());
  rows.of_parts("feature.", &Style::feature, feature_option_rows());
  rows.of_parts("hatch.", &Style::hatch, hatch_rows());
  rows.of_parts("hatch.", &Style::hatch, hatch_option_rows());
  rows.of_parts("fill.", &Style::fill, fill_rows());
  rows.of_whole("shadow.", &Style::shadow, shadow_rows());
  rows.of_whole("halo.", &Style::halo, halo_rows());
  rows.of_whole("depth.", &Style::depth, depth_rows());
  rows.of_parts("tone.", &Style::tone, tone::tone_option_rows());
  rows.of_parts("tone.", &Style::fill, fill_tone_rows());
  rows.of_whole("sheet.", &Style::sheet, sheet_rows());
  rows.of_whole("callout.", &Style::callout, callout_option_rows());
  rows.of_whole("dimension.", &Style::dimension, dimension_option_rows());
  rows.of_whole("break.", &Style::broken, break_option_rows());
  rows.of_whole("pmi.", &Style::pmi, pmi_option_rows());
  std::vector<OptionRow<Style>> of_formats;
  options::append_declared(of_formats, &Style::formats, format_options());
  options::append_declared(of_formats, &Style::formats, added_formats());
  rows.add(of_formats, true);
  return rows.take();
}

// What people look for who know a key by another name.
struct OtherNames {
  std::string_view key;
  std::vector<std::string> names;
};

const std::vector<OtherNames>& all_other_names() {
  static const std::vector<OtherNames> rows = {
      {"line.outer",
       {"line width", "line widths", "stroke width", "line weight", "thickness", "pen width",
        "outline width", "outline"}},
      {"line.color", {"colour", "line colour", "pen color", "stroke color", "lines color"}},
      {"feature.contours", {"silhouettes"}},
      {"feature.creases", {"edges", "sharp edges", "feature edges", "visible edges"}},
      {"feature.smooth", {"tangent edges", "smooth edges", "tangent lines"}},
      {"feature.crease_angle",
       {"feature angle", "angle threshold", "smooth angle", "edge angle", "sharp angle", "dihedral",
        "angular tolerance", "angular deflection", "threshold angle"}},
      {"hatch.enabled",
       {"hatch", "hatching", "hatches", "strokes", "shading", "shade", "shaded", "no hatch",
        "no hatching", "no shading", "no strokes", "cross hatching"}},
      {"hatch.spacing_min",
       {"spacing", "density", "hatch density", "distance", "pitch", "line spacing"}},
      {"hatch.width_max", {"hatch width", "stroke weight"}},
      {"fill.color",
       {"fill", "fill colour", "flat color", "surface color", "part color", "colorize"}},
      {"fill.opacity", {"transparency", "alpha"}},
      {"fill.ink", {"spot color", "spot colour", "separation", "pantone", "spot ink", "plate"}},
      {"fill.faces", {"face areas", "areas by face", "face regions", "data-face"}},
      {"fill.shadow", {"casts shadow", "no part shadow", "shadow caster"}},
      {"fill.hatch", {"fill pattern", "hatch fill", "hatched fill", "pattern"}},
      {"tone.steps", {"tones", "cel shading", "toon", "posterize", "flat shading"}},
      {"shadow.cast", {"cast shadows", "self shadow", "part shadow"}},
      {"shadow.ground", {"drop shadow", "floor shadow", "contact shadow"}},
      {"halo.gap", {"haloes"}},
      {"tone.ambient", {"brightness", "lightness", "exposure", "gamma", "ambient light"}},
      {"tone.shadow", {"cast shadow", "no shadow"}},
      {"sheet.ink", {"ink color", "ink colour", "foreground", "fg"}},
      {"sheet.paper",
       {"background", "bg", "background color", "background colour", "paper color", "paper colour",
        "sheet color", "white background"}},
  };
  return rows;
}

}  // namespace

const std::vector<StyleRow>& style_rows() {
  static MadeOfCatalogues<std::vector<StyleRow>> rows;
  return rows.get(all_rows);
}

const std::vector<KindRow>& kind_rows() {
  static MadeOfCatalogues<std::vector<KindRow>> rows;
  return rows.get(make_kind_rows);
}

std::string key_of_parts(std::string_view whole) {
  return whole == "sheet.ink" ? "line.color" : "";
}

std::vector<std::string> other_names_of(std::string_view key) {
  const auto row = std::ranges::find(all_other_names(), key, &OtherNames::key);
  if (row != all_other_names().end()) return row->names;
  for (const FormatOptions& format : format_options()) {
    for (const auto& [option, names] : format.other_names) {
      if (key == std::string(format.name) + "." + option) return names;
    }
  }
  return {};
}

std::vector<StyleRow> all_rows_of(const Style& style) {
  std::vector<StyleRow> rows = style_rows();
  for (std::size_t number = 2; number <= stroke_kind_count(style); ++number) {
    for (const KindRow& row : kind_rows()) rows.push_back(lifted(row, number));
  }
  return rows;
}

std::optional<KindKey> kind_key(std::string_view key) {
  constexpr std::string_view kGroup = "strokes.";
  if (!key.starts_with(kGroup)) return std::nullopt;
  const std::string_view rest = key.substr(kGroup.size());
  const std::size_t dot = rest.find('.');
  const std::string_view number = rest.substr(0, dot);
  if (dot == std::string_view::npos || number.size() != 1 || number < "1" || number > "9") {
    throw UsageError(
        fmt::format("unknown style key '{}'; keys of stroke kinds are strokes.1.placing to "
                    "strokes.{}.placing, and so on",
                    key, kMostStrokeKinds));
  }
  return KindKey{static_cast<std::size_t>(number.front() - '0'), std::string(rest.substr(dot + 1))};
}

std::string row_of_key(std::string_view key) {
  const auto kind = kind_key(key);
  if (!kind || kind->number > 1) return std::string(key);
  return kind->name.starts_with("tone.") ? kind->name : "hatch." + kind->name;
}

std::string kind_group(std::size_t number) { return number == 1 ? "hatch." : kind_prefix(number); }

const KindRow& find_kind_row(const std::string& name, std::size_t number) {
  std::vector<KnownWord> known{{"kind"}};
  for (const KindRow& row : kind_rows()) {
    if (row.name == name) return row;
    known.push_back({row.name});
  }
  const std::string prefix = kind_prefix(number);
  for (KnownWord& one : known) one.say = fmt::format("the nearest is '{}{}'", prefix, one.name);
  throw UsageError(fmt::format("unknown style key '{}{}'{} (all: `style_keys`)", prefix, name,
                               hint(name, known)));
}

const StyleRow& find_row(std::string_view name) {
  std::vector<KnownWord> known;
  for (const StyleRow& row : style_rows()) {
    if (row.name == name) return row;
    known.push_back({row.name, other_names_of(row.name)});
    // "dpi" alone is png.dpi.
    known.back().also.push_back(row.name.substr(row.name.find('.') + 1));
  }
  throw UsageError(
      fmt::format("unknown style key '{}'{} (all: `style_keys`)", name, hint(name, known)));
}

}  // namespace burin::detail
