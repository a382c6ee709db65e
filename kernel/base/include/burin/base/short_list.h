#pragma once

#include <cstddef>
#include <functional>
#include <ranges>
#include <string>

namespace burin {

/// The first `most` of `items`, each by `text` of it: "a, b, c and 4 more". All of them where
/// they are no more than that; "" of none.
template <std::ranges::sized_range Items, class Text = std::identity>
std::string short_list(const Items& items, std::size_t most, Text text = {}) {
  std::string list;
  std::size_t count = 0;
  for (const auto& item : items) {
    if (count == most) return list + " and " + std::to_string(items.size() - most) + " more";
    if (count++ > 0) list += ", ";
    list += text(item);
  }
  return list;
}

}  // namespace burin
