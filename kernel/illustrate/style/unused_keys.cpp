#include <burin/illustrate/unused_keys.h>

#include "style_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace burin {
namespace {

using detail::KeyPlace;

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

/// What a key needs first that the part does not have.
const detail::KeyNeed* lacks(const detail::StyleRow& row, const KeyPlace& place) {
  const auto need =
      std::ranges::find_if(row.needs, [&](const auto& one) { return !one.holds(place); });
  return need == row.needs.end() ? nullptr : &*need;
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
  const std::string name = detail::row_of_key(key);
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
  const detail::KeyNeed* last = nullptr;
  const KeyPlace* nearest = nullptr;
  for (const KeyPlace& place : places) {
    if (!has_it(place)) continue;
    const detail::KeyNeed* lack = lacks(*row, place);
    if (!lack) return {};
    if (!nearest || lack > last) nearest = &place, last = lack;  // needs stand in one list
  }
  return nearest ? said(*last, *nearest) : std::string();
}

std::string why_unused_in_parts(std::string_view key, const Style& part, const Style& whole) {
  const std::string name = detail::row_of_key(key);
  const std::vector<detail::StyleRow> rows = detail::all_rows_of(part);
  const auto row = std::ranges::find(rows, name, &detail::StyleRow::name);
  if (row == rows.end() || row->of_whole) return {};
  const auto kind = detail::kind_key(name);
  const KeySurroundings around{.legend = true};
  const KeyPlace place{whole, part, true, false, around, kind ? kind->number : 1};
  const detail::KeyNeed* lack = lacks(*row, place);
  return lack ? said(*lack, place) : std::string();
}

}  // namespace burin
