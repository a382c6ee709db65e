#include "fills.h"

#include <burin/assembly/items.h>
#include <burin/drawing/ink.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>
#include <string>

namespace burin::detail {
namespace {

/// The scheme "light" of Paul Tol: backgrounds on which black lines and letters are read.
constexpr std::array<Rgb, 9> kPalette{{{0x77, 0xAA, 0xDD},
                                       {0xEE, 0xDD, 0x88},
                                       {0x44, 0xBB, 0x99},
                                       {0xEE, 0x88, 0x66},
                                       {0xDD, 0xDD, 0xDD},
                                       {0xFF, 0xAA, 0xBB},
                                       {0xBB, 0xCC, 0x33},
                                       {0x99, 0xDD, 0xFF},
                                       {0xAA, 0xAA, 0x00}}};
/// Lightness of the next round through the palette, as a share of that of the one before; after
/// three rounds the colours come again: darker ones would all be grey.
constexpr double kNextRound = 0.85;
constexpr std::size_t kRounds = 3;
/// Opacity of a part that is drawn as of glass though its input says nothing of it.
constexpr double kGlass = 0.25;
constexpr Rgb kWhite{255, 255, 255};

/// A colour for each part that the input gives none.
std::vector<std::string> colors_of_parts(const Scene& scene) {
  std::map<std::pair<std::string, std::size_t>, std::size_t> kinds;
  std::vector<std::string> colors;
  for (const Part& part : scene.parts) {
    if (!part.color.empty()) {
      colors.push_back(part.color);
      continue;
    }
    const std::size_t number =
        kinds.try_emplace({stem_of(part), part.shape_of_name}, kinds.size()).first->second;
    Rgb color = kPalette[number % kPalette.size()];
    for (std::size_t round = number / kPalette.size() % kRounds; round > 0; --round) {
      color = with_lightness(color, kNextRound);
    }
    colors.push_back(to_text(color));
  }
  return colors;
}

/// "#rrggbb" and, of glass, two digits of opacity behind it.
constexpr std::size_t kOpaqueColor = 7;
bool says_opacity(const std::string& color) { return color.size() > kOpaqueColor; }

/// `own`: of the face.
double opacity_of(const Part& part, double own, const FillOptions& fill, bool transparent) {
  if (!transparent) return fill.opacity;
  return fill.opacity * (own < 1 ? own : part.opacity < 1 ? part.opacity : kGlass);
}

/// From 0, the darkest tone, to 1. Without steps of their own parts have two where shadows are
/// cast.
double light_of(const FillOptions& fill, std::int32_t tone) {
  if (tone < 0) return 1;
  return std::min(1.0, static_cast<double>(tone) / std::max(1, fill.steps - 1));
}

/// Whether parts and faces have the colours of the input, rather than one that was named.
bool is_own(const FillOptions& fill) { return fill.color == "part" && fill.ink.empty(); }

/// That faces which are coloured otherwise than their part are printed as the part is.
void tell_of_faces(const Fills& fills, const PartStyles& part_styles, Drawing& drawing) {
  std::map<std::string, std::set<std::int32_t>> inks;
  for (const Area& area : drawing.areas) {
    const auto part = static_cast<std::size_t>(area.part);
    const FillOptions& fill = part_styles.style(part).fill;
    if (area.fill.empty() || fill.color != "part" || fill.ink.empty()) continue;
    if (area.fill != fills.color(part)) inks[fill.ink].insert(area.part);
  }
  for (const auto& [ink, parts] : inks) {
    drawing.diagnostics.add(
        Severity::Warning, "fill.ink_faces", static_cast<std::int64_t>(parts.size()),
        fmt::format("{} part{} faces with colours of their own, which the spot ink '{}' (fill.ink) "
                    "cannot show: they are tints of it like the rest of their part",
                    parts.size(), parts.size() == 1 ? " has" : "s have", ink));
  }
}

/// That lines are hardly seen on colours that were named, and so stay as they are, or through which
/// the paper is seen.
void tell_of_contrast(const Scene& scene, const Fills& fills, const PartStyles& part_styles,
                      Drawing& drawing) {
  constexpr double kHidden = 2;  // contrast under which lines can hardly be seen
  const Rgb paper = rgb_of(part_styles.styles().front()->sheet.paper).value_or(kWhite);
  std::map<std::int32_t, std::pair<double, std::string>> worst;
  for (const Area& area : drawing.areas) {
    const auto part = static_cast<std::size_t>(area.part);
    const auto rgb = rgb_of(area.fill);
    const bool readable = is_own(part_styles.style(part).fill) && area.opacity >= 1;
    if (!rgb || part_styles.transparent(part) || readable) continue;
    const double is = contrast(over(*rgb, area.opacity, paper), fills.ink_of(part));
    if (is >= kHidden) continue;
    const auto [at, fresh] = worst.try_emplace(area.part, is, area.fill);
    if (is < at->second.first) at->second = {is, area.fill};
  }
  if (worst.empty()) return;
  const auto& [first, found] = *worst.begin();
  const auto part = static_cast<std::size_t>(first);
  drawing.diagnostics.add(
      Severity::Warning, "fill.low_contrast", static_cast<std::int64_t>(worst.size()),
      fmt::format("lines can hardly be seen on {}'{}': {} on {} has a contrast of {:.1f}; choose "
                  "another line.color or fill.color{}",
                  worst.size() == 1 ? "" : "parts such as ", scene.parts[part].name,
                  to_text(fills.ink_of(part)), found.second, found.first,
                  part_styles.style(part).fill.steps > 1 ? ", or a larger tone.darkest" : ""));
}

/// The colours of all inks that areas are printed in, those of one ink once.
void collect_inks(const Fills& fills, Drawing& drawing) {
  std::map<std::string, std::set<std::string>> colors;
  for (const Area& area : drawing.areas) {
    if (area.ink.empty()) continue;
    const std::string color = fills.color(static_cast<std::size_t>(area.part));
    add_ink(area.ink, color, drawing);
    colors[area.ink].insert(color);
  }
  for (const auto& [ink, known] : colors) {
    // In PDF it is the name of the plate that lines are on.
    const bool as_lines = ink == "Black" && !is_grey(rgb_of(*known.begin()).value_or(Rgb{}));
    if (as_lines) {
      drawing.diagnostics.add(
          Severity::Warning, "fill.ink_black", 1,
          fmt::format("the ink 'Black' (fill.ink) is that of the lines and prints black, not {}: "
                      "give the spot ink another name",
                      *known.begin()));
    }
    if (known.size() < 2) continue;
    drawing.diagnostics.add(
        Severity::Warning, "fill.ink_colors", static_cast<std::int64_t>(known.size()),
        fmt::format("the spot ink '{}' (fill.ink) has {} colours; a plate has one: give "
                    "fill.color one colour, or each colour an ink of its own",
                    ink, known.size()));
  }
}

std::string shadow_color(const Style& style) {
  constexpr double kDarker = 0.86;  // lightness, as a share of that of the paper
  if (!style.shadow.color.empty()) return style.shadow.color;
  return to_text(with_lightness(rgb_of(style.sheet.paper).value_or(kWhite), kDarker));
}

}  // namespace

Fills::Fills(const Scene& scene, const PartStyles& part_styles)
    : scene_(scene),
      part_styles_(part_styles),
      own_(colors_of_parts(scene)),
      paper_(rgb_of(part_styles.styles().front()->sheet.paper).value_or(kWhite)) {}

std::string Fills::color(std::size_t part) const {
  const FillOptions& fill = part_styles_.style(part).fill;
  if (fill.color == "none") return {};
  return fill.color == "part" ? own_[part] : fill.color;
}

std::string Fills::color(const Area& area) const {
  const auto part = static_cast<std::size_t>(area.part);
  if (area.fill.empty() || part_styles_.style(part).fill.color != "part") return color(part);
  if (area.role.empty()) return area.fill;
  for (const std::string& one : colors(part)) {
    Area painted{.part = area.part, .tone = area.tone, .rings = {}};
    set_face_color(one, painted);
    std::string base = painted.fill;
    paint(painted);
    // What is hatched alone has the colour of its lines.
    if ((area.opacity > 0 ? painted.fill : lit(part, base)) == area.fill) return base;
  }
  return color(part);
}

std::vector<std::string> Fills::colors(std::size_t part) const {
  std::vector<std::string> out{color(part)};
  const auto& faces = scene_.parts[part].face_colors;
  if (faces && part_styles_.style(part).fill.color == "part") {
    out.insert(out.end(), faces->colors.begin(), faces->colors.end());
  }
  return out;
}

void Fills::paint(Area& area) const {
  const auto part = static_cast<std::size_t>(area.part);
  const FillOptions& fill = part_styles_.style(part).fill;
  // That of faces which are coloured otherwise than their part is known by now. An ink has one.
  if (!is_own(fill) || area.fill.empty()) area.fill = color(part);
  const auto rgb = rgb_of(area.fill);
  if (!rgb || fill.opacity <= 0) {
    area.fill.clear();
    return;
  }
  const Tones tones = tones_of(part, *rgb);
  const double light = light_of(fill, area.tone);
  area.opacity = opacity_of(scene_.parts[part], area.opacity, fill, part_styles_.transparent(part));
  if (!fill.ink.empty()) {
    area.ink = fill.ink;
    // Glass has no tones: it has the mean of them, or it would hardly be seen.
    const double tone = fill.steps > 1 && part_styles_.transparent(part) ? 0.5 : light;
    area.tint = 1 - tone * (1 - fill.tint);
    area.fill = to_text(over(*rgb, area.tint, paper_));
  } else {
    const double share = tones.darkest + (1 - tones.darkest) * light;
    area.fill = to_text(light < 1 ? with_lightness(tones.light, share) : tones.light);
  }
}

std::string Fills::lit(std::size_t part, const std::string& color) const {
  const auto rgb = rgb_of(color);
  return rgb ? to_text(tones_of(part, *rgb).light) : color;
}

Tones Fills::tones_of(std::size_t part, const Rgb& color) const {
  const FillOptions& fill = part_styles_.style(part).fill;
  // Where shadows are cast all parts have a dark tone.
  const bool toned = fill.steps > 1 || part_styles_.styles().front()->shadow.cast;
  const Tones tones{color, toned ? fill.darkest : 1};
  return is_own(fill) ? readable(tones, ink_of(part)) : tones;
}

Rgb Fills::ink_of(std::size_t part) const {
  return line_ink(part_styles_.style(part), *part_styles_.styles().front());
}

void set_face_color(const std::string& color, Area& area) {
  area.fill = color.substr(0, kOpaqueColor);
  if (!says_opacity(color)) return;
  int share = 255;
  std::from_chars(color.data() + kOpaqueColor, color.data() + color.size(), share, 16);
  area.opacity = std::clamp(share, 0, 255) / 255.0;
}

bool has_solid_glass(const Part& part) {
  return part.opacity >= 1 && part.face_colors &&
         std::ranges::any_of(part.face_colors->colors, says_opacity);
}

bool nests(const FillOptions& fill) {
  return fill.opacity >= 1 || fill.opacity <= 0 || fill.color == "none";
}

bool paints(const PartStyles& part_styles) {
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    const FillOptions& fill = part_styles.style(i).fill;
    if (part_styles.drawn(i) && fill.color != "none" && fill.opacity > 0) return true;
  }
  return false;
}

