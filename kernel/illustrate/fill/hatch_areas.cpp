#include "hatch_areas.h"

#include <burin/drawing/hatch_rings.h>

#include "fills.h"

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

/// Areas of one part and face.
using Group = std::vector<const Area*>;

/// Those that have lines of a direction: of nested ones the outermost.
Group hatched(const Group& group, const FillOptions& fill, int direction) {
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

class Hatcher {
 public:
  Hatcher(const Style& style, std::string color) : fill_(style.fill), color_(std::move(color)) {}

  void add(const Group& group, Layer& layer) const {
    for (int k = 0; k < static_cast<int>(kDirections.size()); ++k) {
      const auto& [turned, wider] = kDirections[static_cast<std::size_t>(k)];
      const double angle = fill_.hatch.angle + turned, distance = wider * fill_.hatch.distance;
      for (const Area* area : hatched(group, fill_, k)) {
        for (const auto& [a, b] : hatch_rings(area->rings, angle, distance)) {
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
};

/// Empty where it is that of the sheet's ink.
std::string line_color(const Style& style, const std::string& fill, const std::string& ink) {
  const std::string& own = style.fill.hatch.color;
  const std::string& color = own == "fill" ? fill : own.empty() ? style.line.color : own;
  return color == ink ? std::string() : color;
}

}  // namespace

bool hatches(const PartStyles& part_styles) {
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    const bool any = part_styles.style(i).fill.hatch.lines != FillHatch::Lines::None;
    if (part_styles.drawn(i) && any) return true;
  }
  return false;
}

void hatch_areas(const Scene& scene, const PartStyles& part_styles, std::string_view role,
                 Drawing& drawing, const RunContext& context) {
  if (!hatches(part_styles)) return;
  std::map<std::pair<std::int32_t, std::int32_t>, Group> groups;
  for (const Area& area : drawing.areas) {
    if (area.part >= 0 && area.role == role) groups[{area.part, area.face}].push_back(&area);
  }
  const Fills fills(scene, part_styles);
  Layer layer{kLayer, {}};
  for (const auto& [key, group] : groups) {
    context.check();
    const auto part = static_cast<std::size_t>(key.first);
    const Style& style = part_styles.style(part);
    Hatcher(style, line_color(style, fills.color(part), drawing.ink_color)).add(group, layer);
  }
  if (layer.paths.empty()) return;
  const auto known = std::ranges::find(drawing.layers, layer.name, &Layer::name);
  if (known == drawing.layers.end()) {
    drawing.layers.insert(drawing.layers.begin(), std::move(layer));
  } else {
    std::ranges::move(layer.paths, std::back_inserter(known->paths));
  }
}

}  // namespace burin::detail
