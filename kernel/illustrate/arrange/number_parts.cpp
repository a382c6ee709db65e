#include <burin/arrange/arrange.h>
#include <burin/assembly/select.h>
#include <burin/illustrate/legend.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// Numbers that the illustration keeps for names which no part has.
void report_holes(const ItemNumbers& kept, const std::vector<Item>& items,
                  Diagnostics& diagnostics) {
  std::set<int> used;
  for (const Item& item : items) used.insert(item.number);
  std::int64_t count = 0;
  std::string first;
  for (const auto& [number, item] : kept) {
    if (used.contains(number)) continue;
    if (count++ == 0)
      first = fmt::format("{} '{}'", number, item.name.empty() ? item.select : item.name);
  }
  if (count == 0) return;
  diagnostics.add(
      Severity::Info, "items.gone", count,
      fmt::format("numbers are kept for items that are not there; the first: {}", first));
}

std::vector<bool> unlisted_of(const std::vector<PartStyle>& styles) {
  std::vector<bool> unlisted;
  for (const PartStyle& style : styles) unlisted.push_back(!style.listed);
  return unlisted;
}

/// Of what has a body of this path: all of its bodies.
std::string selector_of_whole(const std::string& of_body) {
  return of_body.starts_with('@') ? of_body : of_body.substr(0, of_body.rfind('/'));
}

/// Whether rows of several names have one colour.
bool are_alike(const std::vector<LegendRow>& rows) {
  return rows.size() > 1 && std::ranges::all_of(rows, [&](const LegendRow& row) {
           return row.square.fill == rows.front().square.fill;
         });
}

/// Whether the legend is to have some parts alone: these it tells from the others.
bool leaves_parts_out(const Illustration& illustration) {
  return std::ranges::any_of(illustration.illustrate.part_styles, [](const PartStyle& look) {
    return look.drawn && look.style && !look.style->fill.legend;
  });
}

/// Names the key that leaves colours out, where one does.
void report_empty_legend(const Illustration& illustration, Scene& scene) {
  bool left_out = false;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const auto& styles = illustration.illustrate.part_styles;
    const bool own = i < styles.size() && styles[i].style;
    const FillOptions& fill = (own ? *styles[i].style : illustration.style).fill;
    const bool drawn = i >= styles.size() || styles[i].drawn;
    const bool shown = fill.color != "none" || fill.hatch.lines != FillHatch::Lines::None;
    left_out = left_out || (drawn && shown && !fill.legend);
  }
  scene.diagnostics.add(Severity::Warning, "legend.empty", 1,
                        left_out ? "fill.legend=false leaves all colours out of the legend, so "
                                   "that none is drawn: set it to true, or leave out `legend`"
                                 : "there is no colour for a legend: choose fill.color, or a style "
                                   "that has colours, such as flat");
}

}  // namespace

void number_parts(Scene& scene, Illustration& illustration, RunContext& context) {
  if (!illustration.callouts && !illustration.parts_list && !illustration.legend &&
      !illustration.items)
    return;
  context.begin_stage(RunStage::Build);
  const std::vector<Item> items =
      find_items(scene, illustration.numbers, scene.diagnostics, context,
                 unlisted_of(illustration.illustrate.part_styles));
  context.end_stage();
  report_holes(illustration.numbers, items, scene.diagnostics);
  Annotations annotations;
  annotations.callouts = illustration.callouts;
  annotations.parts_list = illustration.parts_list;
  annotations.margin = illustration.sheet.margin;
  const auto& styles = illustration.illustrate.part_styles;
  const std::vector<std::string> selectors = selectors_of(scene);
  for (const Item& item : items) {
    DrawingItem drawn{item.number, item.name, {}, item.color, item.source};
    std::map<const Part*, std::size_t> wholes;  // where they stand in the row
    for (const std::size_t part : item.parts) {
      if (part < styles.size() && !styles[part].drawn) continue;
      const Part* whole = scene.parts[part].whole.get();
      if (const auto known = wholes.find(whole); whole && known != wholes.end()) {
        drawn.selectors[known->second] = selector_of_whole(selectors[part]);
        continue;
      }
      if (whole) wholes.emplace(whole, drawn.parts.size());
      drawn.parts.push_back(static_cast<std::int32_t>(part));
      drawn.selectors.push_back(selectors[part]);
    }
    if (!drawn.parts.empty()) annotations.items.push_back(std::move(drawn));
  }
  if (illustration.legend) {
    annotations.legend =
        legend_rows(scene, illustration.style, illustration.illustrate, annotations.items);
    if (annotations.legend.empty()) {
      report_empty_legend(illustration, scene);
    } else if (are_alike(annotations.legend) && !leaves_parts_out(illustration)) {
      scene.diagnostics.add(Severity::Warning, "legend.alike",
                            static_cast<std::int64_t>(annotations.legend.size()),
                            "all parts have one colour, so that the legend does not tell them "
                            "apart: choose a style in which parts have their own, such as flat");
    }
  }
  illustration.illustrate.annotations = std::move(annotations);
}

}  // namespace burin
