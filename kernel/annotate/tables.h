#pragma once
// What stands in corners of the sheet beside the drawing; internal to the module.

#include <burin/annotate/annotate.h>

#include "legend.h"
#include "list_on_sheet.h"
#include "title_block.h"

#include <optional>

namespace burin::detail {

struct Tables {
  std::optional<TitleBlockPlan> block = {};
  /// On the block.
  std::optional<ListPlan> list = {};
  /// In what both leave.
  std::optional<LegendPlan> legend = {};
  /// What all leave of the frame.
  Box2 rest;

  /// Whether all that is asked for has room.
  bool fit(const Annotations& annotations) const;
};

Tables plan_tables(const Annotations& annotations, const CalloutOptions& style, const Paper& paper);

/// Lays them over a drawing; tells of what has no room, and of characters that the font has not.
void lay_tables(const Tables& tables, const Annotations& annotations, const CalloutOptions& style,
                Drawing& drawing);

}  // namespace burin::detail
