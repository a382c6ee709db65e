#include "seen_feature.h"

#include <burin/illustrate/illustrate.h>
#include <burin/surface/empty_surface.h>

#include "places_of_feature.h"
#include "realised_forms.h"

#include <algorithm>
#include <limits>

namespace burin::detail {
namespace {

/// The surfaces of what hides; those of parts that do not are empty.
std::vector<std::shared_ptr<const Surface>> hiding(const Scene& scene,
                                                   const std::vector<PartStyle>& styles,
                                                   RunContext& context) {
  RealisedForms forms(drawn_bounds(scene, styles).diagonal(), context);
  std::vector<bool> hides = drawn_parts(scene, styles);
  for (std::size_t i = 0; i < hides.size() && i < styles.size(); ++i) {
    hides[i] = hides[i] && !styles[i].transparent;
  }
  std::vector<std::shared_ptr<const Surface>> out = surfaces_of(scene, hides, forms);
  for (auto& one : out) {
    if (!one) one = empty_surface();
  }
  return out;
}

}  // namespace

FeatureSight::FeatureSight(const Scene& scene, const std::vector<PartStyle>& styles,
                           RunContext& context)
    : surfaces_(hiding(scene, styles, context)) {
  std::vector<const ProxyMesh*> proxies;
  double tolerance = 0;
  for (const auto& surface : surfaces_) {
    proxies.push_back(&surface->proxy());
    tolerance = std::max(tolerance, proxies.back()->tolerance);
  }
  occluder_ = std::make_unique<const Occluder>(proxies, context);
  near_ = 4 * occluder_->resolution();
  // By more than triangles are off the surfaces: bores in line have corners at other places.
  off_ = std::max(4 * tolerance, 1e-4 * occluder_->diagonal());
}

bool FeatureSight::shows_place(Vec3 on_surface, Vec3 way, Vec3 to_viewer) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  // Not through what lies on the surface, nor across a narrow gap.
  const auto before = occluder_->first_hit(on_surface, way, near_, 2 * off_);
  const double off = before ? 0.5 * before->distance : off_;
  return !occluder_->occluded(on_surface + off * way, to_viewer, near_, kFar);
}

bool FeatureSight::shows(const SeenFeature& seen, Vec3 to_viewer) const {
  if (seen.kind == FeatureRow::Kind::Point) return true;
  return std::ranges::any_of(sampled_places(seen, to_viewer), [&](const SampledPlace& place) {
    return shows_place(place.at + seen.moved, place.normal, to_viewer);
  });
}

void look_at_sights(const Scene& scene, Illustration& illustration, RunContext& context) {
  illustration.sights.clear();
  if (illustration.measured.empty()) return;
  const std::vector<PartStyle>& styles = illustration.illustrate.part_styles;
  const auto add = [&](const Scene& of) {
    illustration.sights.push_back(std::make_shared<const FeatureSight>(of, styles, context));
  };
  add(scene);
  for (const SectionView& view : illustration.section_views) add(*view.scene);
}

}  // namespace burin::detail
