#pragma once
/// Algorithm 1: points spread over S(u,v) by rejection against a bound of |Su x Sv|. Drawings take
/// theirs from `Surface::cover`, which holds trimmed faces against the same bounds.
/// @cite Elber1998

#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/forms/charted/chart.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace burin {

/// A bound of R = |Su x Sv| over the whole domain.
struct AreaBound {
  double value = 0;
  /// False where it comes from samples (charts that are not NURBS): likely, not certain.
  bool proved = false;
  /// The largest R that was met: `value` is at most value / attained too large.
  double attained = 0;
  std::size_t subdivisions = 0;
};

/// NURBS: R^2 as a Bezier field a span (rational: numerator and denominator apart), its products
/// and derivatives taken symbolically; the square root of the largest coefficient is a true bound,
/// and the spans that it comes from are subdivided until value <= (1 + tolerance) * attained. An
/// infinite tolerance gives the largest coefficient as it is. Charts that know their
/// `largest_area`: that. Others: 64 x 64 samples, the best of them climbed, and a twentieth more.
/// Cost: 10 us per bicubic span.
AreaBound area_bound(const Chart& chart, const RunContext& context, double tolerance = 0.05);
/// The same, or nothing where it would come from samples.
std::optional<AreaBound> proved_area_bound(const Chart& chart, const RunContext& context,
                                           double tolerance = 0.05);

/// In which measure points are uniform.
enum class CoverageNorm : std::uint8_t {
  Area,        // in space
  Parameters,  // in (u,v)
  Picture,     // on paper, seen or not
};

struct CoveragePoint {
  Vec2 uv{0};
  /// In place, model mm; the unit normal outward.
  Vec3 position{0}, normal{0};
};

struct CoverageOptions {
  /// How many points. With `spacing`: at most so many.
  std::size_t count = 1000;
  CoverageNorm norm = CoverageNorm::Area;
  /// Needed by Picture.
  const Camera* camera = nullptr;
  /// Relative density in [0,1] (a tone, a texture); absent = 1. With `spacing`, discs grow by
  /// 1/sqrt(density), up to four times, and there are no points where it is below 1/100.
  std::function<double(const CoveragePoint&)> density = {};
  /// Greater than 0: Poisson discs. No two points are nearer than this: in space in model mm, with
  /// Picture in paper mm among points that face the viewer alike and are no farther apart in depth
  /// than 16 spacings (one sheet of the surface does not thin out the other).
  double spacing = 0;
  Placement placement = {};
  /// Whether the outward normal is -(Su x Sv) of the chart.
  bool reversed = false;
  /// The stream of random numbers is keyed by (seed, part, face).
  std::uint64_t seed = 1;
  std::int32_t part = 0, face = 0;
  /// Whether the covering radius is measured, which costs more than the points.
  bool measure = true;
};

struct Coverage {
  /// In the order of the candidates; fewer than asked where the density is zero almost everywhere
  /// or no further disc fits.
  std::vector<CoveragePoint> points;
  /// Candidates drawn up to the last point.
  std::size_t candidates = 0;
  AreaBound bound;
  /// Definition 1: the largest distance from a place of S to its nearest point, measured at
  /// `measured_at` random places whose density is not zero (8 a point). Model mm; Picture: paper
  /// mm.
  double covering_radius = 0;
  std::size_t measured_at = 0;
};

/// Covers the whole domain of a chart. Where a bound that is not proved turns out too small it is
/// raised and all is drawn again, so that the points are uniform under the bound reported. The same
/// for any number of threads. Throws GeometryError where Picture has no camera or the viewer stands
/// inside the control points. Cost: 0.1 us per candidate; 5 us per point to measure the radius.
Coverage cover_chart(const Chart& chart, const CoverageOptions& options, const RunContext& context);

}  // namespace burin
