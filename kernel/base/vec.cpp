#include <burin/base/vec.h>

#include <cmath>

namespace burin {

Vec3 any_orthogonal(Vec3 n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1.0 / (sign + n.z);
  const double b = n.x * n.y * a;
  return {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
}

Vec3 transport(Vec3 v, Vec3 from, Vec3 to) {
  const Vec3 axis = glm::cross(from, to);
  const double c = glm::dot(from, to);
  if (c <= -1.0 + 1e-12) return v;  // radians: opposite normals have no smallest rotation
  return v * c + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1.0 + c));
}

}  // namespace burin
