#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/forms/implicit/volume_function.h>

#include "clipped.h"
#include "volume_spline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

// level - spline, or its negative, in model coordinates. `range` bounds it over the part of a box
// that lies inside the grid only.
class VolumeFunction final : public ImplicitFunction {
 public:
  // How the function goes on outside the grid: along its tangents, for a plane to cut it, or
  // upwards, where the border is outside anyway.
  enum class Beyond : std::uint8_t { Straight, Up };

  VolumeFunction(VolumeSpline spline, const VolumeGrid& grid, const VolumeOptions& options,
                 double slope)
      : spline_(std::move(spline)),
        origin_(grid.origin),
        steps_(grid.steps),
        inverse_(glm::inverse(grid.steps)),
        level_(options.level),
        sign_(options.inside_above ? -1 : 1),
        slope_(slope) {
    const Interval border = toward(spline_.border_range());
    least_ = border.min;
    beyond_ = border.min > 0 ? Beyond::Up : Beyond::Straight;
    const Box3 inside = spline_.support(level_, options.inside_above);
    if (inside.empty()) return;
    for (int k = 0; k < 8; ++k) {
      bounds_.add(origin_ + steps_ * Vec3(k & 1 ? inside.max.x : inside.min.x,
                                          k & 2 ? inside.max.y : inside.min.y,
                                          k & 4 ? inside.max.z : inside.min.z));
    }
  }

  Beyond beyond() const { return beyond_; }

  void values(std::span<const Vec3> points, std::span<double> out) const override {
    run<double>(points, out);
  }
  void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const override {
    run<Gradient1>(points, out);
  }
  void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const override {
    run<Gradient2>(points, out);
  }

  Interval range(const Box3& box) const override {
    const Vec3 middle = inverse_ * (box.center() - origin_), half = 0.5 * box.size();
    Vec3 reach(0);
    for (int a = 0; a < 3; ++a) reach += half[a] * glm::abs(inverse_[a]);
    const Vec3 min = middle - reach, max = middle + reach;
    if (!(max.x - max.x == 0) || !(max.y - max.y == 0) || !(max.z - max.z == 0)) return {};
    Interval r = toward(spline_.range(min, max));
    if (beyond_ == Beyond::Straight) return r;
    bool partly = false;
    for (int a = 0; a < 3; ++a) {
      partly |= min[a] < 0 || max[a] > spline_.last()[a];
      if (max[a] < 0 || min[a] > spline_.last()[a]) r.min = least_;
    }
    if (partly) r.max = std::numeric_limits<double>::infinity();
    return r;
  }
  Box3 bounds() const override { return bounds_; }

  std::vector<HalfSpace> planes() const {
    std::vector<HalfSpace> out;
    for (int a = 0; a < 3; ++a) {
      // Row a of the inverse: the coordinate along a.
      const Vec3 row = slope_ * Vec3(inverse_[0][a], inverse_[1][a], inverse_[2][a]);
      const double at = glm::dot(row, origin_);
      out.push_back({-row, -at});
      out.push_back({row, at + slope_ * spline_.last()[a]});
    }
    return out;
  }

 private:
  Interval toward(Interval r) const {
    return sign_ < 0 ? Interval{level_ - r.max, level_ - r.min}
                     : Interval{r.min - level_, r.max - level_};
  }

  static double& value_of(double& v) { return v; }
  static double& value_of(Gradient1& g) { return g.value; }
  static double& value_of(Gradient2& g) { return g.value; }
  void evaluate(std::span<const Vec3> at, std::span<double> out) const { spline_.values(at, out); }
  void evaluate(std::span<const Vec3> at, std::span<Gradient1> out) const {
    spline_.gradients(at, out);
  }
  void evaluate(std::span<const Vec3> at, std::span<Gradient2> out) const {
    spline_.hessians(at, out);
  }

