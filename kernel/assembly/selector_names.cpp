#include "selector_names.h"

#include <burin/assembly/items.h>
#include <burin/base/error.h>

#include "composed.h"

#include <algorithm>

namespace burin::detail {
namespace {

std::vector<std::string> parted(std::string_view path) {
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t to = std::min(path.find('/', from), path.size());
    if (to > from) names.emplace_back(path.substr(from, to - from));
    from = to + 1;
  }
  return names;
}

bool is_ascii(std::string_view text) {
  return std::ranges::none_of(text, [](char c) { return static_cast<signed char>(c) < 0; });
}

// Bounded: a star that fails is tried again from the next letter, the stars before it never are.
bool like_composed(std::string_view pattern, std::string_view name) {
  std::size_t p = 0, n = 0, star = pattern.npos, from = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      from = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++n;
      // A letter is what ends before the next byte that begins one.
      while (pattern[p] == '?' && n < name.size() && (name[n] & 0xc0) == 0x80) ++n;
      ++p;
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

}  // namespace

bool like(std::string_view pattern, std::string_view name) {
  // Names of ASCII, which most are, can only be met by patterns of ASCII.
  if (is_ascii(name)) return is_ascii(pattern) && like_composed(pattern, name);
  return like_composed(composed(pattern), composed(name));
}

std::vector<std::string> names_of(const Part& part) {
  std::vector<std::string> names = part.assembly;
  names.push_back(part.name);
  return names;
}

std::vector<std::string> names_of_piece(const std::string& name) {
  const std::size_t open = name.find(" (");
  if (open == name.npos || !name.ends_with(')')) return {name};
  return {name, name.substr(0, open), name.substr(open + 2, name.size() - open - 3)};
}

NamePatterns::NamePatterns(std::string_view selector) : patterns_(parted(selector)) {
  if (patterns_.empty()) throw UsageError("a selector is the name of a part, not empty");
  path_ = patterns_.size() > 1;
  from_top_ = selector.starts_with('/');
  if (!from_top_) patterns_.insert(patterns_.begin(), "**");
}

// Entry i: the patterns may have taken the first i names.
std::vector<bool> NamePatterns::reached(std::span<const std::string> names, bool as_read) const {
  const auto matches = [&](const std::string& pattern, const std::string& name) {
    return like(pattern, name) || (as_read && like(pattern, name_as_read(name)));
  };
  std::vector<bool> reached(names.size() + 1, false);
  reached[0] = true;
  for (const std::string& pattern : patterns_) {
    std::vector<bool> next(names.size() + 1, false);
    for (std::size_t i = 0; i <= names.size(); ++i) {
      if (pattern == "**") {
        next[i] = reached[i] || (i > 0 && next[i - 1]);
      } else {
        next[i] = i > 0 && reached[i - 1] && matches(pattern, names[i - 1]);
      }
    }
    reached = std::move(next);
  }
  return reached;
}

std::size_t NamePatterns::depth(std::span<const std::string> names) const {
  const std::vector<bool> all = reached(names, !from_top_);
  const auto first = std::find(all.begin(), all.end(), true);
  if (first == all.end()) return 0;
  // "**" alone leads to the top before it has taken a name.
  return std::max<std::size_t>(1, static_cast<std::size_t>(first - all.begin()));
}

bool NamePatterns::lead_to_last(std::span<const std::string> names) const {
  const std::vector<bool> all = reached(names, false);
  return path_ && std::find(all.begin(), all.end(), true) == std::prev(all.end()) && all.back();
}

}  // namespace burin::detail
