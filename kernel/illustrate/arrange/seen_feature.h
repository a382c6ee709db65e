#pragma once
// Whether a view shows a face or an edge; internal to the module.

#include <burin/arrange/dimension_row.h>
#include <burin/arrange/illustration.h>
#include <burin/base/run_context.h>
#include <burin/measure/feature.h>
#include <burin/surface/scene.h>
#include <burin/surface/surface.h>
#include <burin/visibility/occluder.h>

#include <memory>
#include <vector>

namespace burin::detail {

/// A face or an edge of a part, and how far the part moved since its surface was made.
struct SeenFeature {
  const Surface& surface;
  const Feature& feature;
  FeatureRow::Kind kind;
  Vec3 moved{0};
};

/// What the parts of a scene hide of each other, and of themselves. Parts that are not drawn or of
/// glass hide nothing. Cost: that of an Occluder of all parts, and two of its rays a place.
class FeatureSight {
 public:
  FeatureSight(const Scene& scene, const std::vector<PartStyle>& styles, RunContext& context);

  /// Whether something of it is seen in a direction: of 1024 places of it at the most.
  bool shows(const SeenFeature& seen, Vec3 to_viewer) const;
  /// Whether a place just off a surface is seen, `way` off it, unit.
  bool shows_place(Vec3 on_surface, Vec3 way, Vec3 to_viewer) const;

 private:
  std::vector<std::shared_ptr<const Surface>> surfaces_;
  std::unique_ptr<const Occluder> occluder_;
  /// Model mm: how far off a surface rays begin, and from where on they meet something.
  double off_ = 0, near_ = 0;
};

/// Fills `Illustration::sights` once parts are where they are drawn, where rows are measured.
void look_at_sights(const Scene& scene, Illustration& illustration, RunContext& context);

}  // namespace burin::detail
