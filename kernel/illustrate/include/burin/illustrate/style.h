#pragma once
/// A drawing style as plain data.

#include <burin/annotate/break_lines.h>
#include <burin/annotate/dimensions.h>
#include <burin/annotate/options.h>
#include <burin/drawing/format_options.h>
#include <burin/feature/options.h>
#include <burin/field/options.h>
#include <burin/illustrate/pmi.h>
#include <burin/options/declared.h>
#include <burin/stroke/options.h>
#include <burin/tone/options.h>

#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Line widths after ISO 128: the outer outline, inner contours, creases, boundaries, smooth edges
/// and seams, intersections, hidden lines, trails of exploded views, centre lines, thin lines of
/// threads; and their colour.
struct LineOptions {
  double outer = 0.5;
  double contour = 0.3;
  double crease = 0.25;
  double boundary = 0.3;
  double smooth = 0.13;
  double intersection = 0.25;
  double hidden = 0.18;
  double trail = 0.18;
  double centre = 0.18;
  /// Paper mm from the outline of a round face to the end of its centre line.
  double centre_over = 2.5;
  double thread = 0.18;
  /// Paper mm from the thin lines of a thread to the outline of its cylinder, at the least.
  double thread_gap = 0.7;
  /// "#rrggbb" of all lines, strokes too; empty: `SheetStyle::ink`.
  std::string color = {};

  bool operator==(const LineOptions&) const = default;
};

/// The strokes that carry the tone, and what they follow.
struct HatchStyle : HatchOptions {
  bool enabled = true;
  /// Selectors of the parts that have these strokes (burin/assembly/select.h), with ";" between
  /// them; "*": all.
  std::string select = "*";
  /// How much of the ink these strokes carry where other strokes of the same tone lie over them,
  /// relative to theirs: 1 - (1 - ink)^(share / sum of shares), so that all together give the tone.
  double share = 1;
  /// "#rrggbb"; empty: that of the lines.
  std::string color = {};
  field::FieldOptions field{};

  bool operator==(const HatchStyle&) const = default;
};

/// Strokes over those of `Style::hatch`, with a tone of their own.
struct StrokeKind {
  HatchStyle hatch{};
  tone::ToneOptions tone{};

  bool operator==(const StrokeKind&) const = default;
};

/// Parallel lines over regions of flat colour, or in their stead.
struct FillHatch {
  enum class Lines {
    None,
    Lines,
    Cross,  // each darker step has lines of one direction more
  };
  Lines lines = Lines::None;
  /// Degrees from the horizontal of the sheet, anticlockwise.
  double angle = 45;
  /// Paper mm from line to line, and of their width.
  double distance = 0.8;
  double width = 0.13;
  /// How many steps of tone have lines, from the darkest.
  int tones = 1;
  /// "#rrggbb"; "fill": the colour of the part; empty: that of the lines.
  std::string color = {};

  bool operator==(const FillHatch&) const = default;
};

/// Flat colours under the lines.
struct FillOptions {
  /// "#rrggbb"; "part": the colour of the part, or of a palette where it has none; "none".
  std::string color = "none";
  double opacity = 1;
  /// Tones of one colour, from 2 to 5, by the light; 0 = one colour whatever the light.
  int steps = 0;
  /// Lightness of the darkest step, as a share of that of the colour.
  double darkest = 0.55;
  /// Name of the spot ink that `color` stands for in print; empty: none. Its steps are tints of it,
  /// up to all of the ink in the darkest one.
  std::string ink = {};
  /// Share of that ink in the lightest step, or in the one that there is.
  double tint = 0.3;
  /// Whether the part stands in the legend of colours.
  bool legend = true;
  /// Whether each face is an area of its own, painted or not.
  bool faces = false;
  /// Whether the part casts the shadows that the drawing has, on parts and on the ground.
  bool shadow = true;
  FillHatch hatch{};

  bool operator==(const FillOptions&) const = default;
};

struct ShadowOptions {
  /// Of parts on parts: what the light does not reach has the darkest step of its colour; of parts
  /// without a colour, `color`.
  bool cast = false;
  /// On an invisible ground under the scene, square to z.
  bool ground = false;
  /// "#rrggbb"; empty: that of the paper, darker.
  std::string color = {};

  bool operator==(const ShadowOptions&) const = default;
};

struct HaloStyle {
  /// Paper mm of white beside the ink of a line where another passes behind it; 0 = off.
  double gap = 0;
  enum class Lines {
    Occluding,  // contours, boundaries, creases at which the surface turns away
    Features,   // every feature line
    All,        // strokes too
  };
  /// What interrupts lines behind it.
  Lines lines = Lines::Occluding;
  /// Hidden feature lines are drawn in full: haloes alone tell what is behind.
  bool hidden = false;

  bool operator==(const HaloStyle&) const = default;
};

struct DepthOptions {
  /// Factors of all widths at the nearest and the farthest point of the scene; 1 = off.
  double near = 1;
  double far = 1;
  /// Share of its ink that the tone of strokes keeps at the farthest point; 1 = off.
  double ink = 1;

  bool operator==(const DepthOptions&) const = default;
};

struct SheetStyle {
  /// What runs off the sheet is cut at its edge.
  bool clip = true;
  /// "#rrggbb" of all lines and of the paper; DXF has none.
  std::string ink = "#000000", paper = "#ffffff";

  bool operator==(const SheetStyle&) const = default;
};

