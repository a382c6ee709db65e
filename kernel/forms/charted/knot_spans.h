#pragma once
// One direction of a B-spline: its spans that are not empty, how to find them, and each as Bezier.

#include <cmath>
#include <cstdint>
#include <vector>

namespace burin {

/// Parameters outside [min, max] wrap where there is a period and are clamped elsewhere.
inline double fold_parameter(double x, double min, double max, double period) {
  if (x >= min && x <= max) return x;
  if (period > 0 && std::isfinite(x)) {
    x -= period * std::floor((x - min) / period);
    return x >= min && x <= max ? x : min;
  }
  return x > max ? max : min;  // not a number -> min
}

class KnotSpans {
 public:
  /// Knots nearer to each other than 1e-12 of the domain count as one.
  KnotSpans(std::vector<double> knots, int degree, int count, bool periodic);

  double min() const { return starts_.front(); }
  double max() const { return max_; }
  double period() const { return period_; }
  std::size_t size() const { return starts_.size(); }
  double start(std::size_t span) const { return starts_[span]; }
  double width(std::size_t span) const {
    return (span + 1 < size() ? starts_[span + 1] : max_) - starts_[span];
  }
  /// The first of the degree + 1 control points that matter to a span.
  int first_control(std::size_t span) const { return last_knot_[span] - degree_; }
  /// Rows of degree + 1 weights: Bezier point j of the span = sum over i of [j * (degree + 1) + i]
  /// times control point first_control + i. All weights lie in [0, 1]. @cite Ramshaw1989
  std::vector<double> extraction(std::size_t span) const;
  /// Inner knots where fewer than `order` derivatives are continuous.
  std::vector<double> breaks(int order) const;

  struct Place {
    std::size_t span;
    double offset;  // from the span's start
  };
  Place find(double x) const {
    x = fold_parameter(x, starts_.front(), max_, period_);
    const std::size_t c = cell(x);
    std::size_t low = cell_low_[c], high = cell_high_[c];
    while (low < high) {
      const std::size_t middle = (low + high + 1) / 2;
      if (starts_[middle] <= x) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return {low, x - starts_[low]};
  }

 private:
  // Monotonic in x, so that cells bound spans whatever the rounding.
  std::size_t cell(double x) const {
    return static_cast<std::size_t>((x - starts_.front()) * cells_per_unit_);
  }

  int degree_;
  double period_ = 0, max_ = 0, cells_per_unit_ = 0;
  std::vector<double> knots_;
  std::vector<double> starts_;
  std::vector<int> last_knot_;  // for each span the index of the knot at its start
  std::vector<std::uint32_t> cell_low_, cell_high_;
};

}  // namespace burin
