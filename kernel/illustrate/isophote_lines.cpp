#include "isophote_lines.h"

#include <burin/feature/light_normals.h>
#include <burin/tone/catalogue.h>

#include "exact_places.h"

#include <algorithm>
#include <iterator>

namespace burin::detail {

std::vector<Isophotes> drawn_isophotes(const PartStyles& part_styles, const Camera& camera) {
  std::vector<Isophotes> out;
  bool any = false;
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    const Style& style = part_styles.style(i);
    const auto count = part_styles.drawn(i) ? style.feature.isophotes : 0;
    out.push_back({tone::to_light(camera, style.tone), even_levels(count + 1)});
    any = any || count > 0;
  }
  return any ? out : std::vector<Isophotes>();
}

std::vector<Curve3> isophote_lines(const Occluders& occluders, const Camera& camera,
                                   const std::vector<Isophotes>& isophotes, double pen,
                                   const RunContext& context) {
  std::vector<Curve3> out;
  const auto proxies = occluders.proxies();
  for (std::size_t i = 0; i < isophotes.size(); ++i) {
    if (isophotes[i].levels.empty()) continue;
    const ProxyMesh& proxy = *proxies[i];
    std::vector<Vec3> normals;
    if (!occluders.surfaces()[i]->exact()) {
      normals = tone_normals(proxy, isophotes[i], camera, pen, context);
    }
    std::ranges::move(
        trace_isophotes(proxy, static_cast<std::int32_t>(i), isophotes[i], camera, context,
                        {.exact = exact_places(*occluders.surfaces()[i]), .normals = normals}),
        std::back_inserter(out));
  }
  return out;
}

}  // namespace burin::detail
