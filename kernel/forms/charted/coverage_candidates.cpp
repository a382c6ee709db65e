#include "coverage_candidates.h"

#include <burin/base/affine.h>
#include <burin/base/error.h>
#include <burin/forms/charted/nurbs.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

double picture_scale2(const Camera& camera, Vec3 p) {
  const double scale = camera.area_scale(p);
  if (!(scale > 0) || !std::isfinite(scale)) {
    throw GeometryError("the viewer is inside a surface's control points: move it away");
  }
  return scale;
}

/// Points whose hull holds the surface: control points, or (nearly) a lattice of its points.
std::vector<Vec3> hull_points(const Chart& chart) {
  if (const NurbsData* data = nurbs_data(chart)) return data->points;
  constexpr int kSide = 32;
  std::vector<Vec3> points;
  const ParameterBox box = chart.domain();
  for (int i = 0; i <= kSide; ++i) {
    for (int j = 0; j <= kSide; ++j) {
      points.push_back(chart.position(box.min + Vec2(i, j) / double{kSide} * box.size()));
    }
  }
  return points;
}

}  // namespace

Candidates::Candidates(const Chart& chart, const CoverageOptions& options)
    : chart_(chart),
      options_(options),
      box_(chart.domain()),
      rng_(options.seed, static_cast<std::uint64_t>(options.part),
           static_cast<std::uint64_t>(options.face)),
      even_(is_similar(options.placement)),
      scale2_(area_stretch(options.placement)) {
  if (options.norm != CoverageNorm::Picture) return;
  if (!options.camera) throw GeometryError("coverage uniform in the picture needs a camera");
  picture_scale2_ = picture_bound();
}

// Scale grows with depth and the other factor is quasi-convex: both are largest at a control point.
double Candidates::picture_bound() const {
  double best = 0;
  for (const Vec3& p : hull_points(chart_)) {
    best = std::max(best, picture_scale2(*options_.camera, options_.placement.point(p)));
  }
  return nurbs_data(chart_) ? best : 1.1 * best;
}

double Candidates::measure(const SurfaceDerivatives& d) const {
  if (options_.norm != CoverageNorm::Picture && even_) return glm::length(glm::cross(d.u, d.v));
  const Vec3 p = options_.placement.point(d.p), du = options_.placement.vector(d.u),
             dv = options_.placement.vector(d.v);
  if (options_.norm != CoverageNorm::Picture) return glm::length(glm::cross(du, dv)) / scale2_;
  const Vec2 u = options_.camera->velocity(p, du), v = options_.camera->velocity(p, dv);
  return std::abs(cross2(u, v)) / (scale2_ * picture_scale2_);
}

Candidates::Result Candidates::draw(std::uint64_t i, double bound, Stream stream) const {
  const std::uint64_t n = (std::uint64_t{stream} << 60) + kDraws * i;
  Result r;
  r.point.uv = box_.min + Vec2(rng_.uniform(n), rng_.uniform(n + 1)) * box_.size();
  const SurfaceDerivatives d = chart_.derivatives(r.point.uv);
  const double test = rng_.uniform(n + 2);
  if (options_.norm != CoverageNorm::Parameters) {
    r.area = glm::length(glm::cross(d.u, d.v));
    if (!(test * bound < measure(d))) return r;
  }
  r.kept = true;
  r.point.position = options_.placement.point(d.p);
  r.point.normal =
      chart_normal(placed(options_.placement, d), options_.reversed != options_.placement.mirrors(),
                   r.point.uv, box_.center());
  if (!options_.density) return r;
  const double density = options_.density(r.point);
  r.density = density > 0 ? std::min(density, 1.0) : 0;
  return r;
}

double Candidates::mean_measure() const {
  constexpr std::uint64_t kSamples = 1024;
  double sum = 0;
  for (std::uint64_t i = 0; i < kSamples; ++i) {
    const std::uint64_t n = (std::uint64_t{2} << 60) + 2 * i;
    const Vec2 uv = box_.min + Vec2(rng_.uniform(n), rng_.uniform(n + 1)) * box_.size();
    sum += measure(chart_.derivatives(uv));
  }
  const double per_chart = options_.norm == CoverageNorm::Picture ? picture_scale2_ : 1;
  return sum / kSamples * scale2_ * per_chart;
}

}  // namespace burin
