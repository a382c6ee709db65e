#include "sight.h"

#include <burin/surface/empty_surface.h>
#include <burin/visibility/outline_gaps.h>

#include <algorithm>

namespace burin::detail {
namespace {

std::vector<const ProxyMesh*> solid_ones(std::span<const ProxyMesh* const> proxies,
                                         const PartStyles& part_styles) {
  std::vector<const ProxyMesh*> solid(proxies.begin(), proxies.end());
  for (std::size_t i = 0; i < solid.size(); ++i) {
    if (part_styles.transparent(i)) solid[i] = &empty_surface()->proxy();
  }
  return solid;
}

std::size_t part_of(const Curve3& curve) { return static_cast<std::size_t>(curve.source.part); }

// The curves that a rule picks, and where they came from.
struct Picked {
  std::vector<Curve3> curves;
  std::vector<std::size_t> from;
};
template <class Rule>
Picked pick(std::span<const Curve3> curves, Rule&& rule) {
  Picked picked;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!rule(curves[i])) continue;
    picked.curves.push_back(curves[i]);
    picked.from.push_back(i);
  }
  return picked;
}

}  // namespace

Sight::Sight(std::span<const ProxyMesh* const> proxies, const Camera& camera,
             const PartStyles& part_styles, const RunContext& context)
    : proxies_(proxies),
      camera_(camera),
      part_styles_(part_styles),
      solid_proxies_(solid_ones(proxies, part_styles)),
      solid_(solid_proxies_, context) {}

std::vector<const ProxyMesh*> Sight::proxies_before(std::size_t part) const {
  std::vector<const ProxyMesh*> proxies = solid_proxies_;
  proxies[part] = proxies_[part];
  return proxies;
}

Occluder Sight::before(std::size_t part, const RunContext& context) const {
  return {proxies_before(part), context};
}

Seen Sight::classify(std::span<const Curve3> features, std::span<const Curve3> strokes,
                     const RunContext& context) const {
  Seen seen;
  if (!part_styles_.any_transparent()) {
    const VisibilityMap map(solid_, solid_proxies_, camera_, features, context);
    seen.features = map.classify(features, {.classify_outer = true}, context);
    seen.strokes = map.classify(strokes, {}, context);
    seen.merged_cuts = map.merged_cuts();
    return seen;
  }
  seen.features.resize(features.size());
  seen.strokes.resize(strokes.size());
  const auto is_solid = [&](const Curve3& c) { return !part_styles_.transparent(part_of(c)); };
  {
    const Picked solid = pick(features, is_solid);
    const VisibilityMap map(solid_, solid_proxies_, camera_, solid.curves, context);
    const auto spans = map.classify(solid.curves, {.classify_outer = true}, context);
    for (std::size_t i = 0; i < spans.size(); ++i) seen.features[solid.from[i]] = spans[i];
    const Picked own = pick(strokes, is_solid);
    const auto stroke_spans = map.classify(own.curves, {}, context);
    for (std::size_t i = 0; i < stroke_spans.size(); ++i) {
      seen.strokes[own.from[i]] = stroke_spans[i];
    }
    seen.merged_cuts = map.merged_cuts();
  }
  for (std::size_t part = 0; part < part_styles_.size(); ++part) {
    if (!part_styles_.transparent(part) || !part_styles_.drawn(part)) continue;
    const std::vector<const ProxyMesh*> proxies = proxies_before(part);
    const Occluder occluder(proxies, context);
    // All that cuts here; only the answers for the part itself are kept.
    const Picked cutting =
        pick(features, [&](const Curve3& c) { return part_of(c) == part || is_solid(c); });
    const VisibilityMap map(occluder, proxies, camera_, cutting.curves, context);
    const auto spans = map.classify(cutting.curves, {.classify_outer = true}, context);
    seen.merged_cuts = std::max(seen.merged_cuts, map.merged_cuts());
    for (std::size_t i = 0; i < spans.size(); ++i) {
      if (part_of(cutting.curves[i]) == part) seen.features[cutting.from[i]] = spans[i];
    }
    const Picked own = pick(strokes, [&](const Curve3& c) { return part_of(c) == part; });
    const auto stroke_spans = map.classify(own.curves, {}, context);
    for (std::size_t i = 0; i < stroke_spans.size(); ++i) {
      seen.strokes[own.from[i]] = stroke_spans[i];
    }
  }
  return seen;
}

void Sight::close_outline(std::vector<Curve3>& features, Seen& seen,
                          const RunContext& context) const {
  if (part_styles_.any_transparent()) return;
  for (Curve3& gap :
       outline_gaps(solid_, solid_proxies_, camera_, features, seen.features, context)) {
    const auto count = static_cast<double>(gap.segment_count());
    seen.features.push_back({{.begin = 0, .end = count, .visible = true, .outer = true}});
    features.push_back(std::move(gap));
  }
}

}  // namespace burin::detail
