#pragma once
/// One trimming loop, closed.

#include <burin/converters/trimmed_faces.h>

#include "trim_loops.h"

#include <vector>

namespace burin {

struct LoopDomain {
  Vec2 min, max;
};

struct ClosedLoop {
  LoopCurves curves;
  /// Points of the curves in the unit square that the domain is mapped to.
  std::vector<Vec2> polygon;
  Vec2 min{0}, max{0};
  double area = 0;  // positive where it turns counter-clockwise
  TextPlace place;

  /// Turns it the other way where it does not turn as asked for.
  void turn(bool counter_clockwise);
};

/// Joins the ends of the curves and cuts them at corners. Throws GeometryError that says why that
/// is no loop in the domain.
ClosedLoop close_loop(const TrimLoop& loop, const LoopDomain& domain);

}  // namespace burin
