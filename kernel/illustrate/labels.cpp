#include "labels.h"

#include <burin/illustrate/view_probe.h>

namespace burin::detail {
namespace {

Box2 ink_on_sheet(const Drawing& drawing) {
  Box2 box;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      for (const Vec2& p : path.points) box.add(p);
    }
  }
  if (box.empty()) return box;
  constexpr double kAround = 1;  // paper mm
  return {glm::max(box.min - kAround, Vec2(0)),
          glm::min(box.max + kAround, Vec2(drawing.paper_width, drawing.paper_height))};
}

LabelMap map_of(const Box2& box, const Occluder& occluder, const Camera& camera,
                const RunContext& context) {
  const ViewProbe probe = view_probe(occluder, camera);
  return make_label_map(
      box,
      [&](Vec2 at) {
        const auto hit = probe(at);
        return hit ? hit->part : -1;
      },
      context);
}

}  // namespace

Labels label(const Drawing& drawing, const Occluders& occluders, const Camera& camera,
             const RunContext& context) {
  const Box2 box = ink_on_sheet(drawing);
  if (box.empty() || box.min.x >= box.max.x || box.min.y >= box.max.y) return {};
  Labels labels{map_of(box, occluders.solid(), camera, context), {}};
  if (!occluders.any_transparent()) return labels;
  labels.glass = map_of(box, Occluder(occluders.proxies(), context), camera, context);
  for (std::int32_t& part : labels.glass.parts) {
    if (part >= 0 && !occluders.transparent(static_cast<std::size_t>(part))) part = -1;
  }
  return labels;
}

}  // namespace burin::detail
