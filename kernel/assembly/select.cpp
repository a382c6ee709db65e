#include <burin/assembly/select.h>
#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/base/nearest.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <span>

namespace burin {
namespace {

using Names = std::span<const std::string>;

// Whether a name is as the pattern says. Bounded: a star that fails is tried again from the next
// letter, the stars before it never are.
bool like(std::string_view pattern, std::string_view name) {
  std::size_t p = 0, n = 0, star = pattern.npos, from = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      from = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p, ++n;
    } else if (star != pattern.npos) {
      p = star + 1;
      n = ++from;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

// Whether the names begin as the patterns say: what they lead to, or what contains it, is meant.
// Reached[i]: the patterns so far may have taken the first i names.
bool leads_to(Names patterns, Names names) {
  std::vector<bool> reached(names.size() + 1, false);
  reached[0] = true;
  for (const std::string& pattern : patterns) {
    std::vector<bool> next(names.size() + 1, false);
    for (std::size_t i = 0; i <= names.size(); ++i) {
      if (pattern == "**") {
        next[i] = reached[i] || (i > 0 && next[i - 1]);
      } else {
        next[i] = i > 0 && reached[i - 1] && like(pattern, names[i - 1]);
      }
    }
    reached = std::move(next);
  }
  return std::find(reached.begin(), reached.end(), true) != reached.end();
}

std::vector<std::string> names_of(const Part& part) {
  std::vector<std::string> names = part.assembly;
  names.push_back(part.name);
  return names;
}

std::vector<std::string> parted(std::string_view path) {
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t to = std::min(path.find('/', from), path.size());
    if (to > from) names.emplace_back(path.substr(from, to - from));
    from = to + 1;
  }
  return names;
}

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

Test by_name(std::string_view selector) {
  std::vector<std::string> patterns = parted(selector);
  if (patterns.empty()) throw UsageError("a selector is the name of a part, not empty");
  if (!selector.starts_with('/')) patterns.insert(patterns.begin(), "**");
  return [patterns](std::size_t, const Part& part) { return leads_to(patterns, names_of(part)); };
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
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::ranges::stable_sort(names, {},
                           [&](const std::string& name) { return edit_distance(name, selector); });
  const std::size_t more = names.size() - std::min(names.size(), kMost);
  names.resize(names.size() - more);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return more > 0 ? fmt::format("{} and {} more", text, more) : text;
}

}  // namespace

std::string path_of(const Part& part) {
  std::string path;
  for (const std::string& name : part.assembly) path += name + "/";
  return path + part.name;
}

std::string selector_of(const Part& part) {
  std::string selector;
  for (std::string& name : names_of(part)) {
    std::ranges::replace_if(
        name, [](char c) { return c == '/' || c == ';'; }, '?');
    selector += "/" + name;
  }
  return selector;
}

std::vector<std::size_t> select(const Scene& scene, std::string_view selector) {
  const Test test = selector.starts_with('@') ? by_attribute(selector) : by_name(selector);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (test(i, scene.parts[i])) found.push_back(i);
  }
  if (found.empty()) {
    throw UsageError(fmt::format("no part is named '{}'; names of parts and assemblies: {}",
                                 selector, known_names(scene, selector)));
  }
  return found;
}

}  // namespace burin
