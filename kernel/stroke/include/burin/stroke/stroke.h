#pragma once
/// Strokes: evenly spaced lines of a direction field whose widths and spacing carry the tone.

#include <burin/base/curve.h>
#include <burin/base/image.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/field/field.h>
#include <burin/stroke/options.h>
#include <burin/stroke/stroke_memory.h>
#include <burin/surface/surface.h>
#include <burin/tone/tone.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// What a ray through a point of the paper meets first.
struct ViewHit {
  std::int32_t part = -1;
  ProxyPoint point;
  /// Model mm.
  Vec3 position{0};
  /// Whether strokes of this part are placed; of another one, which only hides what is behind it,
  /// no surface is known.
  bool hatched = true;
};
using ViewProbe = std::function<std::optional<ViewHit>(Vec2 paper)>;

/// What is made of the ink that the tone asks for.
struct InkOptions {
  /// Its median, contrast and gradient say how the ink of the whole picture is changed.
  tone::ToneOptions balance{};
  /// Of that each place keeps this share; empty: all of it.
  std::function<double(Vec3)> fade{};
  /// One a part: of the paper that the ink leaves bare, these strokes leave its power; empty: 1.
  /// Strokes of several kinds whose exponents add up to 1 have the tone together.
  std::vector<double> exponents{};
  /// With exponents: no strokes where the ink of all kinds together is less.
  double tone_min = 0;
  /// What laws call image(u, v); null: nothing.
  std::shared_ptr<const Image> image{};
  /// What the keys of these strokes begin with, for errors.
  std::string keys = "hatch.";
};

struct StrokeResult {
  /// Kind Stroke, with widths, normals, faces, family; not yet cut by visibility.
  std::vector<Curve3> strokes;
  std::int64_t coverage_points = 0;
  /// Covering radius of the seeds over the visible hatched picture, in paper mm.
  double coverage_delta = 0;
  /// Number of parts that have so many layers of surface over each other that fewer seeds were
  /// tried than their area needs.
  std::int64_t thinned_parts = 0;
  /// Parts without u and v that laws of these strokes look at.
  std::vector<std::int32_t> unmapped{};
  /// The exponent of all ink that brought its median where the balance wants it.
  double tone_gamma = 1;
};

/// Places and traces the strokes of all parts and finds their widths. `probe` says what is visible
/// at a point of the paper; chance follows `seed`. Stages "cover" and
/// "trace" are timed on `context`. Throws UsageError for options that contradict each other and
/// where the strokes would be longer than 1.6 km, Cancelled. `memory`: of the last call with the
/// same arguments but tone and ink; null: none is kept. Cost: tests/bench/results/performance.md.
/// @cite Elber1998, Knoeppel2015
StrokeResult trace_strokes(std::span<const Surface* const> surfaces, const Camera& camera,
                           const Field& field, const Tone& tone, const ViewProbe& probe,
                           const HatchOptions& options, std::uint64_t seed, RunContext& context,
                           const InkOptions& ink = {}, StrokeMemory* memory = nullptr);

}  // namespace burin
