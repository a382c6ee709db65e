#pragma once
/// A drawing of a whole view made into that of a broken one.

#include <burin/drawing/drawing.h>
#include <burin/drawing/paper_breaks.h>

#include <span>
#include <vector>

namespace burin {

/// Cuts lines and areas at the sides of the bands, leaves out what is between and moves the rest
/// together. Straight centre lines along the way of the bands go on through the gaps; what is laid
/// over a drawing (lines of kind Leader and Frame, areas with a role) is where it belongs already.
/// `edge`: as in `Strip`. Areas that lose all of their rings are gone, strokes are counted anew.
void break_up(const PaperBreaks& breaks, std::span<const Vec2> edge, Drawing& drawing);
void break_up(const PaperBreaks& breaks, std::span<const Vec2> edge, std::vector<Area>& areas);

}  // namespace burin
