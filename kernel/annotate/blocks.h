#pragma once
// Blocks of rows in a corner of the sheet, beside the drawing; internal to the module.

#include <burin/annotate/options.h>
#include <burin/base/box.h>

#include <cstddef>
#include <optional>

namespace burin::detail {

/// Of a list on the sheet: heights of letters that its widest name may take.
constexpr double kWidestName = 24;
constexpr double kRounding = 1e-6;  // paper mm

/// Where rows stand and how they are parted: blocks of them beside each other.
struct BlockPlan {
  Box2 box{};
  std::size_t blocks = 1, rows = 1;
  /// What is left of the frame for the drawing: beside the blocks, or above or below them.
  Box2 rest{};
};

/// What a table is made of: paper mm of a row and of a block, rows, and those of its heading.
struct BlockSizes {
  double row = 0, block = 0;
  std::size_t rows = 1, heading = 0;
};

/// The scale at which what has that width and height fits into some room; where they are 0, not
/// known, the root of its area.
double scale_in(Vec2 room, Vec2 shape);

/// Places a table so that a drawing of that width and height (any unit) comes out as large as can
/// be, of equal ones where most of the frame is left. Nothing where it would take more than 70 % of
/// the frame's width and height.
std::optional<BlockPlan> place_blocks(const BlockSizes& sizes, Corner corner, const Box2& frame,
                                      Vec2 shape);

/// Places a table in the box of one that has as many rows or more, and blocks as wide or wider: as
/// if it had the frame for itself where that stays in the box, else in as few blocks as fit its
/// height.
BlockPlan place_within(const BlockPlan& kept, const BlockSizes& sizes, Corner corner,
                       const Box2& frame, Vec2 shape);

}  // namespace burin::detail
