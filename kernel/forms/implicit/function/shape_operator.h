#pragma once
// Curvature from gradient and Hessian.

#include <burin/forms/implicit/implicit_function.h>
#include <burin/surface/surface.h>

namespace burin {

/// Principal curvatures and directions at a point of f = 0: eigenvectors of the Hessian restricted
/// to the tangent plane, over the gradient's length. Confidence as in chart_frame:
/// |k1-k2| / (|k1|+|k2|), 0 at umbilics and where the surface is flat (radius over 1000 `size`).
/// @cite Goldman2005, Monga1992
Frame implicit_frame(const Gradient2& g, Vec3 position, Vec3 fallback_normal, double size);

/// The larger of |k1| and |k2|.
double largest_curvature(const Gradient2& g);

}  // namespace burin
