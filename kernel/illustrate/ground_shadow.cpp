#include "ground_shadow.h"

#include <burin/area/partition.h>
#include <burin/base/box_corners.h>
#include <burin/feature/feature.h>
#include <burin/illustrate/ground.h>
#include <burin/illustrate/view_probe.h>

#include <utility>
#include <vector>

namespace burin::detail {
namespace {

/// mm of the light's sheet: large, so that tolerances of paper mm are small ones of the shadow.
constexpr double kSheet = 400, kMargin = 10;

// All lines that an outline may be made of, hidden or not: what a place is says a ray.
std::vector<std::vector<Vec2>> outlines(const Occluders& occluders, const Camera& light,
                                        const RunContext& context) {
  const FeatureOptions options{.intersections = false, .smooth = false};
  Diagnostics said;  // of a view that is not drawn
  std::vector<std::vector<Vec2>> lines;
  for (const Curve3& curve :
       extract_features(occluders.solid_proxies(), light, options, said, context)) {
    if (!curve.occluding) continue;
    std::vector<Vec2>& line = lines.emplace_back();
    for (const Vec3& p : curve.points) line.push_back(light.to_paper(p));
    if (curve.closed) line.push_back(line.front());
  }
  return lines;
}

}  // namespace

std::optional<Area> ground_shadow(const Occluders& occluders, Vec3 light_direction,
                                  const Camera& camera, const RunContext& context) {
  const Vec3 to_light = glm::normalize(light_direction);
  if (!casts_ground_shadow(to_light, camera.direction())) return std::nullopt;
  Box3 bounds;
  for (const ProxyMesh* proxy : occluders.solid_proxies()) bounds.add(proxy->mesh.bounds());
  if (bounds.empty()) return std::nullopt;
  const Camera light = Camera::fit(
      [&](const Mat3& axes) {
        Box3 box;
        for (const Vec3& p : corners_of(bounds)) box.add(axes * p);
        return box;
      },
      {.direction = to_light, .margin = kMargin, .paper = {kSheet, kSheet}});
  const std::vector<std::vector<Vec2>> lines = outlines(occluders, light, context);
  std::vector<BorderLine> borders;
  for (const std::vector<Vec2>& line : lines) borders.push_back({line});
  const auto label_at = [probe = view_probe(occluders.solid(), light)](Vec2 at) {
    return AreaLabel{.part = probe(at) ? 0 : -1};
  };
  const Box2 sheet{Vec2(0), Vec2(kSheet)};
  const Partition parted = partition(sheet, borders, label_at, {.rounds = 1}, context);
  const Placement down = onto_ground(to_light, bounds.min.z);
  Area shadow;
  for (const AreaRegion& region : parted.regions) {
    if (region.label.part < 0) continue;
    for (const AreaRing& ring : region.rings) {
      std::vector<Vec2>& points = shadow.rings.emplace_back();
      for (const Vec2& p : parted.polygon(ring)) {
        points.push_back(camera.to_paper(down.point(light.ray(p).origin)));
      }
    }
  }
  if (shadow.rings.empty()) return std::nullopt;
  return shadow;
}

}  // namespace burin::detail
