#include "sight.h"

#include <burin/visibility/outline_gaps.h>

#include <algorithm>

namespace burin::detail {
namespace {

std::size_t part_of(const Curve3& curve) { return static_cast<std::size_t>(curve.source.part); }

// The curves that a rule picks, and where they came from.
struct Picked {
  std::vector<Curve3> curves;
  std::vector<std::size_t> from;

  // Where the spans of the picked ones belong among those of all.
  void put(const Spans& spans, Spans& all) const {
    for (std::size_t i = 0; i < spans.size(); ++i) all[from[i]] = spans[i];
  }
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

Spans Sight::classify(std::span<const Curve3> strokes, const RunContext& context) {
  if (occluders_->any_transparent()) return classify_transparent(strokes, context);
  if (!map_) see_features(context);
  return map_->classify(strokes, {}, context);
}

void Sight::see_features(const RunContext& context) {
  map_ = std::make_unique<VisibilityMap>(occluders_->solid(), occluders_->solid_proxies(), camera_,
                                         features_, context);
  try {
    spans_ = map_->classify(features_, {.classify_outer = true}, context);
    merged_cuts_ = map_->merged_cuts();
    if (closes_outline_) close_outline(context);
  } catch (...) {
    map_.reset();  // next time from the start
    throw;
  }
}

void Sight::close_outline(const RunContext& context) {
  std::vector<Curve3> gaps = outline_gaps(occluders_->solid(), occluders_->solid_proxies(), camera_,
                                          features_, spans_, context);
  if (gaps.empty()) return;
  closed_ = features_;  // the map goes on looking at them
  for (Curve3& gap : gaps) {
    const auto count = static_cast<double>(gap.segment_count());
    spans_.push_back({{.begin = 0, .end = count, .visible = true, .outer = true}});
    closed_.push_back(std::move(gap));
  }
}

Spans Sight::classify_transparent(std::span<const Curve3> strokes, const RunContext& context) {
  const Occluders& all = *occluders_;
  spans_.assign(features_.size(), {});
  Spans seen(strokes.size());
  const auto is_solid = [&](const Curve3& c) { return !all.transparent(part_of(c)); };
  {
    const Picked solid = pick(features_, is_solid);
    const VisibilityMap map(all.solid(), all.solid_proxies(), camera_, solid.curves, context);
    solid.put(map.classify(solid.curves, {.classify_outer = true}, context), spans_);
    const Picked own = pick(strokes, is_solid);
    own.put(map.classify(own.curves, {}, context), seen);
    merged_cuts_ = map.merged_cuts();
  }
  for (std::size_t part = 0; part < all.size(); ++part) {
    if (!all.transparent(part)) continue;
    const std::vector<const ProxyMesh*> proxies = all.proxies_before(part);
    const Occluder occluder(proxies, context, all.tree_options());
    // All that cuts here; only the answers for the part itself are kept.
    const Picked cutting =
        pick(features_, [&](const Curve3& c) { return part_of(c) == part || is_solid(c); });
    const VisibilityMap map(occluder, proxies, camera_, cutting.curves, context);
    const Spans spans = map.classify(cutting.curves, {.classify_outer = true}, context);
    merged_cuts_ = std::max(merged_cuts_, map.merged_cuts());
    for (std::size_t i = 0; i < spans.size(); ++i) {
      if (part_of(cutting.curves[i]) == part) spans_[cutting.from[i]] = spans[i];
    }
    const Picked own = pick(strokes, [&](const Curve3& c) { return part_of(c) == part; });
    own.put(map.classify(own.curves, {}, context), seen);
  }
  return seen;
}

}  // namespace burin::detail
