#include <burin/assembly/select.h>
#include <burin/base/ascii.h>
#include <burin/converters/output.h>
#include <burin/converters/request.h>
#include <burin/drawing/parts_list.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>

namespace burin {
namespace {

/// Numbers that the illustration keeps for names which no part has.
void tell_holes(const ItemNumbers& kept, const std::vector<Item>& items, Diagnostics& diagnostics) {
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

}  // namespace

void number_parts(Scene& scene, DrawPlan& plan, RunContext& context) {
  const bool wanted =
      plan.callouts || plan.parts_list || plan.items || !plan.parts_list_files.empty();
  if (!wanted) return;
  context.begin_stage(RunStage::Build);
  const std::vector<Item> items = find_items(scene, plan.numbers, scene.diagnostics, context,
                                             unlisted_of(plan.illustrate.part_styles));
  context.end_stage();
  tell_holes(plan.numbers, items, scene.diagnostics);
  Annotations annotations;
  annotations.callouts = plan.callouts;
  annotations.parts_list = plan.parts_list;
  annotations.margin = plan.sheet.margin;
  const auto& styles = plan.illustrate.part_styles;
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
  plan.illustrate.annotations = std::move(annotations);
}

void write_parts_lists(const Drawing& drawing, const DrawPlan& plan) {
  std::vector<Output> files;
  for (const std::string& name : plan.parts_list_files) {
    Output& file = files.emplace_back(name, *format_named("json"));
    const bool csv = lowered(std::filesystem::path(name).extension().string()) != ".json";
    file.write([&](std::ostream& out) {
      out << (csv ? parts_list_csv(drawing.items) : parts_list_json(drawing.items));
    });
  }
  for (Output& file : files) file.commit();
}

}  // namespace burin
