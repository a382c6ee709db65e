#include <burin/field/field.h>

#include <cmath>

namespace burin {

Vec3 family_direction(const Cross& cross, int family) {
  return family == 2 ? cross.second : cross.first;
}

Vec3 direction_along(const Cross& cross, Vec3 previous) {
  const double a = glm::dot(cross.first, previous), b = glm::dot(cross.second, previous);
  if (std::abs(a) >= std::abs(b)) return a < 0 ? -cross.first : cross.first;
  return b < 0 ? -cross.second : cross.second;
}

}  // namespace burin
