#pragma once
/// A drawing style as plain data.

#include <burin/base/vec.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Every choice that shapes a drawing, in groups. Lengths in paper mm, angles in degrees. Keys of
/// files and of `--set KEY=VALUE` are "group.member" (e.g. "line.outer"); `style_keys` lists them
/// with what they take. The defaults are those of the built-in style "technical".
struct Style {
  std::string name = "technical";

  struct {
    /// Line widths after ISO 128: the outer outline, inner contours, creases, boundaries, smooth
    /// edges and seams, intersections, hidden lines.
    double outer = 0.5;
    double contour = 0.3;
    double crease = 0.25;
    double boundary = 0.3;
    double smooth = 0.13;
    double intersection = 0.25;
    double hidden = 0.18;
    /// Dash and gap of hidden lines.
    double dash = 2.0;
    double gap = 1.0;
  } line;

  struct {
    bool contours = true;
    bool creases = true;
    bool boundaries = true;
    /// Edges of CAD parts over which the surface goes on smoothly, and where a face meets itself.
    bool smooth = true;
    bool seams = false;
    bool intersections = true;
    double crease_angle = 30;
  } feature;

  struct {
    bool enabled = true;
    /// What strokes follow: the name of a row of field::catalogue().
    std::string field = "smoothed";
    Vec3 direction{0, 0, 1};
    double alignment = 1;
    double spacing_min = 0.9;
    double spacing_max = 1.6;
    double width_min = 0.08;
    double width_max = 0.22;
    double tone_min = 0.35;
    double cross_from = 1.1;
    double length_min = 2.5;
    double length_max = 2000;
    double taper = 2.5;
    double foreshortening = 0;
    /// Exact forms, by the kind of their faces (see field::FacePolicy): "differ" or "direction";
    /// "circles" or "rulings", twice; "axis" or "view".
    std::string plane = "differ";
    std::string cylinder = "circles";
    std::string cone = "circles";
    std::string sphere = "axis";
  } hatch;

  struct {
    Vec3 light{-0.5, 0.65, 0.6};
    double ambient = 0.35;
    double diffuse = 0.82;
    double highlight = 0.7;
    double rim = 0.05;
  } tone;

  struct {
    /// Paper mm of white beside the ink of a line where another passes behind it; 0 = off.
    double gap = 0;
    /// What interrupts lines behind it: "occluding" (contours, boundaries, creases at which the
    /// surface turns away), "features" (every feature line) or "all" (strokes too).
    std::string lines = "occluding";
    /// Hidden feature lines are drawn in full: haloes alone tell what is behind.
    bool hidden = false;
  } halo;

  struct {
    /// Factors of all widths at the nearest and the farthest point of the scene; 1 = off.
    double near = 1;
    double far = 1;
    /// Share of its ink that the tone of strokes keeps at the farthest point; 1 = off.
    double ink = 1;
  } depth;

  struct {
    /// What runs off the sheet is cut at its edge.
    bool clip = true;
  } sheet;

  struct {
    bool flatten = false;
    bool merge = false;
    double fit_tolerance = 0.02;
  } svg;

  struct {
    bool points3 = true;
  } json;

  struct {
    double dpi = 300;
    /// "white" or "transparent".
    std::string background = "white";
  } png;

  struct {
    bool splines = false;
  } dxf;
};

/// Names and one-line descriptions of the built-in styles: outline, technical, engraving,
/// haloed, wireframe.
struct StyleInfo {
  std::string name;
  std::string description;
};
std::vector<StyleInfo> builtin_styles();

/// A built-in style by name. Throws UsageError that names the nearest one and lists all.
Style builtin_style(std::string_view name);

/// Reads a style from JSON text: {"base": "engraving", "line.outer": 0.5, "hatch": {"spacing_min":
/// 0.4}}. What it does not set comes from "base" (technical); without "name" it has that of the
/// file. Comments are allowed. `source` names it in errors. Throws InputError on broken JSON (with
/// its line), UsageError ("FILE:LINE: ...") on unknown keys or values out of range.
Style parse_style(std::string_view json, const std::string& source);

/// The style as JSON that `parse_style` reads back to the same style.
std::string style_to_json(const Style& style);

/// Sets one dotted key from text: a number, "true" or "false", a word of a list, or a vector
/// "x,y,z". Throws UsageError that names the nearest known key, or what the key takes.
void set_style_key(Style& style, std::string_view key, std::string_view value);

/// Tests what is not known of a style that no text made: that each member is something that its key
/// takes; and what no single key can: that each "_min" is at most its "_max". Throws UsageError.
void check_style(const Style& style);

/// One key: what it means, what it takes ("0.01 to 10", "true or false") and its value in `style`
/// as text.
struct StyleKeyInfo {
  std::string key;
  std::string meaning;
  std::string takes;
  std::string value;
};
std::vector<StyleKeyInfo> style_keys(const Style& style);

}  // namespace burin
