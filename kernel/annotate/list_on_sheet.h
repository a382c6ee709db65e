#pragma once
// The parts list on the sheet; internal to the module.

#include <burin/annotate/annotate.h>
#include <burin/base/box.h>

#include "blocks.h"

#include <optional>
#include <span>

namespace burin::detail {

/// Blocks of rows, from the right.
struct ListPlan : BlockPlan {
  /// Paper mm of a row, and of the columns of number, quantity and name.
  double row = 0, number = 0, quantity = 0, name = 0;
  /// From the top of the box down, as on a sheet of its own.
  bool downwards = false;

  double block() const { return number + quantity + name; }
};

/// A plan with the widths of columns and the height of rows alone.
ListPlan columns_of(std::span<const DrawingItem> items, const CalloutOptions& style);

/// Nothing where it would take more than 70 % of the frame's width and height.
std::optional<ListPlan> plan_list(const Annotations& annotations, const CalloutOptions& style,
                                  const Box2& frame);

/// The layer "parts_list".
Layer list_layer(std::span<const DrawingItem> items, const CalloutOptions& style,
                 const ListPlan& plan);

}  // namespace burin::detail
