#include <burin/area/largest_disc.h>
#include <burin/assembly/items.h>
#include <burin/base/box.h>
#include <burin/illustrate/legend.h>

#include "fills.h"
#include "hatch_areas.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace burin {
namespace {

using detail::Fills;
using detail::PartStyles;

/// The fills that areas of a part have in a drawing, by what stands for them in a legend.
class Shades {
 public:
  Shades(const Scene& scene, const Style& style, const IllustrateOptions& options)
      : part_styles_(scene, style, options),
        fills_(scene, part_styles_),
        paper_(rgb_of(style.sheet.paper).value_or(Rgb{255, 255, 255})),
        ground_(style.shadow.ground) {}

  bool lists(std::size_t part) const {
    return part_styles_.drawn(part) && part_styles_.style(part).fill.legend;
  }
  /// The squares of a part, that of the part itself first; those without a colour are left out.
  std::vector<Area> squares(std::size_t part) const {
    std::vector<Area> out;
    for (const std::string& color : fills_.colors(part)) {
      Area square = this->square(part, color);
      if (!square.fill.empty()) out.push_back(std::move(square));
    }
    return out;
  }
  /// What stands on the sheet for a square that has its rings: itself, or where tones differ by
  /// more than light, in the share of an ink or in hatching, each tone beside the others, the
  /// lightest first and to the left.
  std::vector<Area> steps_of(const Area& square) const {
    const auto part = static_cast<std::size_t>(square.part);
    const FillOptions& fill = part_styles_.style(part).fill;
    const bool hatched = fill.hatch.lines != FillHatch::Lines::None;
    if (fill.steps < 2 || part_styles_.transparent(part) || (fill.ink.empty() && !hatched)) {
      return {square};
    }
    std::vector<Area> out;
    for (const std::string& color : fills_.colors(part)) {
      if (this->square(part, color).fill != square.fill) continue;
      for (int tone = fill.steps - 1; tone >= 0; --tone) {
        Area step = square.opacity > 0 ? painted(part, color, tone) : square;
        step.tone = tone;
        step.role = square.role;
        step.rings = {stripe(square.rings.front(), fill, tone)};
        out.push_back(std::move(step));
      }
      break;
    }
    return out;
  }
  /// The colours of a part, of its faces too.
  std::vector<std::string> colors(std::size_t part) const { return fills_.colors(part); }
  /// All that a square of a part stands for.
  std::set<std::string> of(std::size_t part, const Area& square) const {
    std::set<std::string> out;
    for (const std::string& color : fills_.colors(part)) {
      if (this->square(part, color).fill != square.fill) continue;
      const int steps = std::max(2, part_styles_.style(part).fill.steps);
      for (int tone = -1; tone < steps; ++tone) {
        Area area = painted(part, color, tone);
        out.insert(area.fill);
        if (!ground_ || part_styles_.transparent(part)) continue;
        detail::settle_on(paper_, area);
        out.insert(area.fill);
      }
    }
    return out;
  }

 private:
  /// In full light, in which tints of all inks are nearly white: where there are darker ones, the
  /// square is all of the ink.
  Area square(std::size_t part, const std::string& color) const {
    const FillOptions& fill = part_styles_.style(part).fill;
    Area out = painted(part, color, !fill.ink.empty() && fill.steps > 1 ? 0 : -1);
    out.tone = -1;
    return out.fill.empty() ? hatched(std::move(out), color) : out;
  }
  /// The stripe of a tone, with those of the darker ones where these lie over it.
  static std::vector<Vec2> stripe(std::span<const Vec2> square, const FillOptions& fill, int tone) {
    Box2 box;
    for (const Vec2& p : square) box.add(p);
    const double width = box.size().x / fill.steps;
    const double right = detail::nests(fill) ? box.max.x : box.max.x - tone * width;
    const double left = box.max.x - (tone + 1) * width;
    return {{left, box.min.y}, {right, box.min.y}, {right, box.max.y}, {left, box.max.y}};
  }
  /// Of lines alone, all that the darkest tone has.
  Area hatched(Area square, const std::string& color) const {
    const auto part = static_cast<std::size_t>(square.part);
    detail::set_face_color(color, square);
    square.fill = detail::hatch_color(fills_, part_styles_, part, square.fill);
    square.opacity = 0;
    square.tone = 0;
    return square;
  }
  Area painted(std::size_t part, const std::string& color, int tone) const {
    Area area{.part = static_cast<std::int32_t>(part), .tone = tone, .rings = {}};
    detail::set_face_color(color, area);
    fills_.paint(area);
    return area;
  }

