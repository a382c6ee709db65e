#include "own_rays.h"

#include <span>

namespace burin::detail {

OwnRays::OwnRays(const ProxyMesh& proxy, const RunContext& context)
    : proxy_(proxy), only_(&proxy), occluder_(std::span(&only_, 1), context) {}

std::optional<OwnPlace> OwnRays::first(Vec3 from, Vec3 along, double far) const {
  const auto hit = occluder_.first_hit(from, along, 0, far);
  if (!hit) return std::nullopt;
  const std::uint32_t triangle = hit->where.face;
  return OwnPlace{from + hit->distance * along, proxy_.mesh.normal(triangle),
                  static_cast<std::int32_t>(triangle), hit->bary, hit->distance};
}

std::optional<OwnPlace> OwnRays::out_of(Vec3 from, Vec3 along, double far) const {
  const auto place = first(from, along, far);
  if (!place || glm::dot(place->normal, along) <= 0) return std::nullopt;
  return place;
}

}  // namespace burin::detail
