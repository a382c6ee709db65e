#include <burin/forms/charted/continuity.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

// Share of the larger curvature by which both sides may differ: the rounding of files, and of
// splines that stand for circles.
constexpr double kAlike = 0.01;
// Sizes of the part: surfaces of larger radius count as flat, as chart_frame has it.
constexpr double kFlatRadius = 1000;

// The normal curvature along a unit tangent.
double bend_along(const Frame& f, Vec3 t) {
  const double x = glm::dot(t, f.d1), y = glm::dot(t, f.d2);
  return f.k1 * x * x + f.k2 * y * y;
}

}  // namespace

bool bends_alike(const SurfaceDerivatives& a, Vec3 normal_a, const SurfaceDerivatives& b,
                 Vec3 normal_b, double size) {
  if (normal_a == Vec3(0) || normal_b == Vec3(0)) return true;
  const Frame f = chart_frame(a, normal_a, FaceKind::Freeform, size);
  const Frame g = chart_frame(b, normal_b, FaceKind::Freeform, size);
  const double most = std::max({std::abs(f.k1), std::abs(f.k2), std::abs(g.k1), std::abs(g.k2)});
  const double limit = kAlike * most + 1 / (kFlatRadius * size);
  // Two quadratic forms are one where they agree in three directions.
  const Vec3 x = any_orthogonal(normal_a), y = glm::cross(normal_a, x);
  for (const Vec3 t : {x, y, (x + y) * std::sqrt(0.5)}) {
    if (std::abs(bend_along(f, t) - bend_along(g, t)) > limit) return false;
  }
  return true;
}

}  // namespace burin
