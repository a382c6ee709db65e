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
constexpr double kApart = 5;        // paper mm between tables and the drawing

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

/// The largest scale at which a drawing of the size `shape` fits into a box of the size `box`. If
/// the shape is not known (0): the root of the box's area.
double scale_in(Vec2 box, Vec2 shape);

/// Places a table so that a drawing of the size `shape` (any unit) beside it is as large as
/// possible; of equal places the one that leaves most of the frame. Nothing where the table would
/// take more than 70 % of the frame's width and height.
std::optional<BlockPlan> place_blocks(const BlockSizes& sizes, Corner corner, const Box2& frame,
                                      Vec2 shape);

/// Places a table in the box of one that has as many rows or more, and blocks as wide or wider: as
/// if it had the frame for itself where that stays in the box, else in as few blocks as fit its
/// height.
BlockPlan place_within(const BlockPlan& kept, const BlockSizes& sizes, Corner corner,
                       const Box2& frame, Vec2 shape);

}  // namespace burin::detail
