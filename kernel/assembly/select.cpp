#include <burin/assembly/items.h>
#include <burin/assembly/select.h>
#include <burin/assembly/things.h>
#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/base/nearest.h>
#include <burin/base/short_list.h>

#include "selector_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>

namespace burin {
namespace {

using detail::like;
using detail::NamePatterns;
using detail::names_of;

using Test = std::function<bool(std::size_t index, const Part& part)>;

bool comes_from(const Part& part, std::string_view pattern) {
  const std::filesystem::path file(part.source);
  return like(pattern, part.source) || like(pattern, file.filename().string());
}

Test by_attribute(std::string_view selector) {
  const std::size_t equals = selector.find('=');
  const std::string name(selector.substr(1, equals - 1));
  const std::string value(equals == selector.npos ? "" : selector.substr(equals + 1));
  if (name == "color") {
    return [color = lowered(value)](std::size_t, const Part& part) {
      return lowered(part.color) == color;
    };
  }
  if (name == "index") {
    return [value](std::size_t index, const Part&) { return std::to_string(index) == value; };
  }
  if (name == "file") {
    return [value](std::size_t, const Part& part) { return comes_from(part, value); };
  }
  throw UsageError(
      fmt::format("selector '{}': parts have @color=, @index= and @file=, no @{}", selector, name));
}

/// How many names of a part's path a selector leads down, 0 where it does not lead there. The first
/// `passed` of them are not looked at.
std::size_t depth(const NamePatterns& patterns, const Part& part, std::size_t passed) {
  std::vector<std::string> names = names_of(part);
  const auto least = [&] {
    const std::size_t found = patterns.depth(std::span(names).subspan(passed));
    return found == 0 ? 0 : passed + found;
  };
  std::size_t led = least();
  if (led > 0 || !part.whole) return led;
  for (const std::string& name : detail::names_of_piece(part.name)) {
    names.back() = name;
    if ((led = least()) > 0) break;
  }
  return led;
}

/// Whether all parts are in one assembly, which a name means like some of what is in it: then the
/// name means these. "gear*" are the gears of a gear pump, and "rod" is the rod of rod.step.
bool passes_top(const Scene& scene, std::string_view selector, const NamePatterns& patterns) {
  if (selector.find('/') != selector.npos) return false;
  const auto top = [](const Part& part) {
    return part.assembly.empty() ? std::string_view() : std::string_view(part.assembly.front());
  };
  const auto meant = [&](const Part& part) { return depth(patterns, part, 1) > 0; };
  return !scene.parts.empty() && !top(scene.parts[0]).empty() &&
         like(selector, top(scene.parts[0])) &&
         std::ranges::all_of(scene.parts,
                             [&](const Part& p) { return top(p) == top(scene.parts[0]); }) &&
         std::ranges::any_of(scene.parts, meant) && !std::ranges::all_of(scene.parts, meant);
}

Test test_by_name(const Scene& scene, std::string_view selector) {
  const NamePatterns patterns(selector);
  const std::size_t passed = passes_top(scene, selector, patterns) ? 1 : 0;
  return [patterns, passed](std::size_t, const Part& part) {
    return depth(patterns, part, passed) > 0;
  };
}

/// Parts of one thing get the selector of the assembly that they are, or else that of the first.
void name_things(const Scene& scene, std::vector<std::string>& selectors) {
  for (std::size_t i = 0; i < scene.parts.size();) {
    const std::size_t end = end_of_thing(scene, i);
    if (end > i + 1) {
      const std::string whole = selectors[i].substr(0, selectors[i].rfind('/'));
      const auto of_it = [&](std::size_t part) { return part >= i && part < end; };
      std::vector<std::size_t> found;
      if (whole.starts_with('/')) found = select(scene, whole);
      const bool alone = found.size() == end - i && std::ranges::all_of(found, of_it);
      std::fill(selectors.begin() + static_cast<std::ptrdiff_t>(i),
                selectors.begin() + static_cast<std::ptrdiff_t>(end), alone ? whole : selectors[i]);
    }
    i = end;
  }
}

/// Whether the names from one of them on, or from the top, are the selector as it is written.
bool is_written(const std::vector<std::string>& names, std::string_view selector) {
  const bool from_top = selector.starts_with('/');
  const std::string wanted = fmt::format("{}/", selector.substr(from_top ? 1 : 0));
  std::string rest = fmt::format("{}/", fmt::join(names, "/"));
  for (const std::string& name : names) {
    if (rest.starts_with(wanted)) return true;
    if (from_top) return false;
    rest.erase(0, name.size() + 1);
  }
  return false;
}

/// Names may have slashes within: "1/4 inch bolt".
std::vector<std::size_t> with_slashes_in_names(const Scene& scene, std::string_view selector) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (is_written(names_of(scene.parts[i]), selector)) found.push_back(i);
  }
  return found;
}

