// Scalar B-splines over arbitrary knots.

#include <burin/base/error.h>
#include <burin/forms/implicit/volume_function.h>

#include "box_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr int kMaxOrder = 10;

// The functions of one axis that are not zero at a parameter, with two derivatives.
struct Basis {
  double w[3][kMaxOrder];
  std::int32_t first = 0;
};

class Axis {
 public:
  Axis(std::vector<double> knots, std::int32_t order, std::int32_t size)
      : knots_(std::move(knots)), order_(order), size_(size) {}

  double begin() const { return knots_[at(order_ - 1)]; }
  double end() const { return knots_[at(size_)]; }
  // The last of the knots at or before `t` that begins a span of some length.
  std::int32_t span(double t) const {
    const auto first = knots_.begin() + order_ - 1, last = knots_.begin() + size_;
    const auto it = std::upper_bound(first, last, t);
    auto s = static_cast<std::int32_t>(it - knots_.begin()) - 1;
    while (s > order_ - 1 && !(knots_[at(s)] < knots_[at(s + 1)])) --s;
    return s;
  }
  // Knots between which function i is not zero.
  double from(std::int32_t i) const { return knots_[at(i)]; }
  double to(std::int32_t i) const { return knots_[at(i + order_)]; }

  // The derivative's coefficient for this difference between those of functions i and i + 1.
  double rise(std::int32_t i, double difference) const {
    const double width = knots_[at(i + order_)] - knots_[at(i + 1)];
    return difference == 0 ? 0 : (order_ - 1) * difference / width;
  }

  void evaluate(double t, int derivatives, Basis& out) const {
    const std::int32_t s = span(t);
    out.first = s - order_ + 1;
    // Degree by degree; derivatives are differences of the functions of lower degree.
    double n[kMaxOrder] = {1};
    double lower[2][kMaxOrder] = {};
    for (int p = 1; p < order_; ++p) {
      if (order_ - p <= 2) std::copy(n, n + p, lower[order_ - p - 1]);
      raise(t, s, p, n);
    }
    std::copy(n, n + order_, out.w[0]);
    for (int d = 1; d <= derivatives; ++d) {
      double* w = out.w[d];
      std::fill(w, w + order_, 0.0);
      if (d >= order_) continue;
      std::copy(lower[d - 1], lower[d - 1] + order_ - d, w);
      for (int p = order_ - d; p < order_; ++p) differentiate(s, p, w);
    }
  }

 private:
  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

  // Functions of degree p - 1 (p of them) become those of degree p (p + 1).
  void raise(double t, std::int32_t s, int p, double* n) const {
    double saved = 0;
    for (int r = 0; r < p; ++r) {
      const double right = knots_[at(s + r + 1)], left = knots_[at(s + r + 1 - p)];
      const double share = n[r] / (right - left);
      n[r] = saved + (right - t) * share;
      saved = (t - left) * share;
    }
    n[p] = saved;
  }
  void differentiate(std::int32_t s, int p, double* n) const {
    double saved = 0;
    for (int r = 0; r < p; ++r) {
      const double share = p * n[r] / (knots_[at(s + r + 1)] - knots_[at(s + r + 1 - p)]);
      n[r] = saved - share;
      saved = share;
    }
    n[p] = saved;
  }

  std::vector<double> knots_;
  std::int32_t order_, size_;
};

class TrivariateField final : public BoxField {
 public:
  explicit TrivariateField(TrivariateSpline spline) : spline_(std::move(spline)) {
    for (std::size_t a = 0; a < 3; ++a) {
      axes_.emplace_back(spline_.knots[a], spline_.order[a], spline_.size[a]);
      origin_[static_cast<int>(a)] = axes_[a].begin();
      last_[static_cast<int>(a)] = axes_[a].end() - axes_[a].begin();
    }
  }

  Vec3 origin() const { return origin_; }
  Vec3 last() const override { return last_; }

