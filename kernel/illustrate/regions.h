#pragma once
// The sheet parted into areas of a part, a face and a step of tone; internal to the module.

#include <burin/area/partition.h>
#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/feature/isophotes.h>
#include <burin/feature/options.h>
#include <burin/surface/face_colors.h>
#include <burin/visibility/visible_spans.h>

#include "occluders.h"
#include "shadow/light_view.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin::detail {

/// What parts the sheet, beside the parts themselves.
struct RegionOptions {
  /// One a part: where its tone has a step; no levels: one step all over.
  std::vector<Isophotes> tones{};
  /// One a part, or fewer: the colours of its faces that part it; absent: it has one.
  std::vector<std::shared_ptr<const FaceColors>> colors{};
  /// One a part, or fewer: whether its faces are told apart.
  std::vector<bool> faces{};
  /// Paper mm: specks of tone narrower than this go to the step beside them.
  double pen = 0;
  /// The kinds of lines that were looked for; the rest is found here where it parts regions.
  FeatureOptions found{};
  /// From the model to the light by which parts cast shadows on parts; nothing: none do. Shadows
  /// have the step 0.
  std::optional<Vec3> shadows{};

  bool operator==(const RegionOptions&) const = default;
};

/// The feature lines of a view and the spans of each.
struct SeenLines {
  std::span<const Curve3> curves;
  std::span<const std::vector<Span>> spans;
};

/// Adds a border of regions to an area, without the points that lie on the line through others.
void add_ring(std::vector<Vec2> ring, Area& area);

/// `light_normals` of each part; empty ones of exact surfaces, and of parts of one step.
using LightNormals = std::vector<std::vector<Vec3>>;
LightNormals light_normals_of(const Occluders& occluders, const Camera& camera,
                              const RegionOptions& options, const RunContext& context);

/// What is seen of solid parts, by part, face, colour and step; parts that can be looked through
/// have none. Borders are the visible lines, whatever the style draws of them, and lines that it
/// does not draw: isophotes, smooth edges and seams between faces, borders of colours,
/// intersections, borders of shadows. They part the sheet whether hidden or not; what is seen says
/// a ray. `light`: the view from `options.shadows` of the `casters`, the occluders but for parts
/// that cast no shadow; null where there is none. Cost: `partition`; a ray a mm of isophotes.
/// Throws Cancelled.
Partition find_regions(const Box2& box, const SeenLines& lines, const Occluders& occluders,
                       const Occluders& casters, const Camera& camera, const RegionOptions& options,
                       const LightView* light, LightNormals normals, const RunContext& context);

/// What is seen of each part, whatever else parts the sheet; by part.
std::vector<Area> silhouettes(const Partition& partition);

/// Regions as areas, of each part and face the darkest last. They say a step where the part has
/// more than one, and a face where faces are told apart, or that closes a cut; their `fill` is the
/// colour of faces that are coloured otherwise than their part. `nested`, one a part: areas of a
/// step hold the darker ones, too, which come after: painted one over the other, no hair of paper
/// shows between them; so the colour of a part goes on below those of its faces.
std::vector<Area> areas_of(const Partition& partition, const RegionOptions& options,
                           const std::vector<bool>& nested);

}  // namespace burin::detail
