#include "svg_areas.h"

#include <burin/drawing/bezier.h>
#include <burin/drawing/ink.h>

#include "svg_path.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// What the names of custom properties begin with.
constexpr std::string_view kCustom = "--";

/// The custom property of an area's colour. `color`: as SvgAreaClasses has it.
std::string property_of(const Area& area, std::size_t color) {
  if (area.part < 0) return fmt::format("{}shadow", kCustom);
  std::string name = fmt::format("{}part-{}", kCustom, area.part);
  if (area.tone >= 0) name += fmt::format("-tone-{}", area.tone);
  if (color > 0) name += fmt::format("-color-{}", color + 1);
  return name;
}

/// Letters of annotations are ink; its colour is that of lines.
bool is_ink(const Area& area) { return area.role == "pmi"; }

/// Signs keep their colours whatever a page does.
bool is_symbol(const Area& area) { return area.role == "symbol"; }

/// "part_0 tone_1" as ".part_0.tone_1".
std::string selector_of(const std::string& classes) {
  std::string selector = "." + classes;
  for (char& c : selector) {
    if (c == ' ') c = '.';
  }
  return selector;
}

}  // namespace

SvgAreaClasses::SvgAreaClasses(const Drawing& drawing) {
  for (const Area& area : drawing.areas) {
    if (!is_painted(area) || is_ink(area) || is_symbol(area)) continue;
    auto& known = colors_[{area.part, area.tone}];
    if (std::ranges::find(known, area.fill) == known.end()) known.push_back(area.fill);
  }
}

std::size_t SvgAreaClasses::color(const Area& area) const {
  const auto found = colors_.find({area.part, area.tone});
  if (found == colors_.end()) return 0;
  const auto& known = found->second;
  const auto it = std::ranges::find(known, area.fill);
  return it == known.end() ? 0 : static_cast<std::size_t>(it - known.begin());
}

std::string SvgAreaClasses::of(const Area& area) const {
  if (area.fill.empty()) return {};
  if (is_ink(area) || is_symbol(area)) return area.role;
  if (area.part < 0) return "shadow";
  std::string name = fmt::format("part_{}", area.part);
  if (area.tone >= 0) name += fmt::format(" tone_{}", area.tone);
  if (const std::size_t k = color(area); k > 0) name += fmt::format(" color_{}", k + 1);
  return name;
}

void append_area_fill(Buffer& out, const Area& area) {
  if (!is_painted(area)) return;
  append(out, fmt::format(" fill=\"{}\"", area.fill));
  if (area.opacity < 1) {
    append(out, fmt::format(" fill-opacity=\"{:.4g}\"", area.opacity));
  } else {
    append(out, fmt::format(" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
                            area.fill, kTrap));
  }
  if (area.part >= 0) append(out, fmt::format(" data-part=\"{}\"", area.part));
  if (area.face >= 0) append(out, fmt::format(" data-face=\"{}\"", area.face));
  if (area.tone >= 0) append(out, fmt::format(" data-tone=\"{}\"", area.tone));
  if (!area.ink.empty()) {
    append(out, " data-ink=\"");
    append_xml(out, area.ink);
    append(out, fmt::format("\" data-tint=\"{:.4g}\"", area.tint));
  }
}

void append_area_rings(Buffer& out, const Area& area, double paper_height) {
  SvgPen pen(out, paper_height);
  for (const std::vector<Vec2>& ring : area.rings) {
    std::vector<CubicBezier> chain;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      chain.push_back({a, glm::mix(a, b, 1.0 / 3), glm::mix(a, b, 2.0 / 3), b});
    }
    pen.chain(chain, true);
  }
}

std::string svg_area_rules(const Drawing& drawing, const SvgAreaClasses& classes,
                           std::string_view id, std::string_view ink) {
  // One of each class, those without a tone or a further colour first: none comes before another by
  // its selector.
  std::map<std::tuple<std::size_t, std::int32_t, std::int32_t>, const Area*> rules;
  std::map<std::int32_t, std::int32_t> lightest;
  for (const Area& area : drawing.areas) {
    if (!is_painted(area) || is_ink(area) || is_symbol(area)) continue;
    rules.try_emplace({classes.color(area), area.tone, area.part}, &area);
    auto& tone = lightest.try_emplace(area.part, area.tone).first->second;
    tone = std::max(tone, area.tone);
  }
  if (rules.empty()) return {};
  Buffer out;
  for (const auto& [key, area] : rules) {
    const std::size_t number = std::get<0>(key);
    const bool of_part = number == 0 && area->tone >= 0 && area->tone == lightest[area->part];
    const std::string plain =
        of_part ? fmt::format("var({}part-{},{})", kCustom, area->part, area->fill) : area->fill;
    const std::string color = fmt::format("var({},{})", property_of(*area, number), plain);
    append(out, fmt::format(":where(#{} {}){{fill:{}", id, selector_of(classes.of(*area)), color));
    if (area->opacity >= 1) append(out, fmt::format(";stroke:{}", color));
    append(out, "}\n");
  }
  append(out, fmt::format(":where(#{0}~g[stroke=\"{1}\"],#{0}~g [stroke=\"{1}\"])"
                          "{{stroke:var({2}ink,{1})}}\n"
                          ":where(#{0}~g [fill=\"{1}\"]){{fill:var({2}ink,{1})}}\n",
                          id, ink, kCustom));
  return fmt::format("<style>@supports (fill:var({}ink)){{\n{}}}</style>\n", kCustom,
                     fmt::to_string(out));
}

}  // namespace burin
