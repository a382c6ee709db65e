#include "ground_shadow.h"

#include <burin/area/partition.h>
#include <burin/illustrate/ground.h>
#include <burin/illustrate/view_probe.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

std::vector<std::vector<Vec2>> on_sheet(const LightView& light) {
  std::vector<std::vector<Vec2>> lines;
  for (const Curve3& curve : light.outlines) {
    std::vector<Vec2>& line = lines.emplace_back();
    for (const Vec3& p : curve.points) line.push_back(light.camera.to_paper(p));
    if (curve.closed) line.push_back(line.front());
  }
  return lines;
}

double lowest(const Occluders& occluders) {
  Box3 bounds;
  for (const ProxyMesh* proxy : occluders.solid_proxies()) bounds.add(proxy->mesh.bounds());
  return bounds.min.z;
}

}  // namespace

std::optional<Area> ground_shadow(const Occluders& occluders, const LightView& light,
                                  const Camera& camera, const RunContext& context) {
  const Vec3 to_light = light.camera.direction();
  if (!casts_ground_shadow(to_light, camera.direction())) return std::nullopt;
  // All outlines, hidden or not: what a place is says a ray.
  const std::vector<std::vector<Vec2>> lines = on_sheet(light);
  std::vector<BorderLine> borders;
  for (const std::vector<Vec2>& line : lines) borders.push_back({line});
  const auto label_at = [probe = view_probe(occluders.solid(), light.camera)](Vec2 at) {
    return AreaLabel{.part = probe(at) ? 0 : -1};
  };
  const Paper& paper = light.camera.paper();
  const Box2 sheet{Vec2(0), Vec2(paper.width, paper.height)};
  const Partition parted = partition(sheet, borders, label_at, {.rounds = 1}, context);
  const Placement down = onto_ground(to_light, lowest(occluders));
  Area shadow;
  for (const AreaRegion& region : parted.regions) {
    if (region.label.part < 0) continue;
    for (const AreaRing& ring : region.rings) {
      std::vector<Vec2>& points = shadow.rings.emplace_back();
      for (const Vec2& p : parted.polygon(ring)) {
        points.push_back(camera.to_paper(down.point(light.camera.ray(p).origin)));
      }
    }
  }
  if (shadow.rings.empty()) return std::nullopt;
  return shadow;
}

}  // namespace burin::detail
