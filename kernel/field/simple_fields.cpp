#include <burin/field/field.h>

#include <cmath>
#include <utility>

namespace burin::field {
namespace {

// Sine of the smallest angle between a fixed direction and the normal at which its tangent part
// still has a direction worth following: nearer than about half a degree it turns faster than
// strokes can follow.
constexpr double kSteepest = 0.01;
// Share of one parameter's speed that the other's must have.
constexpr double kPoleSpeeds = 1e-6;

// The unit part of a direction in the tangent plane; nothing where it stands on the surface.
std::optional<Vec3> tangent_part(Vec3 direction, Vec3 normal) {
  const Vec3 t = reject(direction, normal);
  const double size = glm::length(t);
  if (size < kSteepest) return std::nullopt;
  return t / size;
}

// Family 1 along the lines on which `height`, a function of space with a gradient, stands still.
template <class Gradient, class Height>
Field contour_lines(const char* name, Gradient gradient, Height height) {
  return {name, [=](const FieldQuery& q) -> std::optional<Cross> {
            const Vec3 n = q.frame.normal, g = gradient(q.point.position);
            const auto climb = tangent_part(glm::normalize(g), n);
            if (!climb) return std::nullopt;
            return Cross{glm::cross(n, *climb), *climb, q.frame.confidence,
                         Level{height(q.point.position), reject(g, n), g}};
          }};
}

}  // namespace

Field fixed(Vec3 direction) {
  const Vec3 unit = normalize_or(direction, Vec3(0, 0, 1));
  return {"fixed", [unit](const FieldQuery& q) -> std::optional<Cross> {
            const auto t = tangent_part(unit, q.frame.normal);
            if (!t) return std::nullopt;
            return Cross{*t, glm::cross(q.frame.normal, *t), q.frame.confidence, std::nullopt,
                         glm::length(reject(unit, q.frame.normal))};
          }};
}

Field planes(Vec3 normal) {
  const Vec3 unit = normalize_or(normal, Vec3(0, 0, 1));
  return contour_lines(
      "planes", [unit](Vec3) { return unit; }, [unit](Vec3 p) { return glm::dot(p, unit); });
}

Field screen_vertical(const Camera& camera) {
  // What stands still along them is x on paper, in model mm in the middle of the sheet.
  const double unit = 1 / camera.scale();
  const auto gradient = [camera, unit](Vec3 p) {
    return unit * Vec3(camera.velocity(p, {1, 0, 0}).x, camera.velocity(p, {0, 1, 0}).x,
                       camera.velocity(p, {0, 0, 1}).x);
  };
  return contour_lines("screen-vertical", gradient,
                       [camera, unit](Vec3 p) { return unit * camera.to_paper(p).x; });
}

Field silhouette(const Camera& camera) {
  // What stands still along them is the distance to the viewer.
  return contour_lines(
      "silhouette", [camera](Vec3 p) { return camera.to_viewer(p); },
      [camera](Vec3 p) {
        return camera.perspective() ? -camera.distance_to_viewer(p) : camera.depth(p);
      });
}

Field silhouette_across(const Camera& camera) {
  return {"silhouette-across", [along = silhouette(camera).cross](const FieldQuery& q) {
            std::optional<Cross> cross = along(q);
            if (!cross) return cross;
            std::swap(cross->first, cross->second);
            cross->level.reset();  // it is kept along the silhouettes
            return cross;
          }};
}

Field isoparametric() {
  return {"isoparametric", [](const FieldQuery& q) -> std::optional<Cross> {
            const double du = glm::length(q.frame.du), dv = glm::length(q.frame.dv);
            // A parameter line that stands still against the other has no direction: a pole.
            if (!(std::min(du, dv) > kPoleSpeeds * std::max(du, dv))) return std::nullopt;
            return Cross{q.frame.du / du, q.frame.dv / dv, q.frame.confidence};
          }};
}

Field principal() {
  return {"principal", [](const FieldQuery& q) -> std::optional<Cross> {
            const Frame& f = q.frame;
            if (f.umbilic) return std::nullopt;
            const bool d1_first = std::abs(f.k1) >= std::abs(f.k2);
            return Cross{d1_first ? f.d1 : f.d2, d1_first ? f.d2 : f.d1, f.confidence};
          }};
}

}  // namespace burin::field
