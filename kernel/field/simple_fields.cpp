#include <burin/field/field.h>

#include <cmath>

namespace burin::field {
namespace {

// Sine of the smallest angle between a fixed direction and the normal at which its tangent part
// still has a direction worth following: nearer than about half a degree it turns faster than
// strokes can follow.
constexpr double kSteepest = 0.01;
// Share of one parameter's speed that the other's must have.
constexpr double kPole = 1e-6;

// The one of +d and -d that goes on in the direction of `previous`.
Vec3 along(Vec3 d, Vec3 previous) { return glm::dot(d, previous) < 0 ? -d : d; }

// The tangent part of `unit` and the direction across it, which is family `across`.
Field projected(const char* name, Vec3 unit, int across) {
  return {name, [unit, across](const FieldQuery& q) -> std::optional<Vec3> {
            const Vec3 n = q.frame.normal;
            const Vec3 t = reject(unit, n);
            const double size = glm::length(t);
            if (size < kSteepest) return std::nullopt;
            const Vec3 first = t / size, second = glm::cross(n, first);
            if (q.previous == Vec3(0)) return (q.family == 2) == (across == 2) ? second : first;
            const bool turned =
                std::abs(glm::dot(second, q.previous)) > std::abs(glm::dot(first, q.previous));
            return along(turned ? second : first, q.previous);
          }};
}

}  // namespace

Field fixed(Vec3 direction) {
  return projected("fixed", normalize_or(direction, Vec3(0, 0, 1)), 2);
}

Field planes(Vec3 normal) { return projected("planes", normalize_or(normal, Vec3(0, 0, 1)), 1); }

Field screen_vertical(const Camera& camera) { return projected("screen-vertical", camera.up(), 2); }

Field isoparametric() {
  return {"isoparametric", [](const FieldQuery& q) -> std::optional<Vec3> {
            const double du = glm::length(q.frame.du), dv = glm::length(q.frame.dv);
            // A parameter line that stands still against the other has no direction: a pole.
            if (!(std::min(du, dv) > kPole * std::max(du, dv))) return std::nullopt;
            const Vec3 u = q.frame.du / du, v = q.frame.dv / dv;
            if (q.previous == Vec3(0)) return q.family == 2 ? v : u;
            const bool turned =
                std::abs(glm::dot(v, q.previous)) > std::abs(glm::dot(u, q.previous));
            return along(turned ? v : u, q.previous);
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
