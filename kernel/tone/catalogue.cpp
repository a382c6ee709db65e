#include <burin/base/catalogue.h>
#include <burin/base/smoothstep.h>
#include <burin/tone/catalogue.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace burin::tone {
namespace {

/// What shines on a place: a light in model space.
struct Lamp {
  bool at = false;
  Vec3 place;  // a unit vector to the light, or where it is
  double strength;
  double share = 1;  // of the strength of all lamps

  Vec3 towards(Vec3 position) const { return at ? normalize_or(place - position, Vec3(0)) : place; }
  double distance(Vec3 position) const {
    return at ? glm::distance(place, position) : std::numeric_limits<double>::infinity();
  }
};

/// The lights of the scene, or the one of the style.
struct Lighting {
  double ambient = 0;
  double reflected = 0;
  Vec3 view{0, 0, 1};
  std::vector<Lamp> lamps;
};

Vec3 in_model(const Camera& camera, Vec3 view) {
  return camera.right() * view.x + camera.up() * view.y + camera.direction() * view.z;
}

Lighting lighting(const Camera& camera, const ToneOptions& options) {
  const auto from = [&](Vec3 view, double strength) {
    return Lamp{false, normalize_or(in_model(camera, view), camera.direction()), strength};
  };
  Lighting all{options.ambient, options.reflected, camera.direction(), {}};
  if (options.lights.empty()) {
    all.lamps.push_back(from(options.light, options.diffuse));
    return all;
  }
  all.ambient = 0;
  for (const Light& light : options.lights) {
    switch (light.kind) {
      case Light::Kind::Ambient:
        all.ambient += light.strength;
        break;
      case Light::Kind::From:
        all.lamps.push_back(from(light.place, light.strength));
        break;
      case Light::Kind::At:
        all.lamps.push_back({true, light.place, light.strength});
        break;
    }
  }
  double sum = 0;
  for (const Lamp& lamp : all.lamps) sum += lamp.strength;
  for (Lamp& lamp : all.lamps) lamp.share = sum > 0 ? lamp.strength / sum : 0;
  return all;
}

/// The share of a lamp's light that comes to a place.
class Shadows {
 public:
  Shadows(const ToneOptions& options, const Blocked& blocked)
      : depth_(blocked ? options.shadow : 0),
        spread_(std::tan(0.5 * options.shadow_width * std::numbers::pi / 180)),
        blocked_(blocked) {}

  /// `lit`: the cosine to the lamp, over 0.
  double share(const Lamp& lamp, Vec3 position, Vec3 normal, double lit) const {
    // Where light only grazes there is little to be missed, and the triangles that stand for a
    // round surface would throw shadows on each other.
    constexpr double kGrazing = 0.02, kSquare = 0.2;
    const double depth = depth_ * smoothstep(kGrazing, kSquare, lit);
    if (depth <= 0) return 1;
    const Vec3 towards = lamp.towards(position);
    const double distance = lamp.distance(position);
    if (spread_ <= 0) return blocked_(position, normal, towards, distance) ? 1 - depth : 1;
    // Places of the lamp's disc on a spiral, each for the same area of it. @cite Vogel1979
    constexpr int kRays = 16;
    constexpr double kGolden = 2.399963229728653;  // radians
    const Vec3 a = any_orthogonal(towards), b = glm::cross(towards, a);
    int hidden = 0;
    for (int i = 0; i < kRays; ++i) {
      const double r = spread_ * std::sqrt((i + 0.5) / kRays), angle = kGolden * i;
      const Vec3 ray = glm::normalize(towards + r * (std::cos(angle) * a + std::sin(angle) * b));
      hidden += blocked_(position, normal, ray, distance);
    }
    return 1 - depth * hidden / kRays;
  }

