#include <burin/base/affine.h>
#include <burin/surface/placed_frame.h>
#include <burin/surface/tangent_basis.h>

#include <cmath>

namespace burin {
namespace {

/// Share of |k1|+|k2| below which the difference is rounding.
constexpr double kUmbilic = 1e-7;

}  // namespace

Frame placed(const Placement& by, const Frame& frame) {
  const Mat3 back = glm::inverse(by.linear);
  const Vec3 normal = glm::transpose(back) * frame.normal;
  const double grown = glm::length(normal);
  Frame f = frame;
  f.position = by.point(frame.position);
  f.du = by.vector(frame.du), f.dv = by.vector(frame.dv);
  if (frame.kind != FaceKind::Plane && !is_similar(by)) f.kind = FaceKind::Freeform;
  f.normal = normal / grown;
  const TangentBasis basis(
      f.normal, normalize_or(reject(by.vector(frame.d1), f.normal), any_orthogonal(f.normal)));
  f.d1 = basis.x, f.d2 = basis.y;
  const Vec3 x = back * basis.x, y = back * basis.y;
  const auto form = [&](Vec3 a, Vec3 b) {
    return (frame.k1 * glm::dot(a, frame.d1) * glm::dot(b, frame.d1) +
            frame.k2 * glm::dot(a, frame.d2) * glm::dot(b, frame.d2)) /
           grown;
  };
  const double a = form(x, x), b = form(x, y), c = form(y, y);
  const Vec2 deviator(0.5 * (a - c), b);
  const double half = glm::length(deviator), mean = 0.5 * (a + c);
  f.k1 = mean + half, f.k2 = mean - half;
  const double sum = std::abs(f.k1) + std::abs(f.k2);
  f.umbilic = !(2 * half > kUmbilic * sum);
  f.confidence = f.umbilic ? 0 : 2 * half / sum;
  if (f.umbilic) return f;
  f.d1 = basis.vector(complex_sqrt(deviator / half));
  f.d2 = glm::cross(f.normal, f.d1);
  return f;
}

}  // namespace burin
