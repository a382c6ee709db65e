#include "fill_changes.h"

#include <burin/base/box.h>
#include <burin/drawing/areas_at.h>
#include <burin/drawing/color.h>
#include <burin/drawing/ink.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

/// Paper mm between places that are compared.
constexpr double kStep = 0.5;
constexpr double kBorderWidth = 0.35;

/// What a drawing paints.
class Painted {
 public:
  explicit Painted(const Drawing& drawing)
      : drawing_(drawing),
        areas_(drawing.areas, kStep),
        paper_(rgb_of(drawing.paper_color).value_or(Rgb{255, 255, 255})) {}

  struct Layer {
    std::string fill;
    double opacity = 1;
    InkTint ink = {};
    std::int32_t part = -1;
    bool paints_as(const Layer& other) const {
      return fill == other.fill && opacity == other.opacity && ink == other.ink;
    }
  };
  struct Seen {
    /// Empty: nothing is painted.
    std::string color;
    InkTint ink = {};
    /// What is seen, glass over what stands behind it.
    std::vector<Layer> layers = {};
    bool looks_as(const Seen& other) const { return color == other.color && ink == other.ink; }
  };
  Seen at(Vec2 p) const {
    Seen seen;
    Rgb color = paper_;
    for (const std::size_t k : areas_.at(p)) {
      const Area& area = drawing_.areas[k];
      const auto fill = is_painted(area) ? rgb_of(area.fill) : std::nullopt;
      if (!fill) continue;
      color = over(*fill, area.opacity, color);
      seen.color = to_text(color);
      seen.ink = {area.ink, area.ink.empty() ? 1 : area.tint};
      if (area.opacity >= 1) seen.layers.clear();
      seen.layers.push_back({area.fill, area.opacity, seen.ink, area.part});
    }
    return seen;
  }
  /// Whether the colour is one within `reach`.
  bool even(Vec2 p, double reach, const Seen& seen) const {
    for (const Vec2 way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
      if (!at(p + reach * way).looks_as(seen)) return false;
    }
    return true;
  }
  /// The part of that layer from above; the last where there are fewer; empty: none.
  std::string part(const Seen& seen, std::size_t layer) const {
    if (seen.layers.empty()) return {};
    const std::size_t last = seen.layers.size() - 1;
    return part_name(drawing_, seen.layers[last - std::min(layer, last)].part);
  }

 private:
  const Drawing& drawing_;
  AreasAt areas_;
  Rgb paper_;
};

Box2 painted_box(const Drawing& drawing) {
  Box2 box;
  for (const Area& area : drawing.areas) {
    if (!is_painted(area)) continue;
    for (const std::vector<Vec2>& ring : area.rings) {
      for (const Vec2& p : ring) box.add(p);
    }
  }
  return box;
}

/// How many layers are the same from above: behind glass that has not changed is what has.
std::size_t same_layers(const Painted::Seen& a, const Painted::Seen& b) {
  const std::size_t most = std::min(a.layers.size(), b.layers.size());
  std::size_t same = 0;
  while (same < most && a.layers.rbegin()[same].paints_as(b.layers.rbegin()[same])) ++same;
  return same;
}

}  // namespace

std::string part_name(const Drawing& drawing, std::int32_t id) {
  const auto it = std::ranges::find(drawing.parts, id, &DrawingPart::id);
  return it == drawing.parts.end() ? std::string() : it->name;
}

std::vector<ChangedFill> compare_fills(const Drawing& before, const Drawing& after,
                                       double tolerance, const RunContext& context) {
  Box2 box = painted_box(before);
  const Box2 other = painted_box(after);
  if (!other.empty()) box.add(other);
  if (box.empty()) return {};
  const Painted was(before), is(after);
  std::map<std::tuple<std::string, std::string, std::string, InkTint, InkTint>, ChangedFill> found;
  for (double y = box.min.y + kStep / 2; y < box.max.y; y += kStep) {
    context.check();
    for (double x = box.min.x + kStep / 2; x < box.max.x; x += kStep) {
      const Vec2 p(x, y);
      const Painted::Seen a = was.at(p), b = is.at(p);
      if (a.looks_as(b)) continue;
      if (!was.even(p, tolerance, a) || !is.even(p, tolerance, b)) continue;
      const std::size_t same = same_layers(a, b);
      const bool gone = b.layers.size() <= same && a.layers.size() > same;
      const std::string part = gone ? was.part(a, same) : is.part(b, same);
      ChangedFill& fill = found[{part, a.color, b.color, a.ink, b.ink}];
      if (fill.size == 0) fill = {part, a.color, b.color, a.ink, b.ink, 0, p};
      fill.size += kStep * kStep;
    }
  }
  std::vector<ChangedFill> out;
  for (auto& [key, fill] : found) out.push_back(std::move(fill));
  std::ranges::stable_sort(out, [](const ChangedFill& a, const ChangedFill& b) {
    return std::tuple(a.part, -a.size) < std::tuple(b.part, -b.size);
  });
  return out;
}

std::vector<ChangedInk> compare_inks(const Drawing& before, const Drawing& after) {
  std::map<std::string, ChangedInk> inks;
  for (const SpotInk& ink : before.inks) inks[ink.name].before = ink.color;
  for (const SpotInk& ink : after.inks) inks[ink.name].after = ink.color;
  std::vector<ChangedInk> out;
  for (auto& [name, ink] : inks) {
    if (ink.before != ink.after) out.push_back({name, ink.before, ink.after});
  }
  return out;
}

FillPicture picture_of(const std::vector<ChangedFill>& fills, const Drawing& before,
                       const Drawing& after) {
  std::set<std::string> changed;
  for (const ChangedFill& fill : fills) changed.insert(fill.part);
  FillPicture out;
  const auto add_borders = [&](const Area& area, bool known) {
    for (const std::vector<Vec2>& ring : area.rings) {
      Path path;
      path.kind = LineClass::Frame;
      if (known) path.source.part = area.part;
      path.closed = true;
      path.points = ring;
      path.width = {kBorderWidth};
      out.borders.push_back(std::move(path));
    }
  };
  std::set<std::string> painted;
  for (const Area& area : after.areas) {
    const std::string part = part_name(after, area.part);
    if (!is_painted(area) || !changed.contains(part)) continue;
    painted.insert(part);
    out.areas.push_back(area);
    add_borders(area, true);
  }
  for (const Area& area : before.areas) {
    const std::string part = part_name(before, area.part);
    if (is_painted(area) && changed.contains(part) && !painted.contains(part)) {
      add_borders(area, false);  // parts of the new drawing have these numbers
    }
  }
  return out;
}

}  // namespace burin::detail
