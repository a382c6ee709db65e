#pragma once
/// From a scene to a drawing: the only place that knows the order of the stages.

#include <burin/annotate/annotate.h>
#include <burin/annotate/dimensions.h>
#include <burin/base/image.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/field/field.h>
#include <burin/illustrate/style.h>
#include <burin/stroke/stroke.h>
#include <burin/surface/scene.h>
#include <burin/tone/tone.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// A view that is drawn whole, then broken: the camera's paper holds all of the whole view.
struct BrokenView {
  /// From the camera's paper to the sheet.
  PaperBreaks breaks = {};
  Paper sheet = {};
  /// Paper mm: where the bottom left corner of the sheet lies on the camera's paper.
  Vec2 corner{0};
};

enum class HiddenLines { None, Dashed };

/// How one part is drawn where that differs from the others.
struct PartStyle {
  /// False: as if the part were not there.
  bool drawn = true;
  bool hatched = true;
  /// As of glass: it hides itself but no other part. Its strokes are placed as those of others.
  /// @cite Elber1998
  bool transparent = false;
  /// False: it is shown, and is no item of a parts list, and has no callout: what stands around.
  bool listed = true;
  /// Instead of the drawing's; what it says of files is ignored.
  std::optional<Style> style{};
};

/// What a field or a tone of the caller's own may look at. All of it lives as long as the strokes
/// are placed.
struct HatchScene {
  /// One per part; empty ones where a part has no strokes of this style.
  std::span<const Surface* const> surfaces;
  const Camera& camera;
  /// What is seen of these parts at a point of the paper.
  const ViewProbe& probe;
  const RunContext& context;
};

/// Pictures by the names that styles have for them.
using Images = std::map<std::string, std::shared_ptr<const Image>>;

struct IllustrateOptions {
  HiddenLines hidden = HiddenLines::None;
  std::uint64_t seed = 1;
  /// Chord tolerance in model mm of any tessellation; absent = 0.05 paper mm.
  std::optional<double> tolerance{};
  /// One per part, in order; parts beyond its end look as all do.
  std::vector<PartStyle> part_styles{};
  /// Instead of the style's: called once for each style that has strokes, in the thread that runs;
  /// what they return is called from many threads. Paths of strokes call such a field "own".
  std::function<Field(const HatchScene&)> field{};
  std::function<Tone(const HatchScene&)> tone{};
  /// What `hatch.image` of styles names; a name that is not among them is a UsageError.
  Images images{};
  /// Lines beside those of the shape, in model mm and with the part whose style they have: those of
  /// kind Trail that show where parts of an exploded view belong.
  std::vector<Curve3> trails{};
  /// How many times as large as the view whose detail it is; cuts are hatched as there.
  double magnified = 1;
  /// The name of one of several views, for messages about it; empty: there is one.
  std::string view_name{};
  /// Whether the drawing is tested against rays once it is finished: `Drawing::stats.verify`, and
  /// diagnostics. It draws the same.
  bool verify = false;
  /// Paper mm: what is left of the drawing, where its areas alone are tested; empty: all.
  Box2 shown{};
  /// Items of the parts that are drawn, for `Drawing::items` and `areas`, and what of them is laid
  /// over the drawing.
  std::optional<Annotations> annotations{};
  /// What is measured in the drawing.
  ViewDimensions dimensions{};
  /// What is left out of the view; `dimensions` are moved with the rest already.
  BrokenView broken{};
  /// Whether `Drawing::areas` tells the faces of parts apart, painted or not.
  bool face_areas = false;
};

/// The bounds of the parts that are drawn, in axes as those of `Form::bounds`; of all where none
/// is. `part_styles`: as in IllustrateOptions.
Box3 drawn_bounds(const Scene& scene, std::span<const PartStyle> part_styles,
                  const Mat3& axes = Mat3(1));

/// Which parts are drawn, one a part. `part_styles`: as in IllustrateOptions.
std::vector<bool> drawn_parts(const Scene& scene, std::span<const PartStyle> part_styles);

/// Draws `scene` as `camera` sees it. Stages timed on `context`: build curvature field cover trace
/// features visibility compose verify. Diagnostics tell of parts whose strokes have no direction to
/// follow, of a drawing that is empty, off the sheet, cut at its edge or no larger than a dot.
/// Throws GeometryError where the scene has no part, UsageError where a style has a member that its
/// key does not take, Cancelled once the context is cancelled.
Drawing illustrate(const Scene& scene, const Camera& camera, const Style& style,
                   const IllustrateOptions& options, RunContext& context);

}  // namespace burin
