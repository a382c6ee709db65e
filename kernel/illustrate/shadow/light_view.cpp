#include "light_view.h"

#include <burin/base/box_corners.h>
#include <burin/feature/feature.h>

#include <utility>

namespace burin::detail {
namespace {

/// mm of the light's sheet: large, so that tolerances of paper mm are small ones of the shadow.
constexpr double kSheet = 400, kMargin = 10;

}  // namespace

std::optional<LightView> light_view(const Occluders& occluders, Vec3 light_direction,
                                    const RunContext& context) {
  Box3 bounds;
  for (const ProxyMesh* proxy : occluders.solid_proxies()) bounds.add(proxy->mesh.bounds());
  if (bounds.empty()) return std::nullopt;
  LightView light{Camera::fit(
                      [&](const Mat3& axes) {
                        Box3 box;
                        for (const Vec3& p : corners_of(bounds)) box.add(axes * p);
                        return box;
                      },
                      {.direction = glm::normalize(light_direction),
                       .margin = kMargin,
                       .paper = {kSheet, kSheet}}),
                  {}};
  const FeatureOptions options{.creases = false, .intersections = false, .smooth = false};
  Diagnostics said;  // of a view that is not drawn
  for (Curve3& curve :
       extract_features(occluders.solid_proxies(), light.camera, options, said, context)) {
    if (curve.occluding) light.outlines.push_back(std::move(curve));
  }
  return light;
}

}  // namespace burin::detail
