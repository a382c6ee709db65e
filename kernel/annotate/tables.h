#pragma once
// What stands in corners of the sheet beside the drawing; internal to the module.

#include <burin/annotate/annotate.h>

#include "legend.h"
#include "list_on_sheet.h"

#include <optional>

namespace burin::detail {

struct Tables {
  std::optional<ListPlan> list;
  /// In what the list leaves.
  std::optional<LegendPlan> legend;
  /// What both leave of the frame.
  Box2 rest;

  /// Whether all that is asked for has room.
  bool fit(const Annotations& annotations) const;
};

Tables plan_tables(const Annotations& annotations, const CalloutOptions& style, const Box2& frame);

/// Lays them over a drawing; tells of what has no room, and of characters that the font has not.
void lay_tables(const Tables& tables, const Annotations& annotations, const CalloutOptions& style,
                Drawing& drawing);

}  // namespace burin::detail
