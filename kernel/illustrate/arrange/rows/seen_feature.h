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

/// A face, an edge or all of a part, and how far the part moved since its surface was made.
struct SeenFeature {
  const Surface& surface;
  const Feature& feature;
  FeatureRow::Kind kind;
  Vec3 moved{0};
  /// Its number in the scene.
  std::size_t part = 0;
};

/// A place at which a leader may point, and model mm about it that show the same, 0 on lines.
struct SeenPlace {
  Vec3 at{0};
  double room = 0;
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
  /// Up to 8 places that are seen, those with the most room first: of a face or a part the middles
  /// of what is seen of it, by a grid of 48 rays along its longer side; where that meets nothing of
  /// it, and of an edge, places of the triangles. `axes`: right, up and to the viewer, in rows.
  std::vector<SeenPlace> seen_places(const SeenFeature& seen, const Mat3& axes) const;

 private:
  std::vector<SeenPlace> places_by_rays(const SeenFeature& seen, const Mat3& axes) const;
  std::vector<SeenPlace> places_by_triangles(const SeenFeature& seen, Vec3 to_viewer) const;
  std::vector<std::shared_ptr<const Surface>> surfaces_;
  std::unique_ptr<const Occluder> occluder_;
  /// Model mm: how far off a surface rays begin, and from where on they meet something.
  double off_ = 0, near_ = 0;
};

/// Fills `Illustration::sights` once parts are where they are drawn, where rows are measured.
void look_at_sights(const Scene& scene, Illustration& illustration, RunContext& context);

}  // namespace burin::detail
