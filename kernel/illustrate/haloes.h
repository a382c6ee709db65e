#pragma once
// Which stretches of the lines of a drawing haloes take; internal to the module.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/visibility/halo.h>
#include <burin/visibility/visible_spans.h>

#include "compose.h"

#include <span>
#include <vector>

namespace burin::detail {

using Gaps = std::vector<HaloGap>;

/// The gaps of each curve; empty where the style has no haloes.
struct Haloes {
  std::vector<Gaps> features, strokes;
};

Haloes find_haloes(const LinesToDraw& lines, const Composition& how, const RunContext& context);

/// The stretches of `span` that its curve's gaps leave, in order; on a closed curve of `count`
/// segments the span, and what is left of it, may run past the end.
std::vector<Span> without(const Span& span, const Gaps& gaps, bool closed, double count);

}  // namespace burin::detail