/// Every choice that shapes a drawing: the sum of the options of all modules. Lengths in
/// paper mm, angles in degrees. Keys of files and of `--set KEY=VALUE` are "group.name" (e.g.
/// "line.outer"); `style_keys` lists them with what they take. The defaults are those of the
/// built-in style "technical".
struct Style {
  std::string name = "technical";
  LineOptions line{};
  FeatureOptions feature{};
  HatchStyle hatch{};
  tone::ToneOptions tone{};
  /// Drawn over `hatch`, the first kind of strokes, in this order; at most `kMostStrokeKinds` with
  /// it. Keys: "strokes.2.spacing_min", "strokes.2.tone.law" and so on, from 2.
  std::vector<StrokeKind> strokes{};
  FillOptions fill{};
  ShadowOptions shadow{};
  HaloStyle halo{};
  DepthOptions depth{};
  SheetStyle sheet{};
  CalloutOptions callout{};
  DimensionOptions dimension{};
  /// Keys "break.line" and so on.
  BreakOptions broken{};
  PmiOptions pmi{};
  /// Keys "line.dash" and "line.gap".
  DashOptions dashes{};
  /// Of the options that formats declare (`format_options`, `added_formats`): keys "svg.flatten",
  /// "txt.decimals" and so on.
  DeclaredValues formats{};

  bool operator==(const Style&) const = default;
};

/// Kinds of strokes that a style may have: one digit in the names of their keys.
constexpr std::size_t kMostStrokeKinds = 9;

/// A kind of strokes of a style by number, from 1: that is `hatch` with `tone`.
std::size_t stroke_kind_count(const Style& style);
const HatchStyle& hatch_of(const Style& style, std::size_t number);
const tone::ToneOptions& tone_of(const Style& style, std::size_t number);
/// Calls a function with each kind, to change it.
template <class F>
void for_each_hatch(Style& style, F&& change) {
  change(style.hatch);
  for (StrokeKind& kind : style.strokes) change(kind.hatch);
}
/// Calls a function with the tone of each kind, to change it.
template <class F>
void for_each_tone(Style& style, F&& change) {
  change(style.tone);
  for (StrokeKind& kind : style.strokes) change(kind.tone);
}
/// Whether any kind is drawn.
bool has_strokes(const Style& style);

/// Names and one-line descriptions of the built-in styles: outline, technical, engraving, pencil,
/// stipple, woodcut, scratchboard, contour-map, blueprint, patent, plotter, haloed, wireframe,
/// flat, shaded, cel, manual, duotone.
struct StyleInfo {
  std::string name;
  std::string description;
};
std::vector<StyleInfo> builtin_styles();

/// The kinds of strokes that an entry of "strokes" may begin as ("kind"), each with what it is.
std::vector<StyleInfo> stroke_kinds();

/// A built-in style by name. Throws UsageError that names the nearest one and lists all.
Style builtin_style(std::string_view name);

/// Reads a style from JSON text: {"base": "engraving", "line.outer": 0.5, "hatch": {"spacing_min":
/// 0.4}}. What it does not set comes from "base" (technical); without "name" it has that of the
/// file. "strokes" is a list of stroke kinds, the first of which changes "hatch"; the others begin
/// as "hatch" and "tone" are, for all parts, and as their "kind" is. Comments are allowed. `source`
/// names it in errors. Throws InputError on broken JSON (with its line), UsageError ("FILE:LINE:
/// ...") on unknown keys or values out of range.
Style parse_style(std::string_view json, const std::string& source);
/// The same, with what neither the text nor its "base" sets from `start`. `whole`: the style is
/// that of some parts of a drawing which has this one; a key that it changes and that holds for a
/// whole drawing (`StyleKey::of_whole`) is a UsageError unless both have the same value.
Style parse_style(std::string_view json, const std::string& source, const Style& start,
                  const Style* whole = nullptr);

/// The style as JSON that `parse_style` reads back to the same style.
std::string style_to_json(const Style& style);

/// Sets one dotted key from text: a number, "true" or "false", a word of a list, or a vector
/// "x,y,z". A key of the stroke kind after the last, "strokes.2.placing", makes that;
/// "strokes.2.kind" changes it to a row of `stroke_kinds`. Throws UsageError that names the nearest
/// known key, or what the key takes.
void set_style_key(Style& style, std::string_view key, std::string_view text);

/// Tests what is not known of a style that no text made: that each member is something that its key
/// takes; and what no single key can: that each "_min" is at most its "_max". Throws UsageError.
void check_style(const Style& style);

/// Sorts keys as they are to be set one after the other: kinds of strokes begin as `hatch` is once
/// it has all its values. 0 before 1 before 2.
int setting_rank(std::string_view key);

/// A key with what it means and takes, and its value in a style as text.
struct StyleKey : Option {
  std::string value;
  /// Parts in a style of their own have the drawing's value all the same.
  bool of_whole = false;
  /// What people look for who know it by another name.
  std::vector<std::string> also = {};

  /// Whose value it is, for programs: "drawing", or "part", whose own style may have another.
  const char* scope() const { return of_whole ? "drawing" : "part"; }
};
/// All keys, those of the stroke kinds that the style has among them.
std::vector<StyleKey> style_keys(const Style& style);

/// Keys that hold for a whole drawing and which `style` has otherwise than `whole` and than the
/// defaults: what is lost where it is that of some parts of a drawing in the style `whole`.
std::vector<std::string> keys_without_effect(const Style& style, const Style& whole);

/// The JSON Schema (draft 2020-12) of style files, for editors and programs.
std::string style_schema();

}  // namespace burin