void paint_areas(const Scene& scene, const PartStyles& part_styles, Drawing& drawing) {
  const Fills fills(scene, part_styles);
  std::vector<Area>& areas = drawing.areas;
  tell_of_faces(fills, part_styles, drawing);
  for (Area& area : areas) fills.paint(area);
  tell_of_contrast(scene, fills, part_styles, drawing);
  collect_inks(fills, drawing);
  // Glass comes first, the foremost before what is seen through it; it is painted last.
  const auto is_glass = [&](const Area& area) {
    return part_styles.transparent(static_cast<std::size_t>(area.part));
  };
  const auto solid = std::stable_partition(areas.begin(), areas.end(),
                                           [&](const Area& area) { return !is_glass(area); });
  std::reverse(solid, areas.end());
}

void shade_areas(const Style& style, std::vector<Area>& areas) {
  for (Area& area : areas) {
    if (area.tone == 0 && area.fill.empty()) area.fill = shadow_color(style);
  }
}

void settle_on(const Rgb& paper, Area& area) {
  const auto fill = rgb_of(area.fill);
  if (fill && area.opacity >= 1) return;
  area.fill = to_text(fill ? over(*fill, area.opacity, paper) : paper);
  area.tint *= area.opacity;
  area.opacity = 1;
}

void lay_shadow(Area shadow, const Style& style, const PartStyles& part_styles,
                std::vector<Area>& areas) {
  const Rgb paper = rgb_of(style.sheet.paper).value_or(kWhite);
  for (Area& area : areas) {
    if (part_styles.transparent(static_cast<std::size_t>(area.part))) continue;
    settle_on(paper, area);
  }
  shadow.fill = shadow_color(style);
  areas.insert(areas.begin(), std::move(shadow));
}

}  // namespace burin::detail
