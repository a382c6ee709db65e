#pragma once
// A leader with what stands at its end; internal to the module.

#include "layout.h"

#include <functional>
#include <limits>

namespace burin::detail {

/// What stands behind the elbow of a leader: letters over its shelf, or a label.
struct LeaderEnd {
  /// Lays it, to the right (1) or to the left (-1); adds to the cost what it costs.
  std::function<void(Vec2 elbow, double side, DimensionPlace& out)> lay;
};

struct Leader {
  Vec2 tip{0};
  /// Unit, away from the tip.
  Vec2 way{1, 0};
  LeaderTarget::Mark mark = LeaderTarget::Mark::Arrow;
  SourceId source = {};
};

/// A piece of a leader or its shelf.
void add_leader_piece(Vec2 a, Vec2 b, const SourceId& source, double width, DimensionPlace& out);
/// The dot or the arrow at a tip, from which the line was added last.
void add_mark(const Leader& leader, const DimensionOptions& style, DimensionPlace& out);

/// Out of the drawing, and on until what stands at its end lies on nothing.
/// `limit`: as of `first_free`.
DimensionPlace leader_place(const Leader& leader, const LeaderEnd& end,
                            const DimensionGround& ground,
                            double limit = std::numeric_limits<double>::infinity());

}  // namespace burin::detail
