#pragma once
/// Meshes of implicit functions: surface nets, then vertices spread evenly and set onto the zero
/// set by Newton steps.

#include "kit.h"

#include <algorithm>
#include <cmath>

namespace burin::samples {

/// Negative inside.
using Field = std::function<double(Vec3)>;

/// The zero set inside the box, with triangles of about `cell` mm. The field must be smooth near
/// its zero set.
TriMesh mesh_implicit(const Field& field, Vec3 low, Vec3 high, double cell);

/// The union, intersection and difference of fields, rounded over about `k` mm.
inline double smooth_min(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * h * k / 6;
}
inline double smooth_max(double a, double b, double k) { return -smooth_min(-a, -b, k); }

double sphere(Vec3 p, Vec3 center, double radius);
double ellipsoid(Vec3 p, Vec3 center, Vec3 half);
/// A capsule whose radius goes from `ra` at `a` to `rb` at `b`.
double limb(Vec3 p, Vec3 a, Vec3 b, double ra, double rb);
double round_box(Vec3 p, Vec3 center, Vec3 half, double radius);
/// Torus about the axis z through `center`.
double torus(Vec3 p, Vec3 center, double major, double minor);

}  // namespace burin::samples
