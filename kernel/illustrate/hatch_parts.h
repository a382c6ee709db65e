#pragma once
// The strokes of all parts of a drawing; internal to the module.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/illustrate/illustrate.h>
#include <burin/stroke/stroke.h>

#include "depth_cue.h"
#include "missing_directions.h"
#include "occluders.h"
#include "part_styles.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin::detail {

/// Where a set of strokes stands, whatever the tone is.
struct HatchPlace {
  std::shared_ptr<const Occluders> occluders{};
  /// The parts that have these strokes.
  std::vector<bool> parts{};
  /// A part that is seen alone, through which others can be seen.
  std::optional<std::size_t> alone{};
  Camera camera;
  field::FieldOptions field{};
  bool follows_field = true;
  /// What directions look at that follow the light.
  std::optional<Vec3> light{};
  HatchOptions lines{};  // see remembered_by
  std::uint64_t seed = 1;
  std::shared_ptr<const Image> image{};

  bool operator==(const HatchPlace&) const = default;
};

/// The strokes as a whole: all that they depend on.
struct HatchRequest {
  HatchPlace place;
  HatchStyle hatch;
  tone::ToneOptions tone;
  int number = 1;
  std::vector<double> exponents;
  DepthOptions depth;

  bool operator==(const HatchRequest&) const = default;
};

/// What is made for a place, for as long as strokes stand there.
class HatchPreparation;

/// The strokes of one request, and where they would have had no direction.
struct Hatching {
  StrokeResult strokes;
  std::optional<MissingDirections::Found> missing_directions;
  /// Plug-ins that failed, a sentence each: the strokes are those without them.
  std::vector<std::string> failed{};
};

/// All strokes of a drawing, each hatching kept for the next one.
class HatchedParts {
 public:
  using Hatchings = std::vector<std::shared_ptr<const Hatching>>;

  /// Of the solid parts a kind of strokes at a time; then of the transparent ones, each as it is
  /// seen alone. `keeps`: for another drawing.
  Hatchings hatch(const std::shared_ptr<const Occluders>& occluders, const Camera& camera,
                  const PartStyles& part_styles, const DepthCue& cue, const DepthOptions& depth,
                  const IllustrateOptions& options, bool keeps, RunContext& context);

 private:
  struct Made {
    HatchRequest request;
    std::shared_ptr<HatchPreparation> prepared;
    std::shared_ptr<const Hatching> hatching;
  };
  std::vector<Made> made_;
  /// Of catalogues, when these were made.
  std::uint64_t growth_ = 0;
};

/// What is to be told of all of them; without the strokes themselves.
StrokeResult stroke_totals(std::span<const std::shared_ptr<const Hatching>> hatchings);

/// Plug-ins that failed, each once.
void report_failed(const HatchedParts::Hatchings& hatchings, Diagnostics& diagnostics);

/// Whether the ink of the whole picture is balanced: it is light and shade that need it. A tone
/// that a program brings, or that asks for the same ink in any light, is taken as it is.
bool balances(const tone::ToneOptions& tone);

}  // namespace burin::detail
