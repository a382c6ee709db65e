#include <burin/illustrate/view_probe.h>

#include <utility>

namespace burin {

ViewProbe view_probe(const Occluder& occluder, const Camera& camera, std::vector<bool> parts) {
  const double back = 2 * occluder.diagonal();
  return
      [&occluder, &camera, back, parts = std::move(parts)](Vec2 paper) -> std::optional<ViewHit> {
        ViewRay ray = camera.ray(paper);
        double far = 2 * back;
        if (camera.perspective()) {
          far += glm::length(camera.eye() - camera.center());
        } else {
          ray.origin -= back * ray.direction;
        }
        const auto hit = occluder.first_hit(ray.origin, ray.direction, 0, far);
        if (!hit) return std::nullopt;
        const auto part = static_cast<std::size_t>(hit->where.part);
        return ViewHit{.part = hit->where.part,
                       .point = {hit->where.face, hit->bary},
                       .position = ray.origin + hit->distance * ray.direction,
                       .hatched = parts.empty() || parts[part]};
      };
}

}  // namespace burin
