#include <burin/field/field.h>

#include <cmath>

namespace burin::field {
namespace {

// Sine of the smallest angle between a fixed direction and the normal at which its tangent part
// still has a direction worth following: nearer than about half a degree it turns faster than
// strokes can follow.
constexpr double kSteepest = 0.01;

// The one of +d and -d that goes on in the direction of `previous`.
Vec3 along(Vec3 d, Vec3 previous) { return glm::dot(d, previous) < 0 ? -d : d; }

}  // namespace

Field fixed(Vec3 direction) {
  const Vec3 unit = normalize_or(direction, Vec3(0, 0, 1));
  return {"fixed", [unit](const FieldQuery& q) -> std::optional<Vec3> {
            const Vec3 n = q.frame.normal;
            const Vec3 t = reject(unit, n);
            const double size = glm::length(t);
            if (size < kSteepest) return std::nullopt;
            const Vec3 first = t / size, second = glm::cross(n, first);
            if (q.previous == Vec3(0)) return q.family == 2 ? second : first;
            const bool across =
                std::abs(glm::dot(second, q.previous)) > std::abs(glm::dot(first, q.previous));
            return along(across ? second : first, q.previous);
          }};
}

Field principal() {
  return {"principal", [](const FieldQuery& q) -> std::optional<Vec3> {
            const Frame& f = q.frame;
            if (f.umbilic) return std::nullopt;
            if (q.previous == Vec3(0)) {
              const bool first_larger = std::abs(f.k1) >= std::abs(f.k2);
              return first_larger == (q.family != 2) ? f.d1 : f.d2;
            }
            const bool second =
                std::abs(glm::dot(f.d2, q.previous)) > std::abs(glm::dot(f.d1, q.previous));
            return along(second ? f.d2 : f.d1, q.previous);
          }};
}

}  // namespace burin::field
