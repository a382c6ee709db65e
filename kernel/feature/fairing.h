#pragma once
// Contours as the smooth lines that their points are samples of.

#include <burin/base/curve.h>
#include <burin/camera/camera.h>
#include <burin/mesh/proxy_mesh.h>

namespace burin {

/// Puts points between those of a contour, on the cubic through its neighbours, wherever the
/// straight segment is farther than kRoundness from it on paper. Given points stay; corners stay
/// corners. All arrays of the curve are kept in step. The cubic leaves a segment by no more than
/// the chord errors of its triangle let it: over flat facets lines are straight.
void fair(Curve3& curve, const Camera& camera, const ProxyMesh& proxy);

/// The same of an edge of the input, whose points lie on it; `most`: model mm that it may lie
/// beside its segments.
void fair(Curve3& curve, const Camera& camera, double most);

}  // namespace burin
