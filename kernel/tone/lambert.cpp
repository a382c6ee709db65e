#include <burin/tone/tone.h>

#include <algorithm>
#include <cmath>

namespace burin::tone {

Tone lambert(const Camera& camera, const LambertOptions& options) {
  const Vec3 light = normalize_or(camera.right() * options.light.x + camera.up() * options.light.y +
                                      camera.direction() * options.light.z,
                                  camera.direction());
  return [camera, options, light](Vec3 position, Vec3 normal) {
    const double lit = std::max(0.0, glm::dot(normal, light));
    double reflectance = options.ambient + options.diffuse * lit;
    const double facing = std::clamp(glm::dot(normal, camera.to_viewer(position)), 0.0, 1.0);
    reflectance -= options.rim * std::pow(1 - facing, 3);
    return std::clamp(reflectance / options.highlight, 0.0, 1.0);
  };
}

}  // namespace burin::tone
