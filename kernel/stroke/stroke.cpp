#include <burin/base/error.h>
#include <burin/stroke/stroke.h>

#include "placement.h"
#include "seeds.h"
#include "view_raster.h"
#include "widths.h"

#include <cmath>

namespace burin {
namespace {

using namespace detail;

void check(const HatchOptions& o) {
  const bool sane = o.spacing_min > 0 && o.spacing_max >= o.spacing_min && o.width_min > 0 &&
                    o.width_max >= o.width_min && o.length_min >= 0 && o.length_max > o.length_min;
  if (!sane) {
    throw UsageError(
        "hatch options contradict each other: spacing, width and length each need 0 < min <= max");
  }
}

// Model mm within which two hits along a viewing ray are one surface: what single precision of the
// rays and the chords of the proxy can move them, as a share of the scene's size.
double same_place(std::span<const Surface* const> surfaces) {
  Box3 box;
  double tolerance = 0;
  for (const Surface* s : surfaces) {
    box.add(s->proxy().mesh.bounds());
    tolerance = std::max(tolerance, s->proxy().tolerance);
  }
  return 1e-4 * box.diagonal() + 2 * tolerance;
}

// Takes the kinks out of a line that crossed the facets of a coarse mesh: low-pass filtering
// without shrinking, ends kept.
// @cite Taubin1995
void fair(std::vector<Vec3>& points, bool closed) {
  constexpr int kPasses = 6;
  constexpr double kShrink = 0.5,
                   kInflate = -0.53;  // a pass band of waves longer than about 12 samples
  const std::size_t n = points.size();
  if (n < 4) return;
  std::vector<Vec3> moved(n);
  for (int pass = 0; pass < 2 * kPasses; ++pass) {
    const double weight = pass % 2 == 0 ? kShrink : kInflate;
    for (std::size_t i = 0; i < n; ++i) {
      const bool fixed = !closed && (i == 0 || i + 1 == n);
      // The place that the point would have on the straight line between its neighbours.
      const Vec3 a = points[(i + n - 1) % n], b = points[(i + 1) % n];
      const double before = glm::distance(a, points[i]), after = glm::distance(points[i], b);
      const double t = before + after > 0 ? before / (before + after) : 0.5;
      const Vec3 middle = a + t * (b - a);
      moved[i] = fixed ? points[i] : points[i] + weight * (middle - points[i]);
    }
    points.swap(moved);
  }
}

Curve3 to_curve(const TracedStroke& stroke, const Surface& surface, std::vector<double> widths) {
  Curve3 c;
  c.kind = LineClass::Stroke;
  c.family = stroke.family;
  c.closed = stroke.closed;
  c.source = {stroke.part, surface.proxy().face_source(stroke.samples.front().face), -1};
  c.widths = std::move(widths);
  for (const StrokeSample& s : stroke.samples) {
    c.points.push_back(surface.drawn_position(s.point));
    c.normals.push_back(s.normal);
    c.faces.push_back(static_cast<std::int32_t>(s.face));
  }
  if (!c.closed) c.faces.pop_back();
  fair(c.points, c.closed);
  return c;
}

}  // namespace

StrokeResult trace_strokes(std::span<const Surface* const> surfaces, const Camera& camera,
                           const Field& field, const Tone& tone, const ViewProbe& probe,
                           const HatchOptions& options, RunContext& context) {
  check(options);
  const Picture picture{surfaces, camera, field, tone, probe, options, same_place(surfaces)};
  context.begin_stage("cover");
  const ViewRaster raster = make_raster(picture, context);
  const Coverage coverage = cover_picture(picture, raster, context);

  context.begin_stage("trace");
  const std::vector<Family> families =
      place_families(picture, raster, coverage.seeds, options.cross_from <= 1 ? 2 : 1, context,
                     [&](double share) { context.progress(0.8 * share); });
  Widths widths = solve_widths(picture, raster, families, context);

  StrokeResult result;
  result.coverage_points = static_cast<std::int64_t>(coverage.seeds.size());
  result.coverage_delta = coverage.delta;
  for (std::size_t f = 0; f < families.size(); ++f) {
    for (std::size_t s = 0; s < families[f].strokes.size(); ++s) {
      result.strokes.push_back(to_curve(families[f].strokes[s],
                                        picture.surface(families[f].strokes[s].part),
                                        std::move(widths[f][s])));
    }
  }
  context.end_stage();
  return result;
}

}  // namespace burin
