#include "volume_spline.h"

#include <cmath>

namespace burin {
namespace {

// Weights of a point between coefficients and their derivatives, and the first coefficient.
template <int kTaps, int kOrder>
struct Weights {
  double w[kOrder + 1][kTaps];
  std::ptrdiff_t first = 0;
};

template <int kOrder>
void set_weights(double x, double last, Weights<4, kOrder>& out) {
  const double i = std::min(std::floor(x), last - 1), t = x - i, s = 1 - t;
  out.first = static_cast<std::ptrdiff_t>(i);
  double* w = out.w[0];
  w[0] = s * s * s / 6;
  w[1] = 2.0 / 3 - t * t * (1 - 0.5 * t);
  w[2] = 2.0 / 3 - s * s * (1 - 0.5 * s);
  w[3] = t * t * t / 6;
  if constexpr (kOrder > 0) {
    double* d = out.w[1];
    d[0] = -0.5 * s * s;
    d[1] = t * (1.5 * t - 2);
    d[2] = s * (2 - 1.5 * s);
    d[3] = 0.5 * t * t;
  }
  if constexpr (kOrder > 1) {
    double* d = out.w[2];
    d[0] = s;
    d[1] = 3 * t - 2;
    d[2] = 3 * s - 2;
    d[3] = t;
  }
}

template <int kOrder>
void set_weights(double x, [[maybe_unused]] double last, Weights<3, kOrder>& out) {
  const double i = std::floor(x + 0.5), t = x - i;
  out.first = static_cast<std::ptrdiff_t>(i);
  double* w = out.w[0];
  w[0] = 0.5 * (0.5 - t) * (0.5 - t);
  w[1] = 0.75 - t * t;
  w[2] = 0.5 * (0.5 + t) * (0.5 + t);
  if constexpr (kOrder > 0) {
    double* d = out.w[1];
    d[0] = t - 0.5;
    d[1] = -2 * t;
    d[2] = t + 0.5;
  }
  if constexpr (kOrder > 1) {
    double* d = out.w[2];
    d[0] = 1;
    d[1] = -2;
    d[2] = 1;
  }
}

template <int kTaps>
double dot(const double* a, const double* b) {
  double s = 0;
  for (int i = 0; i < kTaps; ++i) s += a[i] * b[i];
  return s;
}

// Sums over y and z for each of the columns along x: index 0 value, then derivatives y, z, yy, yz,
// zz.
template <int kTaps, int kOrder>
struct Columns {
  static constexpr int kCount = kOrder == 0 ? 1 : kOrder == 1 ? 3 : 6;
  double sum[kCount][kTaps];

  void add(double weight, const double* row, int which) {
    for (int x = 0; x < kTaps; ++x) sum[which][x] += weight * row[x];
  }
};

template <int kTaps, int kOrder>
void sum_columns(const float* first, std::ptrdiff_t row, std::ptrdiff_t slice,
                 const Weights<kTaps, kOrder>& wy, const Weights<kTaps, kOrder>& wz,
                 Columns<kTaps, kOrder>& out) {
  for (auto& s : out.sum) std::fill(std::begin(s), std::end(s), 0.0);
  for (int z = 0; z < kTaps; ++z) {
    double along[kOrder + 1][kTaps] = {};
    for (int y = 0; y < kTaps; ++y) {
      const float* c = first + z * slice + y * row;
      for (int x = 0; x < kTaps; ++x) {
        const auto v = static_cast<double>(c[x]);
        for (int o = 0; o <= kOrder; ++o) along[o][x] += wy.w[o][y] * v;
      }
    }
    out.add(wz.w[0][z], along[0], 0);
    if constexpr (kOrder > 0) {
      out.add(wz.w[0][z], along[1], 1);
      out.add(wz.w[1][z], along[0], 2);
    }
    if constexpr (kOrder > 1) {
      out.add(wz.w[0][z], along[2], 3);
      out.add(wz.w[1][z], along[1], 4);
      out.add(wz.w[2][z], along[0], 5);
    }
  }
}

}  // namespace

VolumeSpline::VolumeSpline(SampleBlock coefficients, int degree, const RunContext& context)
    : degree_(degree) {
  for (std::size_t a = 0; a < 3; ++a) {
    size_[a] = coefficients.size[a] + 2;
    last_[static_cast<int>(a)] = coefficients.size[a] - 1;
  }
  row_ = size_[0];
  slice_ = row_ * size_[1];
  coefficients_.resize(static_cast<std::size_t>(slice_ * size_[2]));
  const std::ptrdiff_t nx = coefficients.size[0], ny = coefficients.size[1];
  for (std::ptrdiff_t z = 0; z < coefficients.size[2]; ++z) {
    for (std::ptrdiff_t y = 0; y < ny; ++y) {
      const float* from = coefficients.values.data() + (z * ny + y) * nx;
      std::copy(from, from + nx, coefficients_.data() + (z + 1) * slice_ + (y + 1) * row_ + 1);
    }
    context.check();
  }
  // Each axis takes in the rims made for those before.
  const std::array<std::ptrdiff_t, 3> stride{1, row_, slice_};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t u = (a + 1) % 3, v = (a + 2) % 3;
    const std::ptrdiff_t s = stride[a], end = (size_[a] - 1) * s;
    for (std::ptrdiff_t i = 0; i < size_[u]; ++i) {
      for (std::ptrdiff_t j = 0; j < size_[v]; ++j) {
        float* c = coefficients_.data() + i * stride[u] + j * stride[v];
        c[0] = 2 * c[s] - c[2 * s];
        c[end] = 2 * c[end - s] - c[end - 2 * s];
      }
    }
  }
  make_levels(context);
}

