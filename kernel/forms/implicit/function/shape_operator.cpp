#include "shape_operator.h"

#include <burin/surface/tangent_basis.h>

#include <cmath>

namespace burin {
namespace {

// Share of |k1|+|k2| below which directions are rounding.
constexpr double kUmbilic = 1e-7;
// Sizes of the part that a radius of curvature may have before the surface counts as flat.
constexpr double kFlat = 1000;

// The shape operator in a tangent basis: mean plus deviator (cos 2a, sin 2a) (k1-k2)/2.
struct ShapeOperator {
  double mean = 0;
  Vec2 deviator{0};
};

ShapeOperator shape(const Gradient2& g, const TangentBasis& basis, double slope) {
  const Vec3 hx = g.hessian_times(basis.x), hy = g.hessian_times(basis.y);
  const double a = glm::dot(basis.x, hx) / slope, b = glm::dot(basis.y, hx) / slope,
               c = glm::dot(basis.y, hy) / slope;
  return {0.5 * (a + c), {0.5 * (a - c), b}};
}

}  // namespace

Frame implicit_frame(const Gradient2& g, Vec3 position, Vec3 fallback_normal, double size) {
  Frame f;
  f.position = position;
  const double slope = glm::length(g.gradient);
  f.normal = normalize_or(g.gradient, fallback_normal);
  const TangentBasis basis(f.normal);
  f.d1 = basis.x;
  f.d2 = basis.y;
  const ShapeOperator s = slope > 0 ? shape(g, basis, slope) : ShapeOperator{};
  const double half = glm::length(s.deviator);
  if (!std::isfinite(s.mean) || !std::isfinite(half)) return f;
  f.k1 = s.mean + half;
  f.k2 = s.mean - half;
  const double sum = std::abs(f.k1) + std::abs(f.k2);
  if (sum * kFlat * size < 1 || !(2 * half > kUmbilic * sum)) return f;
  f.d1 = basis.vector(complex_sqrt(s.deviator / half));
  f.d2 = glm::cross(f.normal, f.d1);
  f.confidence = 2 * half / sum;
  f.umbilic = false;
  return f;
}

double largest_curvature(const Gradient2& g) {
  const double slope = glm::length(g.gradient);
  if (!(slope > 0)) return 0;
  const ShapeOperator s = shape(g, TangentBasis(g.gradient / slope), slope);
  return std::abs(s.mean) + glm::length(s.deviator);
}

}  // namespace burin
