#include <burin/illustrate/view_probe.h>
#include <burin/visibility/sight_ray.h>

#include <limits>
#include <utility>

namespace burin {

ViewProbe view_probe(const Occluder& occluder, const Camera& camera, std::vector<bool> parts) {
  return [&occluder, &camera, parts = std::move(parts)](Vec2 paper) -> std::optional<ViewHit> {
    const ViewRay ray = sight_ray(camera, paper, occluder);
    const auto hit =
        occluder.first_hit(ray.origin, ray.direction, 0, std::numeric_limits<double>::infinity());
    if (!hit) return std::nullopt;
    const auto part = static_cast<std::size_t>(hit->where.part);
    return ViewHit{.part = hit->where.part,
                   .point = {hit->where.face, hit->bary},
                   .position = ray.origin + hit->distance * ray.direction,
                   .hatched = parts.empty() || parts[part]};
  };
}

}  // namespace burin
