#pragma once
// The strokes of all parts of a drawing; internal to the module.

#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/illustrate/illustrate.h>
#include <burin/stroke/stroke.h>

#include "depth_cue.h"
#include "occluders.h"
#include "part_styles.h"
#include "undirected.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin::detail {

/// What a set of strokes is made of, seen from where: all that it depends on.
struct HatchRequest {
  std::shared_ptr<const Occluders> occluders;
  /// The parts that have these strokes.
  std::vector<bool> parts;
  /// A part that is seen alone, through which others can be seen.
  std::optional<std::size_t> alone;
  Camera camera;
  HatchStyle hatch;
  tone::ToneOptions tone;
  int number = 1;
  std::vector<double> exponents;
  DepthOptions depth;
  std::uint64_t seed = 1;
  std::shared_ptr<const Image> image;

  bool operator==(const HatchRequest&) const = default;
};

/// The strokes of one request, and where they would have had no direction.
struct Hatching {
  StrokeResult strokes;
  std::optional<Undirected::Found> undirected;
};

/// All strokes of a drawing, each hatching kept for the next one.
class HatchedParts {
 public:
  using Hatchings = std::vector<std::shared_ptr<const Hatching>>;

  /// Of the solid parts a kind of strokes at a time; then of the transparent ones, each as it is
  /// seen alone.
  Hatchings hatch(const std::shared_ptr<const Occluders>& occluders, const Camera& camera,
                  const PartStyles& part_styles, const DepthCue& cue, const DepthOptions& depth,
                  const IllustrateOptions& options, RunContext& context);

 private:
  struct Made {
    HatchRequest request;
    std::shared_ptr<const Hatching> hatching;
  };
  std::vector<Made> made_;
};

/// What is to be told of all of them; without the strokes themselves.
StrokeResult told_of(std::span<const std::shared_ptr<const Hatching>> hatchings);

/// Whether the ink of the whole picture is balanced: it is light and shade that need it. A tone
/// that a program brings, or that asks for the same ink in any light, is taken as it is.
bool balances(const tone::ToneOptions& tone);

}  // namespace burin::detail
