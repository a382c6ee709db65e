#include "fills.h"

#include <burin/assembly/items.h>
#include <burin/drawing/color.h>

#include <algorithm>
#include <array>
#include <map>
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
/// Lightness of the second round through the palette, as a share of that of the first.
constexpr double kNextRound = 0.85;
/// Opacity of a part that is drawn as of glass though its input says nothing of it.
constexpr double kGlass = 0.25;

// What copies of a part have in common, whatever they are called.
std::string kind_of(const Part& part) {
  return std::string(instance_stem(part.definition.empty() ? part.name : part.definition));
}

/// A colour for each part that the input gives none.
std::vector<std::string> colors_of(const Scene& scene) {
  std::map<std::string, std::size_t> kinds;
  std::vector<std::string> colors;
  for (const Part& part : scene.parts) {
    if (!part.color.empty()) {
      colors.push_back(part.color);
      continue;
    }
    const std::size_t number = kinds.try_emplace(kind_of(part), kinds.size()).first->second;
    Rgb color = kPalette[number % kPalette.size()];
    for (std::size_t round = number / kPalette.size(); round > 0; --round) {
      color = with_lightness(color, kNextRound);
    }
    colors.push_back(to_text(color));
  }
  return colors;
}

double opacity_of(const Part& part, const FillOptions& fill, bool transparent) {
  if (!transparent) return fill.opacity;
  return fill.opacity * (part.opacity < 1 ? part.opacity : kGlass);
}

std::string toned(const std::string& color, const FillOptions& fill, std::int32_t tone) {
  if (tone < 0 || fill.steps < 2) return color;
  const double light = std::min(1.0, static_cast<double>(tone) / (fill.steps - 1));
  const auto rgb = rgb_of(color);
  if (!rgb || light >= 1) return color;
  return to_text(with_lightness(*rgb, fill.darkest + (1 - fill.darkest) * light));
}

}  // namespace

bool paints(const PartStyles& part_styles) {
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    const FillOptions& fill = part_styles.style(i).fill;
    if (part_styles.drawn(i) && fill.color != "none" && fill.opacity > 0) return true;
  }
  return false;
}

void paint_areas(const Scene& scene, const PartStyles& part_styles, std::vector<Area>& areas) {
  const std::vector<std::string> own = colors_of(scene);
  for (Area& area : areas) {
    const auto part = static_cast<std::size_t>(area.part);
    const FillOptions& fill = part_styles.style(part).fill;
    if (fill.color == "none" || fill.opacity <= 0) continue;
    // That of faces which are coloured otherwise than their part is known by now.
    const std::string& of_part = area.fill.empty() ? own[part] : area.fill;
    area.fill = toned(fill.color == "part" ? of_part : fill.color, fill, area.tone);
    area.opacity = opacity_of(scene.parts[part], fill, part_styles.transparent(part));
  }
  // Glass comes first, the foremost before what is seen through it; it is painted last.
  const auto is_glass = [&](const Area& area) {
    return part_styles.transparent(static_cast<std::size_t>(area.part));
  };
  const auto solid = std::stable_partition(areas.begin(), areas.end(),
                                           [&](const Area& area) { return !is_glass(area); });
  std::reverse(solid, areas.end());
}

void lay_shadow(Area shadow, const Style& style, const PartStyles& part_styles,
                std::vector<Area>& areas) {
  constexpr double kDarker = 0.86;  // lightness, as a share of that of the paper
  const Rgb paper = rgb_of(style.sheet.paper).value_or(Rgb{255, 255, 255});
  for (Area& area : areas) {
    const bool glass = part_styles.transparent(static_cast<std::size_t>(area.part));
    const auto fill = rgb_of(area.fill);
    if (glass || !fill || area.opacity >= 1) continue;
    area.fill = to_text(over(*fill, area.opacity, paper));
    area.opacity = 1;
  }
  shadow.fill =
      style.shadow.color.empty() ? to_text(with_lightness(paper, kDarker)) : style.shadow.color;
  areas.insert(areas.begin(), std::move(shadow));
}

}  // namespace burin::detail
