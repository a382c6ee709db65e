#include "hatch_areas.h"

#include <burin/drawing/hatch_rings.h>
#include <burin/drawing/ink.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

constexpr const char* kLayer = "fill-hatch";
/// Degrees from the first direction of lines, the darker the more of them, and their distance. All
/// pass through the crossings of the first two, so that no beat shows.
struct Direction {
  double turned, distance;
};
constexpr std::array kDirections = {Direction{0, 1}, Direction{90, 1},
                                    Direction{45, std::numbers::sqrt2},
                                    Direction{135, std::numbers::sqrt2}};

/// The step of an area, from the darkest; what has none is in full light. Where shadows are cast,
/// parts without steps have two.
int step_of(const Area& area, const FillOptions& fill) {
  if (area.tone >= 0) return area.tone;
  return fill.steps < 2 ? 0 : fill.steps - 1;
}

/// Directions of lines that an area of a step has.
int directions(const FillOptions& fill, int step) {
  const FillHatch& hatch = fill.hatch;
  if (hatch.lines == FillHatch::Lines::None || step >= hatch.tones) return 0;
  if (hatch.lines == FillHatch::Lines::Lines) return 1;
  return fill.steps < 2 ? 2 : std::min(hatch.tones - step, static_cast<int>(kDirections.size()));
}

/// Areas of one part, face and colour.
using Group = std::vector<const Area*>;
using Rings = std::vector<std::vector<Vec2>>;

/// Those that have lines of a direction: of nested ones the outermost.
Group hatched_group(const Group& group, const FillOptions& fill, int direction) {
  Group out;
  for (const Area* area : group) {
    if (directions(fill, step_of(*area, fill)) > direction) out.push_back(area);
  }
  if (!nests(fill) || out.empty()) return out;
  const auto step = [&](const Area* area) { return step_of(*area, fill); };
  const int lightest = step(*std::ranges::max_element(out, {}, step));
  std::erase_if(out, [&](const Area* area) { return step(area) < lightest; });
  return out;
}

/// The area of a group that holds all of it, where areas nest.
const Area& whole_of(const Group& group, const FillOptions& fill) {
  return **std::ranges::max_element(group, {},
                                    [&](const Area* area) { return step_of(*area, fill); });
}

class Hatcher {
 public:
  /// `over`: what lies over all of a group.
  Hatcher(const Style& style, std::string color, Rings over)
      : fill_(style.fill), color_(std::move(color)), over_(std::move(over)) {}

  void add(const Group& group, Layer& layer) const {
    const Area& whole = whole_of(group, fill_);
    for (int k = 0; k < static_cast<int>(kDirections.size()); ++k) {
      const auto& [turned, wider] = kDirections[static_cast<std::size_t>(k)];
      const double angle = fill_.hatch.angle + turned, distance = wider * fill_.hatch.distance;
      for (const Area* area : hatched_group(group, fill_, k)) {
        Rings rings = area->rings;
        if (area == &whole) rings.insert(rings.end(), over_.begin(), over_.end());
        for (const auto& [a, b] : hatch_rings(rings, angle, distance)) {
          Path& line = layer.paths.emplace_back();
          line.kind = LineClass::Pattern;
          line.source.part = area->part;
          line.source.face = area->face;
          line.points = {a, b};
          line.width = {fill_.hatch.width};
          line.color = color_;
        }
      }
    }
  }

 private:
  const FillOptions& fill_;
  std::string color_;
  Rings over_;
};

/// Whether lines are printed in the spot ink of their part.
bool are_in_spot_ink(const Style& style) {
  return style.fill.hatch.color == "fill" && !style.fill.ink.empty();
}

/// Squares of a legend that stand for lines alone.
void clear_squares(std::string_view role, std::vector<Area>& areas) {
  for (Area& area : areas) {
    if (role != "legend" || area.role != role || area.opacity > 0) continue;
    area.fill.clear();
    area.opacity = 1;
    area.tone = -1;
  }
}

}  // namespace

bool hatches(const PartStyles& part_styles) {
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    const bool any = part_styles.style(i).fill.hatch.lines != FillHatch::Lines::None;
    if (part_styles.drawn(i) && any) return true;
  }
  return false;
}

std::string hatch_color(const Fills& fills, const PartStyles& part_styles, std::size_t part,
                        const std::string& color) {
  const Style& style = part_styles.style(part);
  const FillHatch& hatch = style.fill.hatch;
  if (hatch.lines == FillHatch::Lines::None || part_styles.transparent(part)) return {};
  if (are_in_spot_ink(style)) return fills.color(part);  // an ink shows no colours of faces
  const std::string own = hatch.color == "fill" ? fills.lit(part, color)
                          : hatch.color.empty() ? style.line.color
                                                : hatch.color;
  return own == part_styles.styles().front()->sheet.ink ? std::string() : own;
}

void hatch_areas(const Scene& scene, const PartStyles& part_styles, std::string_view role,
                 Drawing& drawing, const RunContext& context) {
  if (!hatches(part_styles)) return;
  const Fills fills(scene, part_styles);
  // By part and face, and there by colour.
  std::map<std::pair<std::int32_t, std::int32_t>, std::map<std::string, Group>> faces;
  for (const Area& area : drawing.areas) {
    if (area.part < 0 || area.role != role) continue;
    if (part_styles.transparent(static_cast<std::size_t>(area.part))) continue;
    faces[{area.part, area.face}][fills.color(area)].push_back(&area);
  }
  Layer layer{kLayer, {}};
  for (const auto& [key, groups] : faces) {
    const auto part = static_cast<std::size_t>(key.first);
    const Style& style = part_styles.style(part);
    const std::string own = fills.color(part);
    const std::size_t before = layer.paths.size();
    // The colour of a part goes on below those of its faces.
    Rings over;
    const bool below = role.empty() && nests(style.fill);
    for (const auto& [color, group] : groups) {
      if (!below || color == own) continue;
      const Rings& rings = whole_of(group, style.fill).rings;
      over.insert(over.end(), rings.begin(), rings.end());
    }
    for (const auto& [color, group] : groups) {
      context.check();
      Hatcher(style, hatch_color(fills, part_styles, part, color), color == own ? over : Rings())
          .add(group, layer);
    }
    if (layer.paths.size() > before && are_in_spot_ink(style))
      add_ink(style.fill.ink, own, drawing);
  }
  clear_squares(role, drawing.areas);
  if (layer.paths.empty()) return;
  const auto known = std::ranges::find(drawing.layers, layer.name, &Layer::name);
  if (known == drawing.layers.end()) {
    drawing.layers.insert(drawing.layers.begin(), std::move(layer));
  } else {
    std::ranges::move(layer.paths, std::back_inserter(known->paths));
  }
}

}  // namespace burin::detail