  void values(std::span<const Vec3> at, std::span<double> out) const override {
    for (std::size_t i = 0; i < at.size(); ++i) out[i] = evaluate<0>(at[i]).value;
  }
  void gradients(std::span<const Vec3> at, std::span<Gradient1> out) const override {
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Gradient2 g = evaluate<1>(at[i]);
      out[i] = {g.value, g.gradient};
    }
  }
  void hessians(std::span<const Vec3> at, std::span<Gradient2> out) const override {
    for (std::size_t i = 0; i < at.size(); ++i) out[i] = evaluate<2>(at[i]);
  }

  void taking_part(Vec3 min, Vec3 max, std::array<std::int32_t, 3>& low,
                   std::array<std::int32_t, 3>& high) const {
    for (int a = 0; a < 3; ++a) {
      const auto k = static_cast<std::size_t>(a);
      const double end = last_[a];
      low[k] = axes_[k].span(origin_[a] + std::clamp(min[a], 0.0, end)) - spline_.order[k] + 1;
      high[k] = axes_[k].span(origin_[a] + std::clamp(max[a], 0.0, end));
    }
  }
  Interval range(Vec3 min, Vec3 max) const override {
    std::array<std::int32_t, 3> low, high;
    taking_part(min, max, low, high);
    return range(low, high);
  }
  // Derivatives are splines over differences of neighbouring coefficients.
  std::array<Interval, 3> slopes(Vec3 min, Vec3 max) const override {
    std::array<std::int32_t, 3> low, high;
    taking_part(min, max, low, high);
    std::array<Interval, 3> out;
    for (std::size_t a = 0; a < 3; ++a) {
      Interval r{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
      for (std::int32_t z = low[2]; z <= high[2]; ++z) {
        for (std::int32_t y = low[1]; y <= high[1]; ++y) {
          for (std::int32_t x = low[0]; x <= high[0]; ++x) {
            const std::array<std::int32_t, 3> at{x, y, z};
            if (at[a] == high[a]) continue;
            const double d =
                axes_[a].rise(at[a], *coefficient(x + (a == 0), y + (a == 1), z + (a == 2)) -
                                         *coefficient(x, y, z));
            r = {std::min(r.min, d), std::max(r.max, d)};
          }
        }
      }
      out[a] = r;
    }
    return out;
  }
  // Of all coefficients that take part on a side.
  Interval border_range() const override {
    Interval all{1, -1};
    for (int a = 0; a < 3; ++a) {
      for (const double side : {0.0, last_[a]}) {
        const Interval r = side_range(a, side);
        all = all.min > all.max ? r : Interval{std::min(all.min, r.min), std::max(all.max, r.max)};
      }
    }
    return all;
  }
  Box3 support(double level, bool above) const override {
    Box3 box;
    std::size_t n = 0;
    for (std::int32_t z = 0; z < spline_.size[2]; ++z) {
      for (std::int32_t y = 0; y < spline_.size[1]; ++y) {
        for (std::int32_t x = 0; x < spline_.size[0]; ++x, ++n) {
          const double c = spline_.coefficients[n];
          if (above ? !(c > level) : !(c < level)) continue;
          box.add(Vec3(axes_[0].from(x), axes_[1].from(y), axes_[2].from(z)) - origin_);
          box.add(Vec3(axes_[0].to(x), axes_[1].to(y), axes_[2].to(z)) - origin_);
        }
      }
    }
    if (box.empty()) return box;
    return {glm::max(box.min, Vec3(0)), glm::min(box.max, last_)};
  }

 private:
  // Layers of coefficients whose functions are exactly zero on the side do not count: with full
  // knots at the ends there is only one left.
  Interval side_range(int axis, double side) const {
    std::array<std::int32_t, 3> low{}, high;
    for (std::size_t k = 0; k < 3; ++k) high[k] = spline_.size[k] - 1;
    const auto a = static_cast<std::size_t>(axis);
    Basis b;
    axes_[a].evaluate(origin_[axis] + side, 0, b);
    int first = 0, last = spline_.order[a] - 1;
    while (first < last && b.w[0][first] == 0) ++first;
    while (last > first && b.w[0][last] == 0) --last;
    low[a] = b.first + first;
    high[a] = b.first + last;
    return range(low, high);
  }
  Interval range(const std::array<std::int32_t, 3>& low,
                 const std::array<std::int32_t, 3>& high) const {
    Interval r{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (std::int32_t z = low[2]; z <= high[2]; ++z) {
      for (std::int32_t y = low[1]; y <= high[1]; ++y) {
        const double* row = coefficient(0, y, z);
        for (std::int32_t x = low[0]; x <= high[0]; ++x) {
          r.min = std::min(r.min, row[x]);
          r.max = std::max(r.max, row[x]);
        }
      }
    }
    return r;
  }
  const double* coefficient(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return spline_.coefficients.data() +
           (static_cast<std::ptrdiff_t>(z) * spline_.size[1] + y) * spline_.size[0] + x;
  }

  template <int kOrder>
  Gradient2 evaluate(Vec3 at) const {
    const Vec3 p = glm::min(glm::max(at, Vec3(0)), last_);
    Gradient2 out;
    out.value = std::numeric_limits<double>::quiet_NaN();
    if (!(p.x + p.y + p.z >= 0)) return out;
    Basis b[3];
    for (std::size_t a = 0; a < 3; ++a) {
      const auto k = static_cast<int>(a);
      axes_[a].evaluate(origin_[k] + p[k], kOrder, b[a]);
    }
    // sum[i][j][k]: i-th derivative along x and so on, of the total order kOrder at most.
    double sum[kOrder + 1][kOrder + 1][kOrder + 1] = {};
    for (int z = 0; z < spline_.order[2]; ++z) {
      double plane[kOrder + 1][kOrder + 1] = {};
      for (int y = 0; y < spline_.order[1]; ++y) {
        const double* c = coefficient(b[0].first, b[1].first + y, b[2].first + z);
        double row[kOrder + 1] = {};
        for (int x = 0; x < spline_.order[0]; ++x) {
          for (int i = 0; i <= kOrder; ++i) row[i] += b[0].w[i][x] * c[x];
        }
        for (int i = 0; i <= kOrder; ++i) {
          for (int j = 0; i + j <= kOrder; ++j) plane[i][j] += b[1].w[j][y] * row[i];
        }
      }
      for (int i = 0; i <= kOrder; ++i) {
        for (int j = 0; i + j <= kOrder; ++j) {
          for (int k = 0; i + j + k <= kOrder; ++k) sum[i][j][k] += b[2].w[k][z] * plane[i][j];
        }
      }
    }
    out.value = sum[0][0][0];
    if constexpr (kOrder > 0) out.gradient = {sum[1][0][0], sum[0][1][0], sum[0][0][1]};
    if constexpr (kOrder > 1) {
      out.xx = sum[2][0][0];
      out.yy = sum[0][2][0];
      out.zz = sum[0][0][2];
      out.xy = sum[1][1][0];
      out.xz = sum[1][0][1];
      out.yz = sum[0][1][1];
    }
    return out;
  }

  TrivariateSpline spline_;
  std::vector<Axis> axes_;
  Vec3 origin_{0}, last_{0};
};

void check_spline(const TrivariateSpline& s) {
  std::size_t n = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const char axis = "xyz"[a];
    if (s.order[a] < 2 || s.order[a] > kMaxOrder) {
      throw UsageError(
          fmt::format("a trivariate spline has orders 2 to {}, not {}", kMaxOrder, s.order[a]));
    }
    if (s.size[a] < s.order[a]) {
      throw UsageError(fmt::format("a trivariate spline needs {} coefficients along {}, it has {}",
                                   s.order[a], axis, s.size[a]));
    }
    const auto order = static_cast<std::size_t>(s.order[a]),
               size = static_cast<std::size_t>(s.size[a]);
    if (s.knots[a].size() != order + size) {
      throw UsageError(fmt::format("a trivariate spline has {} knots along {} instead of {}",
                                   s.knots[a].size(), axis, order + size));
    }
    const auto finite = [](double v) { return std::isfinite(v); };
    if (!std::ranges::is_sorted(s.knots[a]) || !std::ranges::all_of(s.knots[a], finite)) {
      throw UsageError(fmt::format("the knots along {} do not ascend", axis));
    }
    if (!(s.knots[a][order - 1] < s.knots[a][size])) {
      throw UsageError(fmt::format("the knots along {} leave no room between them", axis));
    }
    n *= size;
  }
  if (s.coefficients.size() != n) {
    throw UsageError(fmt::format("a trivariate spline has {} coefficients instead of {}",
                                 s.coefficients.size(), n));
  }
  if (!std::ranges::all_of(s.coefficients, [](double v) { return std::isfinite(v); })) {
    throw UsageError("a trivariate spline has coefficients that are not finite");
  }
}

}  // namespace

std::shared_ptr<const ImplicitFunction> make_trivariate_function(TrivariateSpline spline,
                                                                 double level) {
  check_spline(spline);
  const auto [min, max] = std::ranges::minmax(spline.coefficients);
  if (!(min < level && level < max)) {
    throw GeometryError(
        fmt::format("the level {:.6g} is outside the range of the spline, {:.6g} to {:.6g}; give "
                    "one inside it",
                    level, min, max));
  }
  auto field = std::make_unique<const TrivariateField>(std::move(spline));
  BoxPlacement placement;
  placement.origin = field->origin();
  placement.level = level;
  const Vec3 size = field->last();
  placement.slope = (max - min) / std::max({size.x, size.y, size.z});
  return make_box_function(std::move(field), placement);
}

}  // namespace burin
