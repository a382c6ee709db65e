#pragma once
// Contours as the smooth lines that their points are samples of.

#include <burin/base/curve.h>
#include <burin/camera/camera.h>

namespace burin {

/// Puts points between those of a contour, on the cubic through its neighbours, wherever the
/// straight segment is farther than kRoundness from it on paper. Given points stay; corners stay
/// corners. All arrays of the curve are kept in step.
void round_off(Curve3& curve, const Camera& camera);

}  // namespace burin