 private:
  double depth_, spread_;
  Blocked blocked_;
};

// Each lamp is thrown back by what stands on its other side in the picture: from its direction
// turned half a turn about that of the view, and only where the lamp itself does not reach.
Tone lambert(const Camera& camera, const ToneOptions& options, const Blocked& blocked) {
  return [all = lighting(camera, options), shadows = Shadows(options, blocked)](Vec3 position,
                                                                                Vec3 normal) {
    constexpr double kDusk = 0.3;  // cosine to the lamp up to which its light is seen thrown back
    double light = all.ambient;
    for (const Lamp& lamp : all.lamps) {
      const Vec3 towards = lamp.towards(position);
      const double lit = glm::dot(normal, towards);
      if (lit > 0) light += lamp.strength * lit * shadows.share(lamp, position, normal, lit);
      if (all.reflected <= 0 || lit >= kDusk) continue;
      const Vec3 back = 2 * glm::dot(towards, all.view) * all.view - towards;
      light += lamp.share * all.reflected * std::max(0.0, glm::dot(normal, back)) *
               (1 - smoothstep(-kDusk, kDusk, lit));
    }
    return light;
  };
}

/// Of several lights each adds its share of `specular`. @cite Phong1975
Tone phong(const Camera& camera, const ToneOptions& options, const Blocked& blocked) {
  return [camera, options, all = lighting(camera, options), shadows = Shadows(options, blocked),
          matt = lambert(camera, options, blocked)](Vec3 position, Vec3 normal) {
    double light = matt(position, normal);
    const Vec3 to_viewer = camera.to_viewer(position);
    for (const Lamp& lamp : all.lamps) {
      const Vec3 towards = lamp.towards(position);
      const double lit = glm::dot(normal, towards);
      if (lit <= 0) continue;
      const double mirrored = glm::dot(2 * lit * normal - towards, to_viewer);
      if (mirrored <= 0) continue;
      light += lamp.share * options.specular * std::pow(mirrored, options.shininess) *
               shadows.share(lamp, position, normal, lit);
    }
    return light;
  };
}

Tone facing(const Camera& camera, const ToneOptions& options, const Blocked& /*blocked*/) {
  return [camera, options](Vec3 position, Vec3 normal) {
    return options.ambient +
           options.diffuse * std::max(0.0, glm::dot(normal, camera.to_viewer(position)));
  };
}

/// @cite Elber1998
Tone silhouette(const Camera& camera, const ToneOptions& options, const Blocked& /*blocked*/) {
  return [camera, decay = options.decay](Vec3 position, Vec3 normal) {
    const double facing = std::abs(glm::dot(normal, camera.to_viewer(position)));
    return 1 - std::pow(std::max(0.0, 1 - facing), decay);
  };
}

Tone constant(const Camera& /*camera*/, const ToneOptions& options, const Blocked& /*blocked*/) {
  return [lightness = options.ambient](Vec3 /*position*/, Vec3 /*normal*/) { return lightness; };
}

template <Tone (*make)(const Camera&, const ToneOptions&, const Blocked&)>
Tone made(const LawRequest& r) {
  return make(r.camera, r.options, r.blocked);
}

GrowingCatalogue<Law>& all() {
  static GrowingCatalogue<Law> laws({
      {"lambert",
       "the angle to the light, as on matt surfaces",
       true,
       made<lambert>,
       {},
       {"ambient", "diffuse", "reflected", "shadow"}},
      {"phong",
       "the same, and the light mirrored, as on polished surfaces",
       true,
       made<phong>,
       {},
       {"ambient", "diffuse", "reflected", "specular", "shininess", "shadow"}},
      {"facing", "the angle to the viewer", false, made<facing>, {}, {"ambient", "diffuse"}},
      {"silhouette",
       "only where the surface turns away is it dark",
       false,
       made<silhouette>,
       {},
       {"decay"}},
      {"constant", "nothing: tone.ambient everywhere", false, made<constant>, {}, {"ambient"}},
  });
  return laws;
}

}  // namespace

Vec3 to_light(const Camera& camera, const ToneOptions& options) {
  return in_model(camera, options.light);
}

std::span<const Law> catalogue() { return all().rows(); }

void add(Law law) { all().add(std::move(law)); }

const Law& find(std::string_view name) { return find_row(catalogue(), name, "tone.law"); }

Tone make(const Camera& camera, const ToneOptions& options, const Blocked& blocked,
          const VisibleSurfaces& shown) {
  return [camera, rim = options.rim, highlight = options.highlight, ink = options.ink,
          law = find(options.law).make({camera, options, blocked, shown})](Vec3 position,
                                                                           Vec3 normal) {
    const double facing = std::clamp(glm::dot(normal, camera.to_viewer(position)), 0.0, 1.0);
    constexpr double kInked = 0.15;  // ink from which the rim has all of its own
    double light = law(position, normal) / highlight;
    const double share = std::clamp((1 - light) / kInked, 0.0, 1.0);
    light -= share * rim / highlight * std::pow(1 - facing, 3);
    light = std::clamp(light, 0.0, 1.0);
    return ink == ToneOptions::Ink::Shade ? light : 1 - light;
  };
}

}  // namespace burin::tone
