#include "split_parts.h"

#include <burin/assembly/pieces.h>
#include <burin/illustrate/stroke_selectors.h>

#include <algorithm>
#include <string>

namespace burin::detail {
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

/// All by which a plan chooses parts.
Strings selectors_of(const DrawPlan& plan) {
  Strings all = plan.only;
  append_strokes(all, plan.style);
  for (const DrawPlan::PlannedLook& look : plan.looks) {
    append(all, look.look.select);
    if (look.style) append_strokes(all, *look.style);
  }
  for (const Section& section : plan.sections) append(all, section.exclude.value_or(Strings()));
  append(all, plan.uncut.value_or(Strings()));
  for (const Explode::Step& step : plan.explode.steps) append(all, step.move);
  if (!plan.explode.base.empty()) all.push_back(plan.explode.base);
  for (const DetailView& detail : plan.details) append(all, detail.select);
  return all;
}

}  // namespace

void split_parts(Scene& scene, const DrawPlan& plan, std::vector<PartStyle>& styles) {
  const std::size_t count = scene.parts.size();
  styles.resize(std::max(styles.size(), count));
  std::vector<PartStyle> bodies;
  Strings selectors = selectors_of(plan);
  // A part alone comes apart into its bodies, or nothing would.
  const bool apart = plan.explode.wanted && count == 1;
  if (apart) selectors.emplace_back("*/*");
  // What is exploded is parts, not bodies: there a part of glass and metal stays in one piece.
  for (const std::size_t whole : split_pieces(scene, selectors, !plan.explode.wanted)) {
    bodies.push_back(styles[whole]);
  }
  if (apart) std::ranges::for_each(scene.parts, [](Part& body) { body.whole.reset(); });
  styles.insert(styles.begin() + static_cast<std::ptrdiff_t>(count), bodies.begin(), bodies.end());
}

}  // namespace burin::detail
