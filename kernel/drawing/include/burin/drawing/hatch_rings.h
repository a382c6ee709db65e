#pragma once
/// Parallel lines over an area of the sheet.

#include <burin/base/vec.h>

#include <span>
#include <utility>
#include <vector>

namespace burin {

/// Stretches of straight lines inside an odd number of closed rings (paper mm), at an angle to the
/// horizontal in degrees and so far from line to line. The lines of all areas of a sheet are the
/// same ones: one passes through its corner. Two neighbours run in opposite directions, as a pen
/// likes it. Areas of more than 20,000 lines have wider ones. Cost: the lines times the edges over
/// each.
std::vector<std::pair<Vec2, Vec2>> hatch_rings(std::span<const std::vector<Vec2>> rings,
                                               double degrees, double distance);

}  // namespace burin
