#include "parts_before.h"

#include <burin/mesh/spread.h>

#include <algorithm>
#include <set>
#include <utility>

namespace burin::detail {
namespace {

constexpr std::size_t kSamples = 400;
/// Of them: what is to be seen.
constexpr double kEnough = 0.5;
/// Of the resolution of rays: from a surface to what lies on it.
constexpr double kOff = 4;

/// Places on triangles that face the viewer, spread by the area that they have on the sheet.
std::vector<Vec3> places_on(std::span<const std::size_t> parts, const Occluders& occluders,
                            const Camera& camera) {
  struct Facing {
    const ProxyMesh* proxy;
    std::uint32_t face;
    double end;  // of its share
  };
  std::vector<Facing> facing;
  double sum = 0;
  for (const std::size_t part : parts) {
    const ProxyMesh& proxy = *occluders.proxies()[part];
    for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
      const Vec3 middle = proxy.position(f, Vec3(1.0 / 3));
      const double cosine = glm::dot(proxy.mesh.normal(f), camera.to_viewer(middle));
      if (cosine > 0) facing.push_back({&proxy, f, sum += cosine * proxy.mesh.area(f)});
    }
  }
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < kSamples && !facing.empty(); ++i) {
    const double at = sum * (static_cast<double>(i) + 0.5) / kSamples;
    const auto one = std::ranges::lower_bound(facing, at, {}, &Facing::end);
    if (one == facing.end()) break;
    places.push_back(one->proxy->position(one->face, spread_bary(i)));
  }
  return places;
}

}  // namespace

std::vector<std::size_t> parts_before(std::span<const std::size_t> shown,
                                      const Occluders& occluders, const Camera& camera) {
  const Occluder& solid = occluders.solid();
  const auto is_shown = [&](std::size_t part) {
    return std::ranges::find(shown, part) != shown.end();
  };
  const std::vector<Vec3> places = places_on(shown, occluders, camera);
  std::vector<std::set<std::size_t>> before;
  for (const Vec3& p : places) {
    std::set<std::size_t>& parts = before.emplace_back();
    const double far = std::min(camera.distance_to_viewer(p), 2 * solid.diagonal());
    solid.occluded_by(p, camera.to_viewer(p), kOff * solid.resolution(), far, [&](const Hit& hit) {
      const auto part = static_cast<std::size_t>(hit.where.part);
      if (!is_shown(part)) parts.insert(part);
      return false;  // and what is farther
    });
  }
  std::vector<std::size_t> gone;
  for (;;) {
    const auto seen = std::ranges::count_if(before, &std::set<std::size_t>::empty);
    if (static_cast<double>(seen) >= kEnough * static_cast<double>(places.size())) break;
    std::vector<std::size_t> hides(occluders.size(), 0);
    for (const auto& parts : before) {
      for (const std::size_t part : parts) ++hides[part];
    }
    const auto most = static_cast<std::size_t>(std::ranges::max_element(hides) - hides.begin());
    for (auto& parts : before) parts.erase(most);
    gone.push_back(most);
  }
  std::ranges::sort(gone);
  return gone;
}

}  // namespace burin::detail
