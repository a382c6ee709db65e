#include "blocks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin::detail {
namespace {

constexpr std::size_t kMostBlocks = 12;
constexpr double kTallest = 0.6;  // share of the frame that one block takes before there are two
constexpr double kLeast = 0.3;    // share of the frame that the drawing keeps

Box2 in_corner(Corner corner, Vec2 size, const Box2& frame) {
  const bool right = corner == Corner::BottomRight || corner == Corner::TopRight;
  const bool top = corner == Corner::TopRight || corner == Corner::TopLeft;
  const double x = right ? frame.max.x - size.x : frame.min.x;
  const double y = top ? frame.max.y - size.y : frame.min.y;
  return {{x, y}, {right ? frame.max.x : x + size.x, top ? frame.max.y : y + size.y}};
}

/// What is left beside a box in a corner of the frame, or else above or below it.
Box2 rest_of(const Box2& box, bool beside, const Box2& frame) {
  Box2 rest = frame;
  if (beside && box.max.x == frame.max.x) {
    rest.max.x = box.min.x - kApart;
  } else if (beside) {
    rest.min.x = box.max.x + kApart;
  } else if (box.min.y == frame.min.y) {
    rest.min.y = box.max.y + kApart;
  } else {
    rest.max.y = box.min.y - kApart;
  }
  return rest;
}

bool holds(const Box2& outer, const Box2& inner) {
  return outer.contains(inner.min) && outer.contains(inner.max);
}

Vec2 size_of(const BlockPlan& plan, const BlockSizes& sizes) {
  return {static_cast<double>(plan.blocks) * sizes.block,
          static_cast<double>(plan.rows + sizes.heading) * sizes.row};
}

}  // namespace

double scale_in(Vec2 box, Vec2 shape) {
  const bool known = shape.x > 0 && shape.y > 0;
  return known ? std::min(box.x / shape.x, box.y / shape.y) : std::sqrt(box.x * box.y);
}

std::optional<BlockPlan> place_blocks(const BlockSizes& sizes, Corner corner, const Box2& frame,
                                      Vec2 shape) {
  const std::size_t n = std::max<std::size_t>(sizes.rows, 1);
  const Vec2 size = frame.size();
  std::optional<BlockPlan> best;
  std::pair<double, double> most(0, 0);
  double most_height = 0;
  for (std::size_t blocks = 1; blocks <= std::min(kMostBlocks, n); ++blocks) {
    BlockPlan plan{.blocks = blocks, .rows = (n + blocks - 1) / blocks};
    const Vec2 taken = size_of(plan, sizes);
    if (taken.x > size.x || taken.y > size.y) continue;
    // More blocks only where fewer are too tall: a table is read downwards.
    if (best && most_height <= kTallest * size.y) break;
    plan.box = in_corner(corner, taken, frame);
    for (const bool beside : {true, false}) {
      plan.rest = rest_of(plan.box, beside, frame);
      const Vec2 rest = plan.rest.size();
      if (rest.x < kLeast * size.x || rest.y < kLeast * size.y) continue;
      const std::pair<double, double> now(scale_in(rest, shape), rest.x * rest.y);
      if (now <= most) continue;
      most = now;
      most_height = taken.y;
      best = plan;
    }
  }
  return best;
}

BlockPlan place_within(const BlockPlan& kept, const BlockSizes& sizes, Corner corner,
                       const Box2& frame, Vec2 shape) {
  const auto alone = place_blocks(sizes, corner, frame, shape);
  if (alone && holds(kept.box, alone->box) && holds(alone->rest, kept.rest)) return *alone;
  BlockPlan plan = kept;
  plan.blocks = (sizes.rows + kept.rows - 1) / kept.rows;
  plan.rows = (sizes.rows + plan.blocks - 1) / plan.blocks;
  plan.box = in_corner(corner, size_of(plan, sizes), kept.box);
  return plan;
}

}  // namespace burin::detail
