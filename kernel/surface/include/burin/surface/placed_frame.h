#pragma once
/// Local geometry after an affine map.

#include <burin/base/placement.h>
#include <burin/surface/surface.h>

namespace burin {

/// The frame of the placed surface, from that of the surface: the second fundamental form goes over
/// into that of the mapped tangents, divided by how long the normal becomes; its principal
/// directions are others than the mapped ones. A plane stays one, other kinds become Freeform
/// unless all lengths grow alike. @cite doCarmo1976
Frame placed(const Placement& by, const Frame& frame);

}  // namespace burin
