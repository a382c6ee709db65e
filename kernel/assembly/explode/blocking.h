#pragma once
// Which part blocks which; internal to the module.

#include <burin/base/run_context.h>
#include <burin/visibility/occluder.h>

#include "shapes.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace burin::detail {

/// What lies in the column over and under a part's box: another part, from where to where.
struct Column {
  std::uint32_t part = 0;
  double from = 0, to = 0;
};

/// Of one axis: its frame, the boxes of all parts in it, and who is ahead of whom.
struct AxisView {
  Mat3 rows{1};
  std::vector<Box3> boxes;
  /// (a, b), ascending: b stands in a's way along the axis, and a in b's way back.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ahead;

  /// For each part the others in its column, ascending; the column is a sixteenth wider than the
  /// box all round, so that what touches it from the side lies in it.
  std::vector<std::vector<Column>> columns;

  Vec3 axis() const { return rows[2]; }
  /// Null where the part does not lie in the column.
  const Column* column(std::size_t of, std::size_t part) const;
};

/// How far two parts may lie in each other, model mm.
double fit_of(const Shapes& shapes, std::size_t a, std::size_t b, std::optional<double> fit);

/// By rays along the axis over the box of each part: b is ahead of a where on a ray, and on the
/// eight around it as far away as parts may lie in each other, its end is farther than a's
/// beginning.
AxisView look_along(Vec3 axis, const Shapes& shapes, const Occluder& occluder,
                    std::optional<double> fit, const RunContext& context);

/// By boxes: b is ahead of a where they overlap across the axis and its middle is farther.
AxisView boxes_along(Vec3 axis, const Shapes& shapes, std::optional<double> fit,
                     const RunContext& context);

}  // namespace burin::detail
