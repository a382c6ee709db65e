#pragma once
/// Volumes as functions: samples on a grid are the coefficients of a trivariate B-spline.

#include <burin/base/run_context.h>
#include <burin/base/vec.h>
#include <burin/forms/implicit/implicit_function.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace burin {

/// Samples on a regular grid.
struct VolumeGrid {
  /// Samples along i, j and k.
  std::array<std::int32_t, 3> size{};
  /// Model mm of sample (0, 0, 0).
  Vec3 origin{0};
  /// Columns: model mm from one sample to the next along i, j and k; any three independent vectors.
  Mat3 steps{1};
  /// size[0] * size[1] * size[2] of them, i fastest: (k * size[1] + j) * size[0] + i.
  std::vector<float> samples;
};

struct VolumeOptions {
  /// The surface is where the data takes this value.
  double level = 0;
  /// Whether larger values are inside.
  bool inside_above = true;
  /// 2 or 3: continuous gradient, or continuous Hessian.
  int degree = 3;
  /// Whether the spline takes the values of the samples (prefiltered), or has them as coefficients,
  /// which smooths a little, as Elber 1998 does.
  bool interpolate = false;
  /// Standard deviation in samples of a Gaussian that the samples are smoothed with first; 0 =
  /// none.
  double smoothing = 0;
};

/// f = level - spline (its negative where smaller values are inside), in units of the data. Where
/// the inside reaches the sides of the box of the samples, planes close it there (they are pieces
/// of the function); outside the box it is positive. Samples that are not finite count as outside.
/// Throws UsageError where the sizes do not fit, GeometryError where the level is outside the range
/// of the data (the error names the range). Cost: 2 floats per sample while it is made, 1
/// afterwards; 25 ns per sample to interpolate. @cite Unser1999 @cite Elber1998
std::shared_ptr<const ImplicitFunction> make_volume_function(VolumeGrid grid,
                                                             const VolumeOptions& options,
                                                             const RunContext& context);

/// A scalar B-spline over a box of parameters that are model mm.
struct TrivariateSpline {
  /// Degrees plus one; knots and numbers of coefficients along x, y and z.
  std::array<std::int32_t, 3> order{};
  std::array<std::vector<double>, 3> knots;
  std::array<std::int32_t, 3> size{};
  /// x fastest.
  std::vector<double> coefficients;
};

/// f = spline - level, negative inside, closed at the sides of the knots' box as volumes are.
/// Degrees 1 to 9; below 3 curvature jumps where knots are. Throws UsageError where sizes and knots
/// do not fit, GeometryError where the level is outside the range of the coefficients.
/// @cite Elber1998
std::shared_ptr<const ImplicitFunction> make_trivariate_function(TrivariateSpline spline,
                                                                 double level);

}  // namespace burin