  PartStyles part_styles_;
  Fills fills_;
  Rgb paper_;
  bool ground_;
};

/// Whether an area is as wide as a pen anywhere: all of a narrower one may lie under lines.
bool is_wide(const Area& area, double pen) {
  std::vector<BorderSide> sides;
  for (const std::vector<Vec2>& ring : area.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
  }
  const double enough = 0.5 * pen;
  return largest_disc(sides, {}, {.precision = 0.02 * pen, .enough = enough}).radius >= enough;
}

/// The name of an item's row for a part: its own where listed parts of the item have different
/// colours and names, so that each row tells which it is of; without the number that readers add,
/// as lists have it.
std::string_view row_name(const Scene& scene, const Shades& shades, const DrawingItem& item,
                          std::size_t part) {
  const std::string_view own = name_as_read(scene.parts[part].name);
  const auto differs = [&](std::int32_t other) {
    const auto i = static_cast<std::size_t>(other);
    return shades.lists(i) && shades.colors(i) != shades.colors(part) &&
           name_as_read(scene.parts[i].name) != own;
  };
  return std::ranges::any_of(item.parts, differs) ? own : item.name;
}

/// Whether any area, or its hatching, is one that a row stands for.
bool is_seen(const LegendRow& row, std::span<const DrawingItem> items, const Shades& shades,
             const Drawing& drawing, double pen) {
  std::set<std::int32_t> parts;
  for (const DrawingItem& item : items) {
    if (item.number != row.item) continue;
    for (const std::int32_t part : item.parts) {
      if (shades.lists(static_cast<std::size_t>(part))) parts.insert(part);
    }
  }
  if (row.square.opacity <= 0) {
    const auto layer = std::ranges::find(drawing.layers, "fill-hatch", &Layer::name);
    return layer != drawing.layers.end() &&
           std::ranges::any_of(layer->paths, [&](const Path& line) {
             return line.color == row.square.fill && parts.contains(line.source.part);
           });
  }
  std::map<std::int32_t, std::set<std::string>> known;
  return std::ranges::any_of(drawing.areas, [&](const Area& area) {
    if (!area.role.empty() || area.fill.empty() || !parts.contains(area.part)) return false;
    const auto [at, fresh] = known.try_emplace(area.part);
    if (fresh) at->second = shades.of(static_cast<std::size_t>(area.part), row.square);
    return at->second.contains(area.fill) && is_wide(area, pen);
  });
}

}  // namespace

void detail::divide_squares(const Scene& scene, const Style& style,
                            const IllustrateOptions& options, Drawing& drawing) {
  const Shades shades(scene, style, options);
  std::vector<Area> out;
  for (Area& area : drawing.areas) {
    if (area.role != "legend") {
      out.push_back(std::move(area));
      continue;
    }
    std::ranges::move(shades.steps_of(area), std::back_inserter(out));
  }
  drawing.areas = std::move(out);
}

std::vector<LegendRow> legend_rows(const Scene& scene, const Style& style,
                                   const IllustrateOptions& options,
                                   std::span<const DrawingItem> items) {
  const Shades shades(scene, style, options);
  std::vector<LegendRow> rows;
  for (const DrawingItem& item : items) {
    std::set<std::string> fills;  // of the item
    for (const std::int32_t part : item.parts) {
      const auto i = static_cast<std::size_t>(part);
      if (!shades.lists(i)) continue;
      for (Area& square : shades.squares(i)) {
        if (!fills.insert(square.fill).second) continue;
        rows.push_back(
            {item.number, std::string(row_name(scene, shades, item, i)), std::move(square)});
      }
    }
  }
  return rows;
}

Annotations with_seen_rows(const Scene& scene, const Style& style, const IllustrateOptions& options,
                           const Drawing& drawing) {
  if (!options.annotations) return {};
  Annotations out = *options.annotations;
  if (out.legend.empty()) return out;
  const Shades shades(scene, style, options);
  for (LegendRow& row : out.legend) {
    row.seen = is_seen(row, out.items, shades, drawing, style.line.crease);
  }
  return out;
}

}  // namespace burin
