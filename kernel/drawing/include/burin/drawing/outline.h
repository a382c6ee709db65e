#pragma once
/// The area that a stroke of varying width covers.

#include <burin/base/vec.h>
#include <burin/drawing/bezier.h>

#include <span>
#include <vector>

namespace burin {

/// The outline of an open stroke as closed chains of cubics whose union, by the nonzero rule (all
/// run the same way round), is the stroke: both sides half the width away from the centre line. Its
/// ends are points where the width vanishes, else round noses that end exactly where the line does:
/// no ink passes the ends. The sides keep within `tolerance` mm of the exact ones. One chain is the
/// rule; where the line turns by more than 30 degrees at a point, or curls tighter than half its
/// width, it is cut in two chains with round ends, so that no loop, spike or hole shows. `widths`
/// has one entry per point; negative ones count as 0. Fewer than two different points give no
/// chain. Cost: about 0.3 us per point.
std::vector<std::vector<CubicBezier>> stroke_outline(std::span<const Vec2> points,
                                                     std::span<const double> widths,
                                                     double tolerance);

}  // namespace burin
