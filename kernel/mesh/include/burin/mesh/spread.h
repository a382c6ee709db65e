#pragma once
/// Points that lie evenly in triangles.

#include <burin/base/vec.h>

#include <cmath>
#include <cstddef>

namespace burin {

/// The barycentric coordinates of point `n` of a sequence each of whose beginnings fills a triangle
/// evenly: the lattice of the plastic number, folded along the diagonal of the unit square.
inline Vec3 spread_bary(std::size_t n) {
  constexpr double kFirstStep = 0.7548776662466927, kSecondStep = 0.5698402909980532;
  const double step = static_cast<double>(n) + 0.5;
  double u = step * kFirstStep - std::floor(step * kFirstStep);
  double v = step * kSecondStep - std::floor(step * kSecondStep);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return {1 - u - v, u, v};
}

}  // namespace burin
