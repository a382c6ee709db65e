#include "volume_lines.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace burin {
namespace {

// Lines that are filtered side by side: a cache line of floats.
constexpr std::size_t kLinesAtOnce = 16;
using Row = std::array<double, kLinesAtOnce>;

// Calls `filter` with bundles of lines along an axis, as rows of one sample of each line.
void along(SampleBlock samples, std::size_t axis,
           const std::function<void(std::vector<Row>&)>& filter, const RunContext& context) {
  const std::array<std::size_t, 3> n{static_cast<std::size_t>(samples.size[0]),
                                     static_cast<std::size_t>(samples.size[1]),
                                     static_cast<std::size_t>(samples.size[2])};
  const std::array<std::size_t, 3> stride{1, n[0], n[0] * n[1]};
  // Lanes along x where they can be, else along y.
  const std::size_t side = axis == 0 ? 1 : 0, rest = 3 - axis - side;
  const std::size_t bundles = (n[side] + kLinesAtOnce - 1) / kLinesAtOnce;
  parallel_for(
      bundles * n[rest], 8,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Row> rows(n[axis]);
        for (std::size_t b = begin; b < end; ++b) {
          const std::size_t first = b % bundles * kLinesAtOnce;
          const std::size_t lanes = std::min(kLinesAtOnce, n[side] - first);
          float* at = samples.values.data() + b / bundles * stride[rest] + first * stride[side];
          for (std::size_t i = 0; i < n[axis]; ++i) {
            for (std::size_t l = 0; l < lanes; ++l) {
              rows[i][l] = at[i * stride[axis] + l * stride[side]];
            }
          }
          filter(rows);
          for (std::size_t i = 0; i < n[axis]; ++i) {
            for (std::size_t l = 0; l < lanes; ++l) {
              at[i * stride[axis] + l * stride[side]] = static_cast<float>(rows[i][l]);
            }
          }
        }
      },
      &context);
}

std::size_t mirrored(std::ptrdiff_t i, std::size_t n) {
  if (n == 1) return 0;
  const auto period = static_cast<std::ptrdiff_t>(2 * (n - 1));
  i = std::abs(i) % period;
  return static_cast<std::size_t>(std::min(i, period - i));
}

std::vector<double> gaussian(double sigma) {
  const auto reach = static_cast<std::size_t>(std::ceil(4 * sigma));
  std::vector<double> half(reach + 1);
  double sum = 0;
  for (std::size_t i = 0; i <= reach; ++i) {
    const double x = static_cast<double>(i) / sigma;
    half[i] = std::exp(-0.5 * x * x);
    sum += i == 0 ? half[i] : 2 * half[i];
  }
  for (double& w : half) w /= sum;
  return half;
}

}  // namespace

void smooth_samples(SampleBlock samples, double sigma, const RunContext& context) {
  if (!(sigma > 0)) return;
  const std::vector<double> half = gaussian(sigma);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    along(
        samples, axis,
        [&](std::vector<Row>& rows) {
          const std::vector<Row> old = rows;
          for (std::size_t i = 0; i < rows.size(); ++i) {
            for (std::size_t l = 0; l < kLinesAtOnce; ++l) rows[i][l] = half[0] * old[i][l];
            for (std::size_t k = 1; k < half.size(); ++k) {
              const auto p = static_cast<std::ptrdiff_t>(i), d = static_cast<std::ptrdiff_t>(k);
              const Row& a = old[mirrored(p - d, old.size())];
              const Row& b = old[mirrored(p + d, old.size())];
              for (std::size_t l = 0; l < kLinesAtOnce; ++l) rows[i][l] += half[k] * (a[l] + b[l]);
            }
          }
        },
        context);
  }
}

void interpolate_samples(SampleBlock samples, int degree, const RunContext& context) {
  // The spline's value at a sample is (c[-1] + middle c[0] + c[1]) / (middle + 2). Elimination in
  // this system is the recursive filter; its factors tend to the filter's pole within 20 samples.
  const double middle = degree == 2 ? 6 : 4;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto n = static_cast<std::size_t>(samples.size[axis]);
    if (n < 3) continue;
    std::vector<double> pole(n, 0);
    for (std::size_t i = 1; i + 1 < n; ++i) pole[i] = 1 / (middle - pole[i - 1]);
    along(
        samples, axis,
        [&](std::vector<Row>& rows) {
          // The ends keep their values: c[-1] = 2 c[0] - c[1].
          for (std::size_t i = 1; i + 1 < n; ++i) {
            for (std::size_t l = 0; l < kLinesAtOnce; ++l) {
              const double before = rows[i - 1][l];
              rows[i][l] = ((middle + 2) * rows[i][l] - before) * pole[i];
            }
          }
          for (std::size_t i = n - 2; i > 0; --i) {
            for (std::size_t l = 0; l < kLinesAtOnce; ++l) rows[i][l] -= pole[i] * rows[i + 1][l];
          }
        },
        context);
  }
}

}  // namespace burin
