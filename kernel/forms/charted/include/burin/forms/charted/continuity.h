#pragma once
/// How smoothly two charts meet.

#include <burin/forms/charted/chart.h>

namespace burin {

/// Degrees between the normals of two faces from which their edge is sharp: below, ink would not
/// show the kink (kernel/forms/patches/README.md).
inline constexpr double kSharpAngle = 1;

/// Whether both sides of a smooth edge bend alike at a point of it: the second fundamental forms
/// agree within 1 % of the larger curvature (or are flat against `size`, the size of the part in
/// model mm). An edge that is so all along divides one surface: the halves of a cylinder, the
/// patches of a spline. Normals are the outward ones of either side; true at degenerate places.
bool bends_alike(const SurfaceDerivatives& a, Vec3 normal_a, const SurfaceDerivatives& b,
                 Vec3 normal_b, double size);

}  // namespace burin
