#include "part_styles.h"

#include <burin/assembly/select.h>
#include <burin/base/error.h>
#include <burin/illustrate/stroke_selectors.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <compare>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

namespace burin::detail {
namespace {

// The parts that any of the selectors names.
std::vector<bool> selected(const Scene& scene, const HatchStyle& hatch) {
  const std::vector<std::string> selectors = selectors_of(hatch);
  std::vector<bool> flags(scene.parts.size(), selectors.empty());
  for (const std::string& selector : selectors) {
    try {
      for (const std::size_t part : select(scene, selector)) flags[part] = true;
    } catch (const UsageError& e) {
      throw UsageError(fmt::format("strokes (hatch.select): {}", e.what()));
    }
  }
  return flags;
}

// `one_tone`: all have the same, whatever their options say.
void share_tone(std::span<const StrokeSet> all, bool one_tone, StrokeSet& set) {
  set.exponents.assign(set.parts.size(), 1);
  for (std::size_t i = 0; i < set.parts.size(); ++i) {
    if (!set.parts[i]) continue;
    double sum = 0;
    for (const StrokeSet& other : all) {
      if (other.parts[i] && (one_tone || *other.tone == *set.tone)) sum += other.hatch->share;
    }
    set.exponents[i] = set.hatch->share / sum;
  }
  const bool alone = std::ranges::all_of(set.exponents, [](double e) { return e == 1; });
  if (alone) set.exponents.clear();
}

// How much ink a mm has of the lines in which a part meets others, 0 where it has none, and of its
// contours.
std::array<double, 2> ink_of_lines(const Style& style, const Style& whole) {
  const Rgb paper = rgb_of(whole.sheet.paper).value_or(Rgb{255, 255, 255});
  const double ink = contrast(line_ink(style, whole), paper);
  return {style.feature.intersections ? style.line.intersection * ink : 0,
          style.line.contour * ink};
}

// From 0 to below 1, the smaller the size the more; sizes next to each other are one.
std::vector<double> small_first(std::span<const double> sizes) {
  constexpr double kSame = 1.01;  // more than triangles of one part differ from view to view
  std::vector<std::size_t> sorted(sizes.size());
  std::iota(sorted.begin(), sorted.end(), std::size_t{0});
  std::ranges::sort(sorted, std::ranges::greater{}, [&](std::size_t i) { return sizes[i]; });
  std::vector<double> out(sizes.size());
  double place = 0;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    if (k > 0 && sizes[sorted[k - 1]] > kSame * sizes[sorted[k]]) ++place;
    out[sorted[k]] = place / static_cast<double>(sizes.size());
  }
  return out;
}

}  // namespace

Rgb line_ink(const Style& style, const Style& whole) {
  const std::string& own = style.line.color;
  return rgb_of(own.empty() ? whole.sheet.ink : own).value_or(Rgb{});
}

PartStyles::PartStyles(const Scene& scene, const Style& style, const IllustrateOptions& options)
    : parts_(scene.parts.size()), styles_{&style} {
  const std::size_t parts = parts_.size();
  for (std::size_t i = 0; i < std::min(parts, options.part_styles.size()); ++i) {
    const PartStyle& look = options.part_styles[i];
    One& one = parts_[i];
    if (look.style) {
      const auto known =
          std::ranges::find_if(styles_, [&](const Style* other) { return *other == *look.style; });
      one.style = static_cast<std::size_t>(known - styles_.begin());
      if (known == styles_.end()) styles_.push_back(&*look.style);
    }
    one.drawn = look.drawn;
    one.transparent = look.transparent;
    one.hatched = look.hatched;
  }
  for (One& one : parts_) {
    one.hatched = one.hatched && one.drawn && has_strokes(*styles_[one.style]);
  }
  find_strokes(scene, static_cast<bool>(options.tone));
}

void PartStyles::find_strokes(const Scene& scene, bool one_tone) {
  for (std::size_t k = 0; k < styles_.size(); ++k) {
    const std::size_t first = strokes_.size();
    for (std::size_t number = 1; number <= stroke_kind_count(*styles_[k]); ++number) {
      const HatchStyle& hatch = hatch_of(*styles_[k], number);
      if (!hatch.enabled) continue;
      StrokeSet set{&hatch, &tone_of(*styles_[k], number), static_cast<int>(number),
                    selected(scene, hatch)};
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (!parts_[i].hatched || parts_[i].style != k) set.parts[i] = false;
      }
      strokes_.push_back(std::move(set));
    }
    const auto sets = std::span(strokes_).subspan(first);
    for (StrokeSet& set : sets) share_tone(sets, one_tone, set);
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].hatched = std::any_of(strokes_.begin(), strokes_.end(),
                                    [&](const StrokeSet& set) { return set.parts[i]; });
  }
  std::erase_if(strokes_, [](const StrokeSet& set) {
    return std::find(set.parts.begin(), set.parts.end(), true) == set.parts.end();
  });
}

bool PartStyles::any_transparent() const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [](const One& one) { return one.transparent && one.drawn; });
}

std::vector<double> PartStyles::meeting_ranks(std::span<const double> sizes) const {
  struct Shown {
    std::array<double, 2> ink;
    bool own;
    auto operator<=>(const Shown&) const = default;
  };
  std::vector<Shown> shown;
  for (const Style* style : styles_) {
    shown.push_back({ink_of_lines(*style, *styles_.front()), style != styles_.front()});
  }
  std::vector<double> ranks;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const One& one = parts_[i];
    const auto below =
        std::ranges::count_if(shown, [&](const Shown& s) { return s < shown[one.style]; });
    ranks.push_back(2 * static_cast<double>(below) + (one.transparent ? 0 : 1));
  }
  const std::vector<double> smaller = small_first(sizes);
  for (std::size_t i = 0; i < smaller.size(); ++i) ranks[i] += smaller[i];
  if (std::ranges::adjacent_find(ranks, std::ranges::not_equal_to{}) == ranks.end()) return {};
  return ranks;
}

std::size_t leave_out(const Scene& scene, const PluginError& failed, IllustrateOptions& options) {
  if (failed.row() != PluginError::Row::Form) return 0;
  std::size_t count = 0;
  options.part_styles.resize(std::max(options.part_styles.size(), scene.parts.size()));
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (scene.parts[i].plugin_form != failed.name()) continue;
    count += options.part_styles[i].drawn ? 1 : 0;
    options.part_styles[i].drawn = false;
  }
  return count;
}

}  // namespace burin::detail

namespace burin {

std::vector<std::string> selectors_of(const HatchStyle& hatch) {
  std::vector<std::string> selectors;
  const std::string& all = hatch.select;
  if (all == HatchStyle().select) return selectors;
  for (std::size_t begin = 0; begin <= all.size();) {
    const std::size_t end = std::min(all.find(';', begin), all.size());
    selectors.push_back(all.substr(begin, end - begin));
    begin = end + 1;
  }
  return selectors;
}

}  // namespace burin
