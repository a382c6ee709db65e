#pragma once
// The order of the stages; internal to the module.

#include <burin/area/partition.h>
#include <burin/base/box.h>
#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/feature/isophotes.h>
#include <burin/feature/options.h>
#include <burin/illustrate/illustrate.h>
#include <burin/surface/scene.h>
#include <burin/threads/thread_lines.h>

#include "hatch_parts.h"
#include "kept.h"
#include "labels.h"
#include "occluders.h"
#include "part_styles.h"
#include "realise_parts.h"
#include "regions.h"
#include "shadow/light_view.h"
#include "sight.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin::detail {

/// What a drawing is made of, a stage after the other, and what of it the last drawing left.
class Stages {
 public:
  /// Goes on without parts of plug-ins that fail. With the test against rays where it is asked for;
  /// `keeps`: for another drawing; else surfaces are gone before the test makes finer ones.
  Drawing draw(const Scene& scene, const Camera& camera, const Style& style,
               const IllustrateOptions& options, bool keeps, RunContext& context);
  /// `Session::parts_before`.
  std::vector<std::size_t> parts_before(std::span<const std::size_t> shown,
                                        const Camera& camera) const;

 private:
  Drawing draw_all(const Scene& scene, const Camera& camera, const Style& style,
                   const IllustrateOptions& options, bool keeps, RunContext& context);

  struct Solid {
    Surfaces surfaces;
    std::vector<bool> transparent;
    std::vector<double> ranks;
    bool operator==(const Solid&) const = default;
  };
  /// Of a view; the occluders stand for the surfaces.
  struct View {
    std::shared_ptr<const Occluders> occluders;
    Camera camera;
    FeatureOptions features;
    bool closes_outline = false;
    std::vector<Curve3> trails;
    /// One a part; empty where no part has some.
    std::vector<DrawnThreads> threads;
    double magnified = 1;
    std::vector<Isophotes> isophotes;
    /// Paper mm, for isophotes; else 0.
    double pen = 0;
    bool operator==(const View&) const = default;
  };
  struct Lines {
    Sight sight;
    Diagnostics said;
  };
  struct Seen {
    std::shared_ptr<Lines> lines;
    HatchedParts::Hatchings strokes;
    bool operator==(const Seen&) const = default;
  };

  /// The lines stand for the occluders and the view.
  struct Parted {
    std::shared_ptr<Lines> lines;
    std::shared_ptr<const Occluders> casters;
    Box2 box;
    RegionOptions options;
    bool operator==(const Parted&) const = default;
  };
  struct Toned {
    std::shared_ptr<const Occluders> occluders;
    Camera camera;
    double pen = 0;
    /// One a part: whether its tone has steps.
    std::vector<bool> steps;
    bool operator==(const Toned&) const = default;
  };
  /// `casters`: what casts shadows; the occluders but for parts that cast none.
  struct Shaded {
    std::shared_ptr<const Occluders> occluders, casters;
    Vec3 to_light{0};
    Camera camera;
    bool operator==(const Shaded&) const = default;
  };

  struct Lit {
    std::shared_ptr<const Occluders> casters;
    Vec3 to_light{0};
    bool operator==(const Lit&) const = default;
  };

  /// What a referee asks: the lines as compose gives them, and which part is seen where several lie
  /// on each other.
  struct Judged {
    std::vector<Path> found;
    std::vector<double> ranks;
  };

  /// Fills `judged`, if any; `labels` with which parts are seen where, where the drawing is to have
  /// annotations.
  Drawing draw_lines(const Scene& scene, const Camera& camera, const Style& style,
                     const PartStyles& part_styles, const IllustrateOptions& options,
                     Judged* judged, Labels& labels, bool keeps, RunContext& context);
  std::shared_ptr<Lines> lines_of(const View& view, RunContext& context);
  /// Which parts are seen where, and the areas that are painted.
  Labels labels_of(const Scene& scene, const Drawing& drawing, const std::shared_ptr<Lines>& lines,
                   const Shaded& shaded, const Style& style, const PartStyles& part_styles,
                   const IllustrateOptions& options, RunContext& context);

  RealisedParts realised_;
  Kept<Surfaces, const std::vector<double>> sizes_;
  Kept<Solid, Occluders> occluders_, casters_;
  HatchedParts hatched_;
  Kept<View, Lines> lines_;
  Kept<Seen, Spans> seen_;
  Kept<LabelRequest, Labels> labels_;
  Kept<Parted, Partition> regions_;
  Kept<Toned, LightNormals> light_normals_;
  Kept<Lit, std::optional<LightView>> light_;
  Kept<Shaded, std::optional<Area>> shadow_;
};

}  // namespace burin::detail
