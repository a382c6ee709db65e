#pragma once
/// Which visible pieces are the outer outline.

#include <burin/base/curve.h>

#include "pieces.h"

#include <vector>

namespace burin {

/// Cuts the visible pieces of an occluding curve where any feature meets it in the picture and
/// marks those with nothing but paper on one side.
std::vector<Piece> find_outer(const Probe& probe, const Cutters& cutters, const Track& track,
                              const std::vector<Piece>& pieces, double minimum, Scratch& scratch);

}  // namespace burin