  template <class Out>
  void run(std::span<const Vec3> points, std::span<Out> out) const {
    constexpr std::size_t kChunk = 64;
    std::array<Vec3, kChunk> at;
    for (std::size_t first = 0; first < points.size(); first += kChunk) {
      const std::size_t n = std::min(kChunk, points.size() - first);
      for (std::size_t i = 0; i < n; ++i) at[i] = inverse_ * (points[first + i] - origin_);
      const auto part = out.subspan(first, n);
      evaluate(std::span<const Vec3>(at.data(), n), part);
      for (std::size_t i = 0; i < n; ++i) {
        value_of(part[i]) = sign_ * (value_of(part[i]) - level_);
        if constexpr (!std::is_same_v<Out, double>) part[i].gradient *= sign_;
        if constexpr (std::is_same_v<Out, Gradient2>) {
          for (double* h :
               {&part[i].xx, &part[i].yy, &part[i].zz, &part[i].xy, &part[i].xz, &part[i].yz}) {
            *h *= sign_;
          }
        }
        const Vec3 on = glm::min(glm::max(at[i], Vec3(0)), spline_.last());
        if (on != at[i]) go_beyond(on, at[i] - on, part[i]);
        to_world(part[i]);
      }
    }
  }

  // What is not a number stays so.
  template <class Out>
  void go_beyond(Vec3 on, Vec3 gap, Out& out) const {
    if (beyond_ == Beyond::Up) {
      value_of(out) += slope_ * glm::length(gap);
      if constexpr (!std::is_same_v<Out, double>) {
        for (int a = 0; a < 3; ++a) {
          if (gap[a] != 0) out.gradient[a] = 0;
        }
        out.gradient += slope_ * normalize_or(gap, Vec3(0));
      }
    } else if constexpr (std::is_same_v<Out, double>) {
      Gradient1 g;
      spline_.gradients({&on, 1}, {&g, 1});
      out += sign_ * glm::dot(g.gradient, gap);
    } else {
      out.value += glm::dot(out.gradient, gap);
    }
  }

  void to_world(double&) const {}
  template <class Out>
  void to_world(Out& g) const {
    g.gradient = g.gradient * inverse_;
    if constexpr (std::is_same_v<Out, Gradient2>) {
      const Mat3 h(g.xx, g.xy, g.xz, g.xy, g.yy, g.yz, g.xz, g.yz, g.zz);
      const Mat3 w = glm::transpose(inverse_) * h * inverse_;
      g.xx = w[0][0];
      g.yy = w[1][1];
      g.zz = w[2][2];
      g.xy = 0.5 * (w[0][1] + w[1][0]);
      g.xz = 0.5 * (w[0][2] + w[2][0]);
      g.yz = 0.5 * (w[1][2] + w[2][1]);
    }
  }

  VolumeSpline spline_;
  Vec3 origin_;
  Mat3 steps_, inverse_;
  double level_, sign_;
  double slope_;  // data units a sample, of what bounds the function
  double least_ = 0;
  Beyond beyond_ = Beyond::Up;
  Box3 bounds_;
};

void check(const VolumeGrid& grid, const VolumeOptions& options) {
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
  if (!(options.smoothing >= 0) || !(options.smoothing <= 50)) {
    throw UsageError("a volume's smoothing is from 0 to 50 samples");
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
  check(grid, options);
  Interval range = clean(grid.samples, options.inside_above);
  const SampleBlock block{grid.size, grid.samples};
  if (options.smoothing > 0) {
    smooth_samples(block, options.smoothing, context);
    range = clean(grid.samples, options.inside_above);
  }
  check_level(range, options);
  if (options.interpolate) interpolate_samples(block, options.degree, context);
  VolumeSpline spline(block, options.degree, context);
  grid.samples = {};
  // An edge of the data falls by its whole range within some samples.
  constexpr double kEdge = 4;
  auto f = std::make_shared<const VolumeFunction>(std::move(spline), grid, options,
                                                  (range.max - range.min) / kEdge);
  if (f->beyond() == VolumeFunction::Beyond::Up) return f;
  return clip(f, f->planes(), f->bounds());
}

}  // namespace burin
