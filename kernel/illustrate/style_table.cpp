#include "style_table.h"

#include <burin/base/error.h>
#include <burin/base/nearest.h>
#include <burin/field/catalogue.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace burin::detail {
namespace {

/// A member by its way into Style.
// NOLINTNEXTLINE(bugprone-macro-parentheses): a type takes none
#define BURIN_MEMBER(type, path) [](Style& s) -> type& { return s.path; }

StyleKey number(const char* name, double& (*member)(Style&), double low, double high,
                const char* meaning) {
  return {name, meaning, NumberKey{member, low, high}};
}

StyleKey flag(const char* name, bool& (*member)(Style&), const char* meaning) {
  return {name, meaning, FlagKey{member}};
}

std::vector<std::string> field_names() {
  std::vector<std::string> names;
  for (const field::FieldKind& kind : field::catalogue()) names.emplace_back(kind.name);
  return names;
}

std::vector<StyleKey> line_keys() {
  return {
      number("line.outer", BURIN_MEMBER(double, line.outer), 0.01, 10,
             "width of the outer outline, against the empty paper, in mm"),
      number("line.contour", BURIN_MEMBER(double, line.contour), 0.01, 10,
             "width of inner contours, in mm"),
      number("line.crease", BURIN_MEMBER(double, line.crease), 0.01, 10,
             "width of sharp edges, in mm"),
      number("line.boundary", BURIN_MEMBER(double, line.boundary), 0.01, 10,
             "width of the borders of open surfaces, in mm"),
      number("line.smooth", BURIN_MEMBER(double, line.smooth), 0.01, 10,
             "width of smooth edges and seams of CAD parts, in mm"),
      number("line.intersection", BURIN_MEMBER(double, line.intersection), 0.01, 10,
             "width of lines where parts pass through each other, in mm"),
      number("line.hidden", BURIN_MEMBER(double, line.hidden), 0.01, 10,
             "width of hidden lines, in mm"),
      number("line.dash", BURIN_MEMBER(double, line.dash), 0.05, 100,
             "length of the dashes of hidden lines, in mm"),
      number("line.gap", BURIN_MEMBER(double, line.gap), 0.05, 100,
             "length of the gaps between them, in mm"),
  };
}

std::vector<StyleKey> feature_keys() {
  return {
      flag("feature.contours", BURIN_MEMBER(bool, feature.contours),
           "draw contours (silhouettes), outer and inner"),
      flag("feature.creases", BURIN_MEMBER(bool, feature.creases), "draw sharp edges"),
      flag("feature.boundaries", BURIN_MEMBER(bool, feature.boundaries),
           "draw the borders of open surfaces"),
      flag("feature.smooth", BURIN_MEMBER(bool, feature.smooth),
           "draw the edges of CAD parts over which the surface goes on smoothly"),
      flag("feature.seams", BURIN_MEMBER(bool, feature.seams),
           "draw the edges of CAD parts where a face meets itself"),
      flag("feature.intersections", BURIN_MEMBER(bool, feature.intersections),
           "draw the lines where parts pass through each other"),
      number("feature.crease_angle", BURIN_MEMBER(double, feature.crease_angle), 0, 180,
             "degrees between neighbouring triangles from which an edge is sharp"),
  };
}

std::vector<StyleKey> hatch_keys() {
  return {
      flag("hatch.enabled", BURIN_MEMBER(bool, hatch.enabled), "draw strokes that carry the tone"),
      {"hatch.field",
       "what strokes follow: the smoothed or raw principal directions, lines of constant angle to "
       "the view or the light, or across them, parameter lines, planes across hatch.direction, up "
       "on the sheet, or one direction",
       WordKey{BURIN_MEMBER(std::string, hatch.field), field_names()}},
      {"hatch.direction",
       "the fixed direction, in model space, also where a surface has none of its own",
       VectorKey{BURIN_MEMBER(Vec3, hatch.direction)}},
      number("hatch.alignment", BURIN_MEMBER(double, hatch.alignment), 0, 100,
             "how closely the smoothed field keeps to the curvature"),
      number("hatch.spacing_min", BURIN_MEMBER(double, hatch.spacing_min), 0.05, 50,
             "distance of strokes where the tone is darkest, in mm"),
      number("hatch.spacing_max", BURIN_MEMBER(double, hatch.spacing_max), 0.05, 50,
             "distance of strokes where the tone is lightest, in mm"),
      number("hatch.width_min", BURIN_MEMBER(double, hatch.width_min), 0.01, 10,
             "thinnest stroke, in mm"),
      number("hatch.width_max", BURIN_MEMBER(double, hatch.width_max), 0.01, 10,
             "widest stroke, in mm"),
      number("hatch.tone_min", BURIN_MEMBER(double, hatch.tone_min), 0, 1,
             "share of ink below which the paper stays white"),
      number("hatch.cross_from", BURIN_MEMBER(double, hatch.cross_from), 0, 2,
             "share of ink from which a second family crosses the first; over 1 = never"),
      number("hatch.length_min", BURIN_MEMBER(double, hatch.length_min), 0, 1000,
             "shortest stroke, in mm"),
      number("hatch.length_max", BURIN_MEMBER(double, hatch.length_max), 0.1, 100000,
             "longest stroke, in mm"),
      number("hatch.taper", BURIN_MEMBER(double, hatch.taper), 0, 1000,
             "length over which the end of a stroke thins out, in mm"),
      number("hatch.foreshortening", BURIN_MEMBER(double, hatch.foreshortening), 0, 1,
             "0 spaces strokes evenly on the paper, 1 on the surface"),
      {"hatch.plane",
       "strokes on plane faces of CAD parts: neighbours differ, or all follow hatch.direction",
       WordKey{BURIN_MEMBER(std::string, hatch.plane), {"differ", "direction"}}},
      {"hatch.cylinder", "the first strokes on cylinders of CAD parts go round or along",
       WordKey{BURIN_MEMBER(std::string, hatch.cylinder), {"circles", "rulings"}}},
      {"hatch.cone", "the first strokes on cones of CAD parts go round or along",
       WordKey{BURIN_MEMBER(std::string, hatch.cone), {"circles", "rulings"}}},
      {"hatch.sphere",
       "balls of CAD parts: circles about hatch.direction or about the line of view",
       WordKey{BURIN_MEMBER(std::string, hatch.sphere), {"axis", "view"}}},
  };
}

std::vector<StyleKey> depth_keys() {
  return {
      number("halo.gap", BURIN_MEMBER(double, halo.gap), 0, 10,
             "white beside a line where another passes behind it, in mm; 0 = off"),
      {"halo.lines",
       "what interrupts lines behind it: where the surface turns away, every feature, strokes too",
       WordKey{BURIN_MEMBER(std::string, halo.lines), {"occluding", "features", "all"}}},
      flag("halo.hidden", BURIN_MEMBER(bool, halo.hidden),
           "draw hidden lines in full: haloes alone tell what is behind"),
      number("depth.near", BURIN_MEMBER(double, depth.near), 0.05, 10,
             "factor of all widths at the nearest point of the scene; 1 = off"),
      number("depth.far", BURIN_MEMBER(double, depth.far), 0.05, 10,
             "factor of all widths at the farthest point of the scene; 1 = off"),
      number("depth.ink", BURIN_MEMBER(double, depth.ink), 0, 1,
             "share of the strokes' ink that is left at the farthest point; 1 = off"),
  };
}

std::vector<StyleKey> other_keys() {
  return {
      {"tone.light", "direction from the model to the light: right, up, towards the viewer",
       VectorKey{BURIN_MEMBER(Vec3, tone.light)}},
      number("tone.ambient", BURIN_MEMBER(double, tone.ambient), 0, 1, "lightness in full shade"),
      number("tone.diffuse", BURIN_MEMBER(double, tone.diffuse), 0, 2,
             "lightness that full light adds"),
      number("tone.highlight", BURIN_MEMBER(double, tone.highlight), 0, 2,
             "lightness from which the paper stays white"),
      number("tone.rim", BURIN_MEMBER(double, tone.rim), 0, 1,
             "darkness added where the surface turns away from the viewer"),
      flag("sheet.clip", BURIN_MEMBER(bool, sheet.clip),
           "cut what runs off the sheet at its edge; strokes end a few mm beyond it either way"),
      {"svg.flatten", "polylines: plain polylines of constant width, for plotters and lasers",
       FlagKey{BURIN_MEMBER(bool, svg.flatten), "polylines", "none"}},
      flag("svg.merge", BURIN_MEMBER(bool, svg.merge),
           "one element a layer and pen; sources are not told"),
      number("svg.fit_tolerance", BURIN_MEMBER(double, svg.fit_tolerance), 0.001, 1,
             "how far fitted curves may be from the computed lines, in mm"),
      flag("json.points3", BURIN_MEMBER(bool, json.points3),
           "write model coordinates beside those of the paper"),
      number("png.dpi", BURIN_MEMBER(double, png.dpi), 10, 4800, "pixels an inch"),
      {"png.background", "what is no ink",
       WordKey{BURIN_MEMBER(std::string, png.background), {"white", "transparent"}}},
      flag("dxf.splines", BURIN_MEMBER(bool, dxf.splines),
           "smooth curves as SPLINE, not as LWPOLYLINE; OpenSCAD reads no SPLINE"),
  };
}
#undef BURIN_MEMBER

std::vector<StyleKey> all_keys() {
  std::vector<StyleKey> keys;
  for (const auto& group :
       {line_keys(), feature_keys(), hatch_keys(), depth_keys(), other_keys()}) {
    keys.insert(keys.end(), group.begin(), group.end());
  }
  return keys;
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> to_number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

std::optional<Vec3> to_vector(std::string_view text) {
  Vec3 v(0);
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = i < 2 ? text.find(',') : text.size();
    if (comma == std::string_view::npos) return {};
    const auto x = to_number(text.substr(0, comma));
    if (!x) return {};
    v[i] = *x;
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  if (v == Vec3(0)) return {};
  return v;
}

std::optional<bool> to_flag(std::string_view text, const FlagKey& key) {
  if (text == key.on) return true;
  if (text == key.off) return false;
  if (text == "true") return true;
  if (text == "false") return false;
  if (text == "1" || text == "yes" || text == "on") return true;
  if (text == "0" || text == "no" || text == "off") return false;
  return {};
}

/// Sets the member; false where the text is none of what the key takes.
struct Set {
  Style& style;
  std::string_view text;

  bool operator()(const NumberKey& key) const {
    const auto x = to_number(text);
    if (!x || *x < key.low || *x > key.high) return false;
    key.member(style) = *x;
    return true;
  }
  bool operator()(const FlagKey& key) const {
    const auto on = to_flag(text, key);
    if (on) key.member(style) = *on;
    return on.has_value();
  }
  bool operator()(const WordKey& key) const {
    for (const std::string& word : key.words) {
      if (word != text) continue;
      key.member(style) = word;
      return true;
    }
    return false;
  }
  bool operator()(const VectorKey& key) const {
    const auto v = to_vector(text);
    if (v) key.member(style) = *v;
    return v.has_value();
  }
};

struct Takes {
  std::string operator()(const NumberKey& key) const {
    return fmt::format("{} to {}", key.low, key.high);
  }
  std::string operator()(const FlagKey& key) const {
    return fmt::format("{} or {}", key.on, key.off);
  }
  std::string operator()(const WordKey& key) const {
    std::string list;
    for (const std::string& word : key.words) list += (list.empty() ? "" : ", ") + word;
    return list;
  }
  std::string operator()(const VectorKey&) const { return "X,Y,Z"; }
};

struct Text {
  Style& style;

  std::string operator()(const NumberKey& key) const {
    return fmt::format("{}", key.member(style));
  }
  std::string operator()(const FlagKey& key) const {
    return std::string(key.member(style) ? key.on : key.off);
  }
  std::string operator()(const WordKey& key) const { return key.member(style); }
  std::string operator()(const VectorKey& key) const {
    const Vec3 v = key.member(style);
    return fmt::format("{},{},{}", v.x, v.y, v.z);
  }
};

}  // namespace

std::span<const StyleKey> style_table() {
  static const std::vector<StyleKey> keys = all_keys();
  return keys;
}

const StyleKey& find_key(std::string_view name) {
  std::vector<std::string> names;
  for (const StyleKey& key : style_table()) {
    if (key.name == name) return key;
    names.push_back(key.name);
  }
  throw UsageError(
      fmt::format("unknown style key '{}'; the nearest is '{}' (all: burin styles --keys)", name,
                  nearest(name, names)));
}

std::string takes(const StyleKey& key) { return std::visit(Takes{}, key.kind); }

void set_value(Style& style, const StyleKey& key, std::string_view text) {
  if (std::visit(Set{style, trimmed(text)}, key.kind)) return;
  throw UsageError(fmt::format("style key '{}' takes {}, not '{}'", key.name, takes(key), text));
}

std::string value_text(const Style& style, const StyleKey& key) {
  Style copy = style;  // members have one way in, for reading and writing
  return std::visit(Text{copy}, key.kind);
}

}  // namespace burin::detail
