#pragma once
/// Lines that lie on each other become one line.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>

#include <vector>

namespace burin {

/// Paper mm within which lines that run the same way are one: a fifth of a thin pen's
/// width.
inline constexpr double kSameLine = 0.035;

/// Leaves one line at each place of the sheet: of lines that lie within `kSameLine` of each other
/// and run the same way the first in the order of ISO 128-2 stays: visible before hidden, hidden in
/// full before dashed, then trails, centre lines last; then wide before narrow; then as the layers
/// are painted, the last first. What it stands for is added to `Path::also`. A line that lies on
/// another for a part of its length is cut there; stretches of less than 0.2 mm between others
/// stay, as those are where lines cross at a small angle, and specks that would be left of a line
/// go with it. Layers of strokes and patterns are left alone. Lines stay in their layers and in
/// their order. Throws Cancelled. Cost: 1 us a segment.
/// @cite ISO128part2
void keep_one_line(std::vector<Layer>& layers, const RunContext& context);

}  // namespace burin
