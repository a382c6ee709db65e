#include "new_parts.h"

#include <burin/assembly/things.h>

#include "page.h"

#include <algorithm>
#include <map>
#include <utility>

namespace burin::detail {
namespace {

int number_of(const PageMaker& maker, std::size_t part) {
  const DrawingItem* item = maker.item_of[part];
  return item ? item->number : -1 - static_cast<int>(part);
}

NewPart about(const PageMaker& maker, const std::vector<std::size_t>& parts) {
  const std::vector<std::size_t> things = things_of(maker.scene);
  const auto of_first = [&](std::size_t p) { return things[p] == things[parts.front()]; };
  if (std::ranges::all_of(parts, of_first)) {
    const DrawingItem* item = maker.item_of[parts.front()];
    return item ? NewPart{item->number, item->name, 0}
                : NewPart{0, maker.scene.parts[parts.front()].name, 0};
  }
  return {0, name_together(maker.scene, maker.drawn, parts), 0};
}

}  // namespace

std::vector<NewKind> new_kinds(const PageMaker& maker, const BuildStep& step) {
  std::map<std::vector<int>, std::size_t> known;
  std::vector<NewKind> kinds;
  const auto add = [&](const std::vector<std::size_t>& parts) {
    std::vector<int> numbers;
    for (const std::size_t part : parts) numbers.push_back(number_of(maker, part));
    std::ranges::sort(numbers);
    const auto [entry, is_new] = known.try_emplace(std::move(numbers), kinds.size());
    if (is_new) kinds.push_back({about(maker, parts), parts});
    ++kinds[entry->second].about.quantity;
  };
  for (const BuildMove& move : step.moves) add(move.parts);
  if (step.begins) {
    const std::vector<std::size_t> things = things_of(maker.scene);
    std::map<std::size_t, std::vector<std::size_t>> assembled;
    for (const std::size_t part : step.assembled) assembled[things[part]].push_back(part);
    for (const auto& [first, parts] : assembled) add(parts);
  }
  return kinds;
}

std::vector<DrawingItem> new_items(const PageMaker& maker, const BuildStep& step) {
  std::vector<std::size_t> fresh;
  for (const BuildMove& move : step.moves) {
    fresh.insert(fresh.end(), move.parts.begin(), move.parts.end());
  }
  if (step.begins) fresh.insert(fresh.end(), step.assembled.begin(), step.assembled.end());
  std::ranges::sort(fresh);
  std::map<int, DrawingItem> items;
  for (const std::size_t part : fresh) {
    const DrawingItem* item = maker.item_of[part];
    if (!item) continue;
    DrawingItem& one = items.try_emplace(item->number, *item).first->second;
    if (one.parts == item->parts) one.parts.clear(), one.selectors.clear();
    const auto id = static_cast<std::int32_t>(part);
    const auto at =
        static_cast<std::size_t>(std::ranges::find(item->parts, id) - item->parts.begin());
    one.parts.push_back(id);
    if (at < item->selectors.size()) one.selectors.push_back(item->selectors[at]);
  }
  std::vector<DrawingItem> out;
  for (auto& [number, item] : items) out.push_back(std::move(item));
  return out;
}

}  // namespace burin::detail
