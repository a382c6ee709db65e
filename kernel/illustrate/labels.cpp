#include "labels.h"

#include <burin/illustrate/view_probe.h>

#include <algorithm>
#include <utility>

namespace burin::detail {
namespace {

// Panes one behind the other that are looked through; items behind more are told as not seen.
constexpr std::size_t kMostGlass = 8;

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

/// Leaves the parts of a flag in a map, and takes the flag of those that are seen; whether any is.
bool keep_only(LabelMap& map, std::vector<bool>& parts) {
  std::vector<bool> left = parts;
  for (std::int32_t& part : map.parts) {
    if (part < 0) continue;
    const auto i = static_cast<std::size_t>(part);
    if (parts[i]) {
      left[i] = false;
    } else {
      part = -1;
    }
  }
  const bool any = left != parts;
  parts = std::move(left);
  return any;
}

}  // namespace

Labels label(const Drawing& drawing, const Occluders& occluders, const Camera& camera,
             const RunContext& context) {
  const Box2 box = ink_on_sheet(drawing);
  if (box.empty() || box.min.x >= box.max.x || box.min.y >= box.max.y) return {};
  Labels labels{map_of(box, occluders.solid(), camera, context), {}};
  std::vector<bool> left = occluders.transparent();
  while (labels.glass.size() < kMostGlass && std::ranges::find(left, true) != left.end()) {
    LabelMap map = map_of(box, Occluder(occluders.proxies_with(left), context), camera, context);
    // What was not seen may stand within what was: glass in glass.
    if (!keep_only(map, left)) break;
    labels.glass.push_back(std::move(map));
  }
  return labels;
}

}  // namespace burin::detail
