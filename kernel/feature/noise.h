#pragma once
// Which closed contours are noise.

#include <burin/base/curve.h>

#include "facing.h"

namespace burin {

/// Whether a closed contour inside one smooth region shows no shape: the surface on one side of it
/// is a patch that never turns further through edge-on than the limits say. Costs no more than some
/// multiple of the curve's own triangles.
bool is_noise(const Facing& facing, const Curve3& contour);

}  // namespace burin
