#pragma once
/// Which visible pieces are the outer outline.

#include <burin/base/curve.h>

#include "pieces.h"

#include <vector>

namespace burin {

/// Cuts the visible pieces of an occluding curve where any feature meets it in the picture and
/// marks those with nothing but paper on one side. `seen`: the cutters that can be seen. `number`:
/// the curve's number among the cutters, or -1.
std::vector<TrackPiece> find_outer(const Probe& probe, const Cutters& cutters, const Cutters& seen,
                                   const Curve3& curve, const Track& track, std::int32_t number,
                                   const std::vector<TrackPiece>& pieces, double minimum,
                                   double same_cut, Scratch& scratch);

}  // namespace burin
