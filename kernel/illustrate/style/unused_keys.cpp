#include <burin/illustrate/unused_keys.h>

#include "style_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace burin {
namespace {

using detail::KeyPlace;

/// As rows call it: keys of the first kind of strokes have two names.
std::string row_of_key(std::string_view key) {
  const auto kind = detail::kind_key(key);
  if (!kind || kind->number > 1) return std::string(key);
  return kind->name.starts_with("tone.") ? kind->name : "hatch." + kind->name;
}

/// The parts that are drawn, those that are drawn alike once; that of the drawing where all are.
std::vector<KeyPlace> places_of(const Style& whole, std::span<const PartStyle> part_styles,
                                const KeySurroundings& around, std::size_t kind) {
  std::vector<KeyPlace> out;
  for (const PartStyle& one : part_styles) {
    const Style& style = one.style ? *one.style : whole;
    const auto alike = [&](const KeyPlace& p) {
      return p.hatched == one.hatched && p.transparent == one.transparent &&
             (&p.part == &style || p.part == style);
    };
    if (!one.drawn || stroke_kind_count(style) < kind || std::ranges::any_of(out, alike)) continue;
    out.push_back({whole, style, one.hatched, one.transparent, around, kind});
  }
  if (part_styles.empty()) out.push_back({whole, whole, true, false, around, kind});
  return out;
}

std::string said(const detail::KeyNeed& need, const KeyPlace& at) {
  const tone::ToneOptions& tone = tone_of(at.part, at.kind);
  return fmt::format(
      fmt::runtime(need.otherwise), fmt::arg("style", at.part.name), fmt::arg("law", tone.law),
      fmt::arg("ink", at.part.fill.ink),
      fmt::arg("toneink", tone.ink == tone::ToneOptions::Ink::Shade ? "shade" : "light"));
}

}  // namespace

std::string why_unused(std::string_view key, const Style& whole,
                       std::span<const PartStyle> part_styles, const KeySurroundings& around) {
  const std::string name = row_of_key(key);
  const std::vector<detail::StyleRow> rows = detail::all_rows_of(whole);
  const auto row = std::ranges::find(rows, name, &detail::StyleRow::name);
  if (row == rows.end()) return {};
  const auto kind = detail::kind_key(name);
  const auto places = places_of(whole, part_styles, around, kind ? kind->number : 1);
  const auto has_it = [&](const KeyPlace& p) {
    return row->of_whole || row->get(p.part) == row->get(whole);
  };
  if (!places.empty() && std::ranges::none_of(places, has_it)) {
    return ": every part has another one, of a style of its own (`highlight`, `look`)";
  }
  // What the part lacks that lacks the least.
  std::size_t most = 0;
  const KeyPlace* nearest = nullptr;
  for (const KeyPlace& place : places) {
    if (!has_it(place)) continue;
    std::size_t met = 0;
    while (met < row->needs.size() && row->needs[met].holds(place)) ++met;
    if (met == row->needs.size()) return {};
    if (!nearest || met > most) nearest = &place, most = met;
  }
  return nearest ? said(row->needs[most], *nearest) : std::string();
}

}  // namespace burin
