#include <burin/field/field.h>

#include <cmath>

namespace burin {

Vec3 arm_of(const Cross& cross, int family) { return family == 2 ? cross.second : cross.first; }

Vec3 arm_along(const Cross& cross, Vec3 previous) {
  const double a = glm::dot(cross.first, previous), b = glm::dot(cross.second, previous);
  if (std::abs(a) >= std::abs(b)) return a < 0 ? -cross.first : cross.first;
  return b < 0 ? -cross.second : cross.second;
}

}  // namespace burin
