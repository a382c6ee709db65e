#include "box_function.h"

#include <burin/base/box_corners.h>

#include "clipped.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace burin {
namespace {

// In model coordinates. `range` bounds it over the part of a box
// that lies inside the field only.
class BoxFunction final : public ImplicitFunction {
 public:
  // How the function goes on outside the box: along its tangents, for a plane to cut it, or
  // upwards, where the border is outside anyway.
  enum class Beyond : std::uint8_t { Straight, Up };

  BoxFunction(std::unique_ptr<const BoxField> field, const BoxPlacement& placement)
      : field_(std::move(field)),
        last_(field_->last()),
        origin_(placement.origin),
        inverse_(glm::inverse(placement.steps)),
        level_(placement.level),
        sign_(placement.inside_above ? -1 : 1),
        slope_(placement.slope) {
    const Interval border = toward(field_->border_range());
    least_ = border.min;
    beyond_ = border.min > 0 ? Beyond::Up : Beyond::Straight;
    const Box3 inside = field_->support(level_, placement.inside_above);
    if (inside.empty()) return;
    for (const Vec3& corner : corners_of(inside)) {
      bounds_.add(origin_ + placement.steps * corner);
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
    const auto [min, max] = coordinates(box);
    if (!(max.x - max.x == 0) || !(max.y - max.y == 0) || !(max.z - max.z == 0)) return {};
    Interval r = toward(field_->range(min, max));
    if (beyond_ == Beyond::Straight) return r;
    bool partly = false;
    for (int a = 0; a < 3; ++a) {
      partly |= min[a] < 0 || max[a] > last_[a];
      if (max[a] < 0 || min[a] > last_[a]) r.min = least_;
    }
    if (partly) r.max = std::numeric_limits<double>::infinity();
    return r;
  }
  Interval slope(const Box3& box, Vec3 direction) const override {
    const auto [min, max] = coordinates(box);
    for (int a = 0; a < 3; ++a) {
      if (!(min[a] >= 0) || !(max[a] <= last_[a])) return {};
    }
    const std::array<Interval, 3> slopes = field_->slopes(min, max);
    const Vec3 d = sign_ * (inverse_ * direction);
    Interval r{0, 0};
    for (int a = 0; a < 3; ++a) {
      const Interval s = slopes[static_cast<std::size_t>(a)];
      if (d[a] == 0) continue;
      r.min += d[a] * (d[a] > 0 ? s.min : s.max);
      r.max += d[a] * (d[a] > 0 ? s.max : s.min);
    }
    return r;
  }
  bool has_slopes() const override { return true; }
  Box3 bounds() const override { return bounds_; }

  std::vector<HalfSpace> planes() const {
    std::vector<HalfSpace> out;
    for (int a = 0; a < 3; ++a) {
      // Row a of the inverse: the coordinate along a.
      const Vec3 row = slope_ * Vec3(inverse_[0][a], inverse_[1][a], inverse_[2][a]);
      const double at = glm::dot(row, origin_);
      out.push_back({-row, -at});
      out.push_back({row, at + slope_ * last_[a]});
    }
    return out;
  }

 private:
  // Of the box around a box.
  Box3 coordinates(const Box3& box) const {
    const Vec3 middle = inverse_ * (box.center() - origin_), half = 0.5 * box.size();
    Vec3 reach(0);
    for (int a = 0; a < 3; ++a) reach += half[a] * glm::abs(inverse_[a]);
    return {middle - reach, middle + reach};
  }

  Interval toward(Interval r) const {
    return sign_ < 0 ? Interval{level_ - r.max, level_ - r.min}
                     : Interval{r.min - level_, r.max - level_};
  }

  static double& value_of(double& v) { return v; }
  static double& value_of(Gradient1& g) { return g.value; }
  static double& value_of(Gradient2& g) { return g.value; }
  void evaluate(std::span<const Vec3> at, std::span<double> out) const { field_->values(at, out); }
  void evaluate(std::span<const Vec3> at, std::span<Gradient1> out) const {
    field_->gradients(at, out);
  }
  void evaluate(std::span<const Vec3> at, std::span<Gradient2> out) const {
    field_->hessians(at, out);
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
        const Vec3 on = glm::min(glm::max(at[i], Vec3(0)), last_);
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
      return;
    }
    // Along the tangents: the derivatives are those of what it goes on as, or Newton's rule would
    // creep there.
    Gradient2 g;
    field_->hessians({&on, 1}, {&g, 1});
    value_of(out) += sign_ * glm::dot(g.gradient, gap);
    if constexpr (!std::is_same_v<Out, double>) {
      const Vec3 change = sign_ * g.hessian_times(gap);
      for (int a = 0; a < 3; ++a) {
        if (gap[a] == 0) out.gradient[a] += change[a];
      }
    }
    if constexpr (std::is_same_v<Out, Gradient2>) {
      if (gap.x != 0) out.xx = 0;
      if (gap.y != 0) out.yy = 0;
      if (gap.z != 0) out.zz = 0;
      if (gap.x != 0 && gap.y != 0) out.xy = 0;
      if (gap.x != 0 && gap.z != 0) out.xz = 0;
      if (gap.y != 0 && gap.z != 0) out.yz = 0;
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

  std::unique_ptr<const BoxField> field_;
  Vec3 last_, origin_;
  Mat3 inverse_;
  double level_, sign_;
  double slope_;  // data units a sample, of what bounds the function
  double least_ = 0;
  Beyond beyond_ = Beyond::Up;
  Box3 bounds_;
};

}  // namespace

std::shared_ptr<const ImplicitFunction> make_box_function(std::unique_ptr<const BoxField> field,
                                                          const BoxPlacement& placement) {
  auto f = std::make_shared<const BoxFunction>(std::move(field), placement);
  if (f->beyond() == BoxFunction::Beyond::Up) return f;
  return clip(f, f->planes(), f->bounds());
}

}  // namespace burin