template <int kTaps, int kOrder, class Out>
void VolumeSpline::evaluate(std::span<const Vec3> at, std::span<Out> out) const {
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vec3 p = glm::min(glm::max(at[i], Vec3(0)), last_);
    if (!(p.x + p.y + p.z >= 0)) {
      out[i] = Out{std::numeric_limits<double>::quiet_NaN()};
      continue;
    }
    Weights<kTaps, kOrder> wx, wy, wz;
    set_weights(p.x, last_.x, wx);
    set_weights(p.y, last_.y, wy);
    set_weights(p.z, last_.z, wz);
    // The coefficient before the first of a cubic, and before the middle of a quadratic, is the
    // first to take part: one less, and the rim one more.
    const float* first = coefficients_.data() + wz.first * slice_ + wy.first * row_ + wx.first;
    Columns<kTaps, kOrder> c;
    sum_columns<kTaps, kOrder>(first, row_, slice_, wy, wz, c);
    if constexpr (kOrder == 0) {
      out[i] = dot<kTaps>(wx.w[0], c.sum[0]);
    } else {
      out[i].value = dot<kTaps>(wx.w[0], c.sum[0]);
      out[i].gradient = {dot<kTaps>(wx.w[1], c.sum[0]), dot<kTaps>(wx.w[0], c.sum[1]),
                         dot<kTaps>(wx.w[0], c.sum[2])};
    }
    if constexpr (kOrder > 1) {
      out[i].xx = dot<kTaps>(wx.w[2], c.sum[0]);
      out[i].xy = dot<kTaps>(wx.w[1], c.sum[1]);
      out[i].xz = dot<kTaps>(wx.w[1], c.sum[2]);
      out[i].yy = dot<kTaps>(wx.w[0], c.sum[3]);
      out[i].yz = dot<kTaps>(wx.w[0], c.sum[4]);
      out[i].zz = dot<kTaps>(wx.w[0], c.sum[5]);
    }
  }
}

template <class Out, int kOrder>
void VolumeSpline::evaluate_any(std::span<const Vec3> at, std::span<Out> out) const {
  if (degree_ == 2) {
    evaluate<3, kOrder>(at, out);
  } else {
    evaluate<4, kOrder>(at, out);
  }
}

void VolumeSpline::values(std::span<const Vec3> at, std::span<double> out) const {
  evaluate_any<double, 0>(at, out);
}
void VolumeSpline::gradients(std::span<const Vec3> at, std::span<Gradient1> out) const {
  evaluate_any<Gradient1, 1>(at, out);
}
void VolumeSpline::hessians(std::span<const Vec3> at, std::span<Gradient2> out) const {
  evaluate_any<Gradient2, 2>(at, out);
}

}  // namespace burin
