#pragma once
// The legend of colours on the sheet; internal to the module.

#include <burin/annotate/annotate.h>

#include "blocks.h"

#include <optional>

namespace burin::detail {

struct LegendPlan : BlockPlan {
  /// Paper mm of a row, of the side of a square, and of a square with the name beside it.
  double row = 0, square = 0, block = 0;
};

/// Nothing where no row of a legend is seen or all its rows have no room. Those that are seen keep
/// to the box that all would take.
std::optional<LegendPlan> plan_legend(const Annotations& annotations, const CalloutOptions& style,
                                      const Box2& frame);

/// Lays the squares over the areas, and the layer "legend": their borders and the names.
void lay_legend(const LegendPlan& plan, const Annotations& annotations, const CalloutOptions& style,
                Drawing& drawing);

}  // namespace burin::detail
