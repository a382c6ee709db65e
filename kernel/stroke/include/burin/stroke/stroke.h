#pragma once
/// Strokes: evenly spaced lines of a direction field whose widths and spacing carry the tone.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/field/field.h>
#include <burin/surface/surface.h>
#include <burin/tone/tone.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// The pen and the hatching; lengths in paper mm, tones as ink coverage (1 - reflectance). The
/// defaults are those of `Style`.
struct HatchOptions {
  /// Distance of neighbouring strokes of a family where the tone is darkest and where it is
  /// lightest.
  double spacing_min = 0.9;
  double spacing_max = 1.6;
  double width_min = 0.08;
  double width_max = 0.22;
  /// No ink where the tone asks for less than this.
  double tone_min = 0.35;
  /// The second family crosses the first where the tone asks for more than this; over 1 = never.
  double cross_from = 1.1;
  /// A stroke shorter than this is not drawn; one longer than about this ends (a third more or
  /// less, by chance).
  double length_min = 2.5;
  double length_max = 2000;
  /// Length over which a stroke's end thins out.
  double taper = 2.5;
  /// 0: equal spacing on paper whatever the slant of the surface; 1: equal spacing on the surface.
  double foreshortening = 0;
  std::uint64_t seed = 1;
};

/// What a ray through a point of the paper meets first.
struct ViewHit {
  std::int32_t part = -1;
  ProxyPoint point;
};
using ViewProbe = std::function<std::optional<ViewHit>(Vec2 paper)>;

struct StrokeResult {
  /// Kind Stroke, with widths, normals, faces, family; not yet cut by visibility.
  std::vector<Curve3> strokes;
  std::int64_t coverage_points = 0;
  /// Covering radius of the seeds over the visible hatched picture, in paper mm.
  double coverage_delta = 0;
  /// Number of parts that have so many layers of surface over each other that fewer seeds were
  /// tried than their area needs.
  std::int64_t thinned_parts = 0;
};

/// Places and traces the strokes of all parts and finds their widths. `probe` says what is visible
/// at a point of the paper. Stages "cover" and "trace" are timed on `context`. Throws UsageError
/// where the strokes would be longer than 1.6 km, Cancelled. Cost: kernel/docs/performance.md.
/// @cite Jobard1997, Elber1998
StrokeResult trace_strokes(std::span<const Surface* const> surfaces, const Camera& camera,
                           const Field& field, const Tone& tone, const ViewProbe& probe,
                           const HatchOptions& options, RunContext& context);

}  // namespace burin
