#pragma once
// Coefficients on a grid and the spline they span, in coordinates of the grid.

#include <burin/base/run_context.h>
#include <burin/forms/implicit/implicit_function.h>

#include "box_function.h"
#include "volume_lines.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Uniform B-spline of degree 2 or 3 over [0, size - 1] along each axis. Beyond the ends its
/// coefficients go on odd (c[-1] = 2 c[0] - c[1]).
class VolumeSpline final : public BoxField {
 public:
  VolumeSpline(SampleBlock coefficients, int degree, const RunContext& context);

  void values(std::span<const Vec3> at, std::span<double> out) const override;
  void gradients(std::span<const Vec3> at, std::span<Gradient1> out) const override;
  void hessians(std::span<const Vec3> at, std::span<Gradient2> out) const override;
  /// Of the coefficients that take part in the box, or in blocks of 4 of them around it.
  Interval range(Vec3 min, Vec3 max) const override;
  Interval border_range() const override;
  std::array<Interval, 3> slopes(Vec3 min, Vec3 max) const override;
  Box3 support(double level, bool above) const override;
  Vec3 last() const override { return last_; }

 private:
  static constexpr int kBlock = 4;  // coefficients along a side of the blocks of `levels_`
  struct Level {
    std::array<std::int32_t, 3> size{};
    std::vector<std::array<float, 2>> range;
  };

  // The coefficients that take part in a box, in the numbers of the array with its rim.
  void taking_part(Vec3 min, Vec3 max, std::array<std::int32_t, 3>& low,
                   std::array<std::int32_t, 3>& high) const;
  template <int kTaps, int kOrder, class Out>
  void evaluate(std::span<const Vec3> at, std::span<Out> out) const;
  template <class Out, int kOrder>
  void evaluate_any(std::span<const Vec3> at, std::span<Out> out) const;
  void make_levels(const RunContext& context);

  int degree_;
  Vec3 last_{0};
  std::array<std::int32_t, 3> size_{};  // with one more coefficient on each side
  std::ptrdiff_t row_ = 0, slice_ = 0;
  std::vector<float> coefficients_;
  std::vector<Level> levels_;
};

}  // namespace burin
