#include "fitted_names.h"

#include <burin/drawing/font.h>
#include <burin/drawing/text.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

namespace burin::detail {
namespace {

constexpr const char* kDots = "...";

std::string utf8(const std::u32string& text) {
  std::string out;
  for (const char32_t c : text) out += utf8_of(c);
  return out;
}

std::size_t common_start(const std::set<std::string>& names) {
  const std::u32string first = code_points(*names.begin());
  std::size_t common = first.size();
  for (const std::string& name : names) {
    const std::u32string other = code_points(name);
    const auto [a, b] = std::ranges::mismatch(first, other);
    common = std::min(common, static_cast<std::size_t>(a - first.begin()));
  }
  return common;
}

/// The beginning of the word at a place, if that is near.
std::size_t word_start(const std::u32string& name, std::size_t at) {
  constexpr std::size_t kNear = 8;  // letters
  const std::u32string breaks = U" _-/.,";
  for (std::size_t k = 0; k < kNear && k < at; ++k) {
    if (breaks.find(name[at - k - 1]) != std::u32string::npos) return at - k;
  }
  return at;
}

/// As much of the beginning as fits beside what comes from `at` on, which keeps two thirds.
std::string cut_before(const std::string& text, std::size_t at, double height, double width) {
  const std::u32string name = code_points(text);
  const double all = width - text_width(kDots, height);
  const std::string rest =
      fitted_text(utf8(name.substr(word_start(name, at))), height, 2 * all / 3);
  return fitted_text(text, height, width - text_width(rest, height)) + rest;
}

}  // namespace

std::vector<std::string> fitted_names(std::span<const std::string> names, double height,
                                      double width) {
  std::vector<std::string> out;
  for (const std::string& name : names) out.push_back(fitted_text(name, height, width));
  // Of names that still read the same the common start is longer each time.
  constexpr int kMostRounds = 8;
  bool changed = true;
  for (int round = 0; changed && round < kMostRounds; ++round) {
    changed = false;
    std::map<std::string, std::set<std::string>> by_text;
    for (std::size_t i = 0; i < names.size(); ++i) by_text[out[i]].insert(names[i]);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::set<std::string>& alike = by_text.at(out[i]);
      if (alike.size() < 2 || text_width(names[i], height) <= width) continue;
      const std::string text = cut_before(names[i], common_start(alike), height, width);
      changed = changed || text != out[i];
      out[i] = text;
    }
  }
  return out;
}

}  // namespace burin::detail
