#include <burin/base/error.h>
#include <burin/forms/implicit/volume_function.h>

#include "volume_spline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

void check_grid(const VolumeGrid& grid, const VolumeOptions& options) {
  constexpr std::int64_t kMostSamples = std::int64_t{1} << 31;
  std::int64_t n = 1;
  for (const std::int32_t s : grid.size) {
    if (s < 2) throw UsageError("a volume needs at least 2 samples along each axis");
    n = n > kMostSamples ? n : n * s;
  }
  if (n > kMostSamples) throw UsageError("the volume has more than 2^31 samples");
  if (static_cast<std::int64_t>(grid.samples.size()) != n) {
    throw UsageError(fmt::format("the volume has {} samples instead of {} x {} x {}",
                                 grid.samples.size(), grid.size[0], grid.size[1], grid.size[2]));
  }
  // Volume of the cell against that of a box with the same sides: below 1e-9 the axes are as good
  // as in one plane.
  const double cell = std::abs(glm::determinant(grid.steps));
  const double sides =
      glm::length(grid.steps[0]) * glm::length(grid.steps[1]) * glm::length(grid.steps[2]);
  if (!(cell > 1e-9 * sides) || !(sides < 1e300)) {
    throw UsageError("the volume's axes are not three independent directions");
  }
  if (options.degree != 2 && options.degree != 3) {
    throw UsageError(fmt::format("a volume's degree is 2 or 3, not {}", options.degree));
  }
  if (!(options.smoothing >= 0) || !(options.smoothing <= 100)) {
    throw UsageError("a volume's smoothing is from 0 to 100 samples");
  }
  if (!std::isfinite(options.level)) throw UsageError("a volume's level is a finite number");
}

// Least and largest finite sample; others are replaced by the one that is outside.
Interval clean(std::vector<float>& samples, bool inside_above) {
  Interval r{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  bool broken = false;
  for (const float s : samples) {
    if (!std::isfinite(s)) {
      broken = true;
      continue;
    }
    r.min = std::min(r.min, static_cast<double>(s));
    r.max = std::max(r.max, static_cast<double>(s));
  }
  if (r.min > r.max) throw GeometryError("the volume has no sample that is a number");
  if (broken) {
    const auto outside = static_cast<float>(inside_above ? r.min : r.max);
    for (float& s : samples) {
      if (!std::isfinite(s)) s = outside;
    }
  }
  return r;
}

void check_level(Interval range, const VolumeOptions& options) {
  if (range.min < options.level && options.level < range.max) return;
  throw GeometryError(fmt::format(
      "the level {:.6g} is outside the range of the data, {:.6g} to {:.6g}{}; give one "
      "inside it",
      options.level, range.min, range.max, options.smoothing > 0 ? " after smoothing" : ""));
}

}  // namespace

std::shared_ptr<const ImplicitFunction> make_volume_function(VolumeGrid grid,
                                                             const VolumeOptions& options,
                                                             const RunContext& context) {
  check_grid(grid, options);
  Interval range = clean(grid.samples, options.inside_above);
  const SampleBlock block{grid.size, grid.samples};
  if (options.smoothing > 0) {
    smooth_samples(block, options.smoothing, context);
    range = clean(grid.samples, options.inside_above);
  }
  check_level(range, options);
  if (options.interpolate) interpolate_samples(block, options.degree, context);
  auto spline = std::make_unique<const VolumeSpline>(block, options.degree, context);
  grid.samples = {};
  // An edge of the data falls by its whole range within some samples.
  constexpr double kEdge = 4;
  return make_box_function(std::move(spline),
                           {grid.origin, grid.steps, options.level, options.inside_above,
                            (range.max - range.min) / kEdge});
}

}  // namespace burin
