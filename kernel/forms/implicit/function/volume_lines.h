#pragma once
// Filters along the lines of a grid of samples.

#include <burin/base/run_context.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Samples of a grid, x fastest.
struct SampleBlock {
  std::array<std::int32_t, 3> size{};
  std::span<float> values;
};

/// Convolution with a Gaussian of standard deviation `sigma` samples, mirrored at the ends.
void smooth_samples(SampleBlock samples, double sigma, const RunContext& context);

/// Replaces samples by the coefficients of the spline of degree 2 or 3 that takes their values.
/// Its second derivative is zero at the ends (of degree 2: it goes on odd), so that linear data
/// stays linear. @cite Unser1999
void interpolate_samples(SampleBlock samples, int degree, const RunContext& context);

}  // namespace burin