/// Whether the name of any part is one that an item could have this name from: to find the items
/// costs the measures of shapes.
bool may_be_item(const Scene& scene, std::string_view selector) {
  constexpr std::string_view kBetween = "_.:-# ()";  // a name and its number
  const std::string stem = instance_stem(selector);
  return std::ranges::any_of(scene.parts, [&](const Part& one) {
    const Part& part = one.whole ? *one.whole : one;
    const std::string& called = part.definition.empty() ? part.name : part.definition;
    // The name of an item is that of a part, or the beginning of it.
    for (std::size_t end = called.size(); end > 0; --end) {
      const std::string_view begin = std::string_view(called).substr(0, end);
      if (like(selector, begin) || like(stem, begin)) return true;
      if (!is_digit(begin.back()) && kBetween.find(begin.back()) == kBetween.npos) break;
    }
    return false;
  });
}

/// The parts of items that an illustration calls so.
std::vector<std::size_t> of_renamed_items(const Scene& scene, std::string_view selector) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const Part& part = scene.parts[i];
    const std::string& name = (part.whole ? *part.whole : part).item_name;
    if (!name.empty() && like(selector, name)) found.push_back(i);
  }
  return found;
}

/// The parts of items that are called so, as lists and legends call them.
std::vector<std::size_t> of_items(const Scene& scene, std::string_view selector) {
  Diagnostics told_with_the_list;
  RunContext context;
  std::vector<std::size_t> found;
  if (!may_be_item(scene, selector)) return found;
  for (const Item& item : find_items(scene, {}, told_with_the_list, context)) {
    if (like(selector, item.name)) {
      found.insert(found.end(), item.parts.begin(), item.parts.end());
    }
  }
  std::ranges::sort(found);
  return found;
}

// What a selector that found nothing could have meant, the nearest first.
std::string known_names(const Scene& scene, std::string_view selector) {
  constexpr std::size_t kMost = 5;
  const bool path = selector.find('/') != selector.npos;
  std::vector<std::string> names;
  for (const Part& part : scene.parts) {
    if (path) {
      names.push_back(path_of(part));
    } else {
      for (std::string& name : names_of(part)) names.push_back(std::move(name));
    }
    for (const Piece& piece : part.pieces) names.push_back(path_of(part) + "/" + piece.name);
    if (!part.item_name.empty()) names.push_back(part.item_name);
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::ranges::stable_sort(names, {},
                           [&](const std::string& name) { return edit_distance(name, selector); });
  return short_list(names, kMost, [](const std::string& name) { return "'" + name + "'"; });
}

}  // namespace

std::string path_of(const Part& part) {
  std::string path;
  for (const std::string& name : part.assembly) path += name + "/";
  return path + part.name;
}

std::vector<std::string> selectors_of(const Scene& scene) {
  std::vector<std::string> selectors;
  std::map<std::string, std::size_t> meant;  // parts that a path leads to
  for (const Part& part : scene.parts) {
    std::string& path = selectors.emplace_back();
    for (std::string& name : names_of(part)) {
      std::ranges::replace_if(
          name, [](char c) { return c == '/' || c == ';'; }, '?');
      path += "/" + name;
      ++meant[path];
    }
  }
  for (std::size_t i = 0; i < selectors.size(); ++i) {
    const bool wild = selectors[i].find_first_of("*?") != std::string::npos;
    const bool alone = wild ? select(scene, selectors[i]).size() == 1 : meant[selectors[i]] == 1;
    if (!alone) selectors[i] = fmt::format("@index={}", i);
  }
  name_things(scene, selectors);
  return selectors;
}

std::vector<std::size_t> select(const Scene& scene, std::string_view selector) {
  const Test test =
      selector.starts_with('@') ? by_attribute(selector) : test_by_name(scene, selector);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (test(i, scene.parts[i])) found.push_back(i);
  }
  if (found.empty()) found = with_slashes_in_names(scene, selector);
  if (found.empty()) found = of_renamed_items(scene, selector);
  if (found.empty() && !selector.starts_with('@')) found = of_items(scene, selector);
  if (found.empty()) {
    throw UsageError(fmt::format("no part is named '{}'; names of parts and assemblies: {}",
                                 selector, known_names(scene, selector)));
  }
  return found;
}

void name_items(Scene& scene, const ItemNumbers& kept, std::span<const std::string> selectors) {
  const auto needs_name = [&](const std::string& selector) {
    const auto means = [&](const auto& item) { return like(selector, item.second.name); };
    if (std::ranges::none_of(kept, means)) return false;
    try {
      select(scene, selector);
      return false;
    } catch (const UsageError&) {
      return true;
    }
  };
  if (std::ranges::none_of(selectors, needs_name)) return;
  Diagnostics told_with_the_list;
  RunContext context;
  for (const Item& item : find_items(scene, kept, told_with_the_list, context)) {
    const auto known = kept.find(item.number);
    if (known == kept.end()) continue;
    for (const std::size_t part : item.parts) scene.parts[part].item_name = known->second.name;
  }
}

std::vector<std::size_t> levels_above(const Scene& scene, std::span<const std::size_t> parts,
                                      std::string_view selector) {
  std::vector<std::size_t> levels(parts.size(), 0);
  if (selector.starts_with('@')) return levels;
  const NamePatterns patterns(selector);
  const std::size_t passed = passes_top(scene, selector, patterns) ? 1 : 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = scene.parts[parts[i]];
    const std::size_t led = depth(patterns, part, passed);
    if (led > 0) levels[i] = part.assembly.size() + 1 - led;
  }
  return levels;
}

}  // namespace burin
