#include <burin/base/catalogue.h>
#include <burin/tone/catalogue.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin::tone {
namespace {

Vec3 unit_to_light(const Camera& camera, const ToneOptions& options) {
  return normalize_or(to_light(camera, options), camera.direction());
}

Tone lambert(const Camera& camera, const ToneOptions& options) {
  return [options, light = unit_to_light(camera, options)](Vec3 /*position*/, Vec3 normal) {
    return options.ambient + options.diffuse * std::max(0.0, glm::dot(normal, light));
  };
}

/// @cite Phong1975
Tone phong(const Camera& camera, const ToneOptions& options) {
  return [camera, options, light = unit_to_light(camera, options), matt = lambert(camera, options)](
             Vec3 position, Vec3 normal) {
    const double lit = glm::dot(normal, light);
    if (lit <= 0) return matt(position, normal);
    const double mirrored = glm::dot(2 * lit * normal - light, camera.to_viewer(position));
    return matt(position, normal) +
           options.specular * std::pow(std::max(0.0, mirrored), options.shininess);
  };
}

Tone facing(const Camera& camera, const ToneOptions& options) {
  return [camera, options](Vec3 position, Vec3 normal) {
    return options.ambient +
           options.diffuse * std::max(0.0, glm::dot(normal, camera.to_viewer(position)));
  };
}

/// @cite Elber1998
Tone silhouette(const Camera& camera, const ToneOptions& options) {
  return [camera, decay = options.decay](Vec3 position, Vec3 normal) {
    const double facing = std::abs(glm::dot(normal, camera.to_viewer(position)));
    return 1 - std::pow(std::max(0.0, 1 - facing), decay);
  };
}

Tone constant(const Camera& /*camera*/, const ToneOptions& options) {
  return [lightness = options.ambient](Vec3 /*position*/, Vec3 /*normal*/) { return lightness; };
}

constexpr std::array kLaws{
    Law{"lambert", "the angle to the light, as on matt surfaces", true, lambert},
    Law{"phong", "the same, and the light mirrored, as on polished surfaces", true, phong},
    Law{"facing", "the angle to the viewer", false, facing},
    Law{"silhouette", "only where the surface turns away is it dark", false, silhouette},
    Law{"constant", "nothing: tone.ambient everywhere", false, constant},
};

}  // namespace

Vec3 to_light(const Camera& camera, const ToneOptions& options) {
  const Vec3 v = options.light;
  return camera.right() * v.x + camera.up() * v.y + camera.direction() * v.z;
}

std::span<const Law> catalogue() { return kLaws; }

const Law& find(std::string_view name) { return find_row(catalogue(), name, "tone.law"); }

Tone make(const Camera& camera, const ToneOptions& options) {
  return [camera, rim = options.rim, highlight = options.highlight,
          law = find(options.law).make(camera, options)](Vec3 position, Vec3 normal) {
    const double facing = std::clamp(glm::dot(normal, camera.to_viewer(position)), 0.0, 1.0);
    const double reflectance = law(position, normal) - rim * std::pow(1 - facing, 3);
    return std::clamp(reflectance / highlight, 0.0, 1.0);
  };
}

}  // namespace burin::tone
