#pragma once
// Contours as the smooth lines that their points are samples of.

#include <burin/base/curve.h>
#include <burin/camera/camera.h>

#include <limits>

namespace burin {

/// Puts points between those of a contour, on the cubic through its neighbours, wherever the
/// straight segment is farther than kRoundness from it on paper. Given points stay; corners stay
/// corners. All arrays of the curve are kept in step. `most`: model mm that the exact line may lie
/// beside its segments, where that is known, which is as far as the cubic goes.
void fair(Curve3& curve, const Camera& camera,
          double most = std::numeric_limits<double>::infinity());

}  // namespace burin
