#include "split_parts.h"

#include <burin/arrange/arrange.h>
#include <burin/assembly/pieces.h>
#include <burin/assembly/select.h>
#include <burin/illustrate/stroke_selectors.h>

#include <algorithm>
#include <string>

namespace burin {
namespace {

using Strings = std::vector<std::string>;

void append(Strings& all, const Strings& selectors) {
  all.insert(all.end(), selectors.begin(), selectors.end());
}

void append_strokes(Strings& all, const Style& style) {
  for (std::size_t n = 1; n <= stroke_kind_count(style); ++n) {
    append(all, selectors_of(hatch_of(style, n)));
  }
}

/// All by which an illustration chooses parts.
Strings selectors_of(const Illustration& illustration) {
  Strings all = illustration.only;
  append_strokes(all, illustration.style);
  for (const Look& look : illustration.looks) {
    append(all, look.select);
    if (look.style) append_strokes(all, *look.style);
  }
  for (const Section& section : illustration.sections)
    append(all, section.exclude.value_or(Strings()));
  append(all, illustration.uncut.value_or(Strings()));
  for (const ExplodeStep& step : illustration.explode.steps) append(all, step.move);
  if (!illustration.explode.base.empty()) all.push_back(illustration.explode.base);
  for (const DetailView& detail : illustration.details) append(all, detail.select);
  for (const ThreadRow& thread : illustration.thread_rows) append(all, thread.select);
  for (const ArrowRow& arrow : illustration.arrows) append(all, arrow.select);
  for (const auto* rows : {&illustration.dimensions, &illustration.note_rows}) {
    for (const DimensionRow& row : *rows) {
      for (const FeatureRow& feature : row.of) {
        if (!feature.part.empty()) all.push_back(feature.part);
      }
    }
  }
  return all;
}

/// Parts of which a look says whether they can be looked through.
std::vector<bool> with_own_transparency(const Scene& scene, const Illustration& illustration) {
  std::vector<bool> own(scene.parts.size(), false);
  for (const Look& look : illustration.looks) {
    if (!look.transparent) continue;
    for (const std::string& selector : look.select) {
      for (const std::size_t part : select(scene, selector)) own[part] = true;
    }
  }
  return own;
}

}  // namespace

namespace detail {

void split_glazed(Scene& scene, Illustration& illustration, std::vector<Vec3>& moves) {
  std::vector<PartStyle>& styles = illustration.illustrate.part_styles;
  const std::size_t count = scene.parts.size();
  const std::vector<bool> own = with_own_transparency(scene, illustration);
  const std::vector<std::size_t> of = split_pieces(scene, {}, true);
  styles.resize(count);
  std::vector<bool> split(count, false);
  const auto glaze = [&](std::size_t body, std::size_t whole) {
    if (own[whole]) return;
    const bool clear = scene.parts[body].opacity < 1;
    styles[body].transparent = clear;
    if (clear) styles[body].hatched = false;
  };
  for (std::size_t k = 0; k < of.size(); ++k) {
    styles.push_back(styles[of[k]]);
    moves.push_back(moves[of[k]]);
    split[of[k]] = true;
  }
  for (std::size_t k = 0; k < of.size(); ++k) glaze(count + k, of[k]);
  for (std::size_t i = 0; i < count; ++i) {
    if (split[i]) glaze(i, i);
  }
}

}  // namespace detail

void split_parts(Scene& scene, const Illustration& illustration, std::vector<PartStyle>& styles) {
  const std::size_t count = scene.parts.size();
  styles.resize(std::max(styles.size(), count));
  std::vector<PartStyle> bodies;
  Strings selectors = selectors_of(illustration);
  name_items(scene, illustration.numbers, selectors);
  // A part alone comes apart into its bodies, or nothing would.
  const bool apart = illustration.explode.wanted && count == 1;
  if (apart) selectors.emplace_back("*/*");
  // What is exploded is parts, not bodies: a part of glass and metal is split once all have moved.
  for (const std::size_t whole : split_pieces(scene, selectors, !illustration.explode.wanted)) {
    bodies.push_back(styles[whole]);
  }
  if (apart) std::ranges::for_each(scene.parts, [](Part& body) { body.whole.reset(); });
  styles.insert(styles.begin() + static_cast<std::ptrdiff_t>(count), bodies.begin(), bodies.end());
}

}  // namespace burin
