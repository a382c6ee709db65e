#pragma once
/// Lines that turn where the families of a cross field would change places.

#include "constraints.h"

#include <vector>

namespace burin::field {

/// A cross field cannot name its two arms throughout: between singularities of odd index a cut is
/// left along which the lines of family 1 (`line`, see choose_family) meet at a right angle. In a
/// band around each cut the lines are solved for anew as a field of their own (directions to the
/// second power), in which they turn that right angle smoothly. Half the band is as wide as half
/// the cut's extent, up to a share of the region; near the cut curvature pulls less. Outside the
/// bands nothing changes; lines of exact faces keep their full pull. Two odd singularities at the
/// ends of a cut become even ones, or cancel. Linear in the number of links but for the order of
/// distances inside the bands; the same for any number of threads.
void bend_over_cuts(const ProxyMesh& proxy, const WedgeGraph& graph, const Constraints& targets,
                    std::vector<Vec2>& line, const RunContext& context);

}  // namespace burin::field
