#include "ground_shadow.h"

#include <burin/area/partition.h>
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

namespace burin {

bool casts_ground_shadow(Vec3 to_light, Vec3 to_viewer) {
  constexpr double kLeastLight = 0.1, kLeastView = 0.02;  // sines of their heights
  return to_light.z > kLeastLight && to_viewer.z > kLeastView;
}

Placement onto_ground(Vec3 to_light, double ground) {
  const Vec3 along = to_light / to_light.z;
  Mat3 linear(1);
  linear[2] -= along;  // the column of z
  return {linear, along * ground};
}

std::array<Vec3, 8> corners_of(const Box3& box) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {i & 1U ? box.max.x : box.min.x, i & 2U ? box.max.y : box.min.y,
                  i & 4U ? box.max.z : box.min.z};
  }
  return corners;
}

Box3 bounds_with_shadow(const Scene& scene, const Style& style,
                        std::span<const PartStyle> part_styles, const Mat3& axes) {
  Box3 box = drawn_bounds(scene, part_styles, axes);
  if (!style.shadow.ground || box.empty()) return box;
  const Mat3 back = glm::transpose(axes);
  const Vec3 to_light = back * glm::normalize(style.tone.light);
  if (!casts_ground_shadow(to_light, back[2])) return box;
  const Placement down = onto_ground(to_light, drawn_bounds(scene, part_styles, Mat3(1)).min.z);
  const Box3 shadow = drawn_bounds(scene, part_styles, axes * down.linear);
  const Vec3 by = axes * down.offset;
  box.add({shadow.min + by, shadow.max + by});
  return box;
}

}  // namespace burin
