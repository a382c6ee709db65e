#include "part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

using Seen = std::map<std::string, int>;

std::string modifier_of(const TreePart& part) {
  return part.highlight ? " (highlighted)" : part.background ? " (background)" : "";
}

std::string numbered(const std::string& name, Seen& seen) {
  const int n = ++seen[name];
  return n > 1 ? fmt::format("{} #{}", name, n) : name;
}

void put_together(TreeParts& all) {
  std::map<std::uint32_t, std::size_t> first;
  std::vector<std::size_t> order(all.parts.size()), thing(all.parts.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const TreePart& part = all.parts[i];
    order[i] = i;
    thing[i] = part.of_one ? first.try_emplace(part.of, i).first->second : i;
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return thing[i]; });
  std::vector<TreePart> sorted;
  std::vector<std::size_t> now(order.size());
  for (const std::size_t i : order) {
    now[i] = sorted.size();
    sorted.push_back(std::move(all.parts[i]));
  }
  all.parts = std::move(sorted);
  for (PartCall& call : all.calls) {
    for (std::size_t& part : call.parts) part = now[part];
  }
}

/// What is told apart by its looks alone is called by them.
void name_thing(std::span<TreePart> thing, const std::string& name) {
  Seen seen;
  for (TreePart& part : thing) {
    if (part.definition.empty()) part.definition = part.name;
    part.assembly = name;
    const std::string look = part.color.empty() ? "uncoloured" : part.color;
    part.name = numbered(look + modifier_of(part), seen);
  }
}

}  // namespace

void name_parts(TreeParts& all) {
  put_together(all);
  Seen seen;
  for (std::size_t i = 0; i < all.parts.size();) {
    const TreePart& first = all.parts[i];
    const auto goes_on = [&](std::size_t k) {
      return k < all.parts.size() && first.of_one && all.parts[k].of_one &&
             all.parts[k].of == first.of;
    };
    std::size_t end = i + 1;
    while (goes_on(end)) ++end;
    if (end > i + 1) {
      name_thing(std::span(all.parts).subspan(i, end - i), numbered(first.name, seen));
    } else {
      all.parts[i].name = numbered(first.name + modifier_of(first), seen);
    }
    i = end;
  }
}

}  // namespace burin::detail
