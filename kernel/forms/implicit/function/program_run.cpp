// The inner loops: each operation over a block of points, component by component, so that the
// compiler makes them vector code.

#include "program.h"
#include "program_one.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

using Mask = Program::Mask;
using Step = Program::Step;

bool has(Mask m, int c) { return (m >> c) & 1; }

// Components that derivatives up to `Order` have, and points a block: as many as keep a dozen
// registers in the first cache.
template <int Order>
constexpr int kComponents = Order == 0   ? 1
                            : Order == 1 ? 4
                                         : 10;
template <int Order>
constexpr int kLanes = Order == 0   ? 128
                       : Order == 1 ? 64
                                    : 32;

// N points at a time.
template <int Order, int N>
class Block {
 public:
  static constexpr int kCount = kComponents<Order>;

  explicit Block(std::uint32_t registers) {
    thread_local std::vector<double> memory;
    const std::size_t size = static_cast<std::size_t>(registers) * kCount * N;
    if (memory.size() < size) memory.resize(size);
    data_ = memory.data();
  }

  double* at(std::uint32_t reg, int component) {
    return data_ +
           (static_cast<std::size_t>(reg) * kCount + static_cast<std::size_t>(component)) * N;
  }

  void run(const Step& s, const double (&xyz)[3][N]) {
    double* v = at(s.to, 0);
    switch (s.op) {
      case Op::Constant:
        for (int i = 0; i < N; ++i) v[i] = s.value;
        return;
      case Op::X:
      case Op::Y:
      case Op::Z: {
        const int axis = static_cast<int>(s.op) - static_cast<int>(Op::X);
        for (int i = 0; i < N; ++i) v[i] = xyz[axis][i];
        if constexpr (Order > 0) {
          double* g = at(s.to, 1 + axis);
          for (int i = 0; i < N; ++i) g[i] = 1;
        }
        return;
      }
      case Op::Add:
        return add(s, 1);
      case Op::Subtract:
        return add(s, -1);
      case Op::Multiply:
        return multiply(s);
      case Op::Min:
      case Op::Max:
        return choose(s);
      case Op::Atan2:
        return angle(s);
      default:
        return unary(s);
    }
  }

 private:
  void add(const Step& s, double sign) {
    for (int c = 0; c < kCount; ++c) {
      if (!has(s.mask, c)) continue;
      double* r = at(s.to, c);
      const double *a = at(s.a, c), *b = at(s.b, c);
      if (has(s.mask_a, c) && has(s.mask_b, c)) {
        if (sign > 0) {
          for (int i = 0; i < N; ++i) r[i] = a[i] + b[i];
        } else {
          for (int i = 0; i < N; ++i) r[i] = a[i] - b[i];
        }
      } else if (has(s.mask_a, c)) {
        for (int i = 0; i < N; ++i) r[i] = a[i];
      } else {
        for (int i = 0; i < N; ++i) r[i] = sign * b[i];
      }
    }
  }

  void multiply(const Step& s) {
    double* r0 = at(s.to, 0);
    const double *a0 = at(s.a, 0), *b0 = at(s.b, 0);
    for (int c = 1; c < kCount; ++c) {
      if (!has(s.mask, c)) continue;
      double* r = at(s.to, c);
      const double *a = at(s.a, c), *b = at(s.b, c);
      if (has(s.mask_a, c) && has(s.mask_b, c)) {
        for (int i = 0; i < N; ++i) r[i] = a[i] * b0[i] + b[i] * a0[i];
      } else if (has(s.mask_a, c)) {
        for (int i = 0; i < N; ++i) r[i] = a[i] * b0[i];
      } else if (has(s.mask_b, c)) {
        for (int i = 0; i < N; ++i) r[i] = b[i] * a0[i];
      } else {
        for (int i = 0; i < N; ++i) r[i] = 0;
      }
      if constexpr (Order > 1) {
        if (c < 4) continue;
        add_product(s, r, 1 + kFirstAxis[c - 4], 1 + kSecondAxis[c - 4]);
        add_product(s, r, 1 + kSecondAxis[c - 4], 1 + kFirstAxis[c - 4]);
      }
    }
    for (int i = 0; i < N; ++i) r0[i] = a0[i] * b0[i];
  }
  void add_product(const Step& s, double* r, int ca, int cb) {
    if (!has(s.mask_a, ca) || !has(s.mask_b, cb)) return;
    const double *a = at(s.a, ca), *b = at(s.b, cb);
    for (int i = 0; i < N; ++i) r[i] += a[i] * b[i];
  }

  void choose(const Step& s) {
    const double *a0 = at(s.a, 0), *b0 = at(s.b, 0);
    alignas(64) bool first[N];
    // As `apply`: a NaN on either side wins.
    if (s.op == Op::Min) {
      for (int i = 0; i < N; ++i) first[i] = a0[i] <= b0[i] || std::isnan(a0[i]);
    } else {
      for (int i = 0; i < N; ++i) first[i] = a0[i] >= b0[i] || std::isnan(a0[i]);
    }
    for (int c = 0; c < kCount; ++c) {
      if (!has(s.mask, c)) continue;
      double* r = at(s.to, c);
      const double* a = has(s.mask_a, c) ? at(s.a, c) : zero_;
      const double* b = has(s.mask_b, c) ? at(s.b, c) : zero_;
      for (int i = 0; i < N; ++i) r[i] = first[i] ? a[i] : b[i];
    }
  }

  // r = f(a) from f' in f1_ and f'' in f2_.
  void chain(const Step& s) {
    for (int c = 1; c < kCount; ++c) {
      if (!has(s.mask, c)) continue;
      double* r = at(s.to, c);
      if (has(s.mask_a, c)) {
        const double* a = at(s.a, c);
        for (int i = 0; i < N; ++i) r[i] = f1_[i] * a[i];
      } else {
        for (int i = 0; i < N; ++i) r[i] = 0;
      }
      if constexpr (Order > 1) {
        if (c < 4) continue;
        const int ci = 1 + kFirstAxis[c - 4], cj = 1 + kSecondAxis[c - 4];
        if (!has(s.mask_a, ci) || !has(s.mask_a, cj)) continue;
        const double *x = at(s.a, ci), *y = at(s.a, cj);
        for (int i = 0; i < N; ++i) r[i] += f2_[i] * x[i] * y[i];
      }
    }
  }

  template <class F>
  void each(const Step& s, const F& f) {
    const double* a = at(s.a, 0);
    double* r = at(s.to, 0);
    for (int i = 0; i < N; ++i) f(a[i], r[i], f1_[i], f2_[i]);
    if constexpr (Order > 0) chain(s);
  }

  void scale(const Step& s, const double* factor) {
    for (int c = 0; c < kCount; ++c) {
      if (!has(s.mask, c)) continue;
      const double* a = at(s.a, c);
      double* r = at(s.to, c);
      for (int i = 0; i < N; ++i) r[i] = factor[i] * a[i];
    }
  }

  void unary(const Step& s) {
    switch (s.op) {
      case Op::Negate:
        for (int i = 0; i < N; ++i) f1_[i] = -1;
        return scale(s, f1_);
      case Op::Abs: {
        const double* a = at(s.a, 0);
        for (int i = 0; i < N; ++i) f1_[i] = a[i] < 0 ? -1 : 1;
        return scale(s, f1_);
      }
      case Op::Square:
        return each(s, [](double a, double& v, double& d, double& dd) {
          v = a * a;
          d = 2 * a;
          dd = 2;
        });
      case Op::Sqrt:
        // At zero the derivative counts as zero: lengths of vectors have their minimum there.
        return each(s, [](double a, double& v, double& d, double& dd) {
          v = std::sqrt(a);
          d = v > 0 ? 0.5 / v : 0;
          dd = v > 0 ? -0.5 * d / a : 0;
        });
      case Op::Reciprocal:
        return each(s, [](double a, double& v, double& d, double& dd) {
          v = 1 / a;
          d = -v * v;
          dd = -2 * v * d;
        });
      case Op::Exp:
        return each(s,
                    [](double a, double& v, double& d, double& dd) { v = d = dd = std::exp(a); });
      case Op::Log:
        return each(s, [](double a, double& v, double& d, double& dd) {
          v = std::log(a);
          d = 1 / a;
          dd = -d * d;
        });
      case Op::Sin:
        return each(s, [](double a, double& v, double& d, double& dd) {
          v = std::sin(a);
          d = Order > 0 ? std::cos(a) : 0;
          dd = -v;
        });
      case Op::Cos:
        return each(s, [](double a, double& v, double& d, double& dd) {
          v = std::cos(a);
          d = Order > 0 ? -std::sin(a) : 0;
          dd = -v;
        });
      case Op::Tan:
        return each(s, [](double a, double& v, double& d, double& dd) {
          v = std::tan(a);
          d = 1 + v * v;
          dd = 2 * v * d;
        });
      case Op::Asin:
        return each(s, [](double a, double& v, double& d, double& dd) {
          v = std::asin(a);
          d = 1 / std::sqrt((1 - a) * (1 + a));
          dd = a * d * d * d;
        });
      case Op::Acos:
        return each(s, [](double a, double& v, double& d, double& dd) {
          v = std::acos(a);
          d = -1 / std::sqrt((1 - a) * (1 + a));
          dd = a * d * d * d;
        });
      case Op::Atan:
        return each(s, [](double a, double& v, double& d, double& dd) {
          v = std::atan(a);
          d = 1 / (1 + a * a);
          dd = -2 * a * d * d;
        });
      case Op::Round:
        return each(s, [](double a, double& v, double& d, double& dd) {
          v = std::floor(a + 0.5);
          d = dd = 0;
        });
      default:  // Power
        return each(s, [&s](double a, double& v, double& d, double& dd) {
          v = std::pow(a, s.value);
          d = Order > 0 ? s.value * std::pow(a, s.value - 1) : 0;
          dd = Order > 1 ? s.value * (s.value - 1) * std::pow(a, s.value - 2) : 0;
        });
    }
  }

  void angle(const Step& s) {
    const double *y = at(s.a, 0), *x = at(s.b, 0);
    double* r0 = at(s.to, 0);
    for (int i = 0; i < N; ++i) r0[i] = std::atan2(y[i], x[i]);
    if constexpr (Order > 0) {
      const auto part = [&](Mask m, std::uint32_t reg, int c) {
        return has(m, c) ? at(reg, c) : zero_;
      };
      for (int c = 1; c < kCount; ++c) {
        if (!has(s.mask, c)) continue;
        double* r = at(s.to, c);
        const double *yc = part(s.mask_a, s.a, c), *xc = part(s.mask_b, s.b, c);
        for (int i = 0; i < N; ++i) {
          r[i] = (x[i] * yc[i] - y[i] * xc[i]) / (x[i] * x[i] + y[i] * y[i]);
        }
        if (Order < 2 || c < 4) continue;
        const int ci = 1 + kFirstAxis[c - 4], cj = 1 + kSecondAxis[c - 4];
        const double *yi = part(s.mask_a, s.a, ci), *xi = part(s.mask_b, s.b, ci);
        const double *yj = part(s.mask_a, s.a, cj), *xj = part(s.mask_b, s.b, cj);
        for (int i = 0; i < N; ++i) {
          const double q = 1 / (x[i] * x[i] + y[i] * y[i]);
          const double mixed = (y[i] * y[i] - x[i] * x[i]) * q * q;  // of x and y
          const double twice = 2 * x[i] * y[i] * q * q;              // xx; yy is its negative
          r[i] += twice * (xi[i] * xj[i] - yi[i] * yj[i]) + mixed * (xi[i] * yj[i] + yi[i] * xj[i]);
        }
      }
    }
  }

  double* data_ = nullptr;
  alignas(64) double f1_[N] = {}, f2_[N] = {};
  alignas(64) double zero_[N] = {};
};

// Runs all points block by block; `emit(first, count, component)` takes the results.
template <int Order, int N, class Emit>
void run_blocks(const std::vector<Step>& steps, std::uint32_t registers,
                std::span<const Vec3> points, const Emit& emit) {
  Block<Order, N> block(registers);
  alignas(64) double xyz[3][N] = {};
  for (std::size_t first = 0; first < points.size(); first += N) {
    const std::size_t count = std::min<std::size_t>(N, points.size() - first);
    for (std::size_t i = 0; i < N; ++i) {
      // The block is filled up by its last point.
      const Vec3& p = points[first + std::min(i, count - 1)];
      xyz[0][i] = p.x;
      xyz[1][i] = p.y;
      xyz[2][i] = p.z;
    }
    for (const Step& s : steps) block.run(s, xyz);
    emit(block, first, count);
  }
}

// Few points are not worth a whole block; for one see run_one.
template <int Order, class Emit>
void run(const std::vector<Step>& steps, std::uint32_t registers, std::span<const Vec3> points,
         const Emit& emit) {
  if (points.size() <= 8) {
    run_blocks<Order, 4>(steps, registers, points, emit);
  } else {
    run_blocks<Order, kLanes<Order>>(steps, registers, points, emit);
  }
}

}  // namespace

void Program::values(std::span<const Vec3> points, std::span<double> out) const {
  if (points.size() == 1) {
    double v[1];
    run_one(steps_, registers_, result_, result_mask_, points[0], v);
    out[0] = v[0];
    return;
  }
  run<0>(steps_, registers_, points, [&](auto& block, std::size_t first, std::size_t count) {
    std::copy_n(block.at(result_, 0), count, out.begin() + static_cast<std::ptrdiff_t>(first));
  });
}

void Program::gradients(std::span<const Vec3> points, std::span<Gradient1> out) const {
  if (points.size() == 1) {
    double v[4];
    run_one(steps_, registers_, result_, result_mask_, points[0], v);
    out[0] = {v[0], {v[1], v[2], v[3]}};
    return;
  }
  run<1>(steps_, registers_, points, [&](auto& block, std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto get = [&](int c) { return has(result_mask_, c) ? block.at(result_, c)[i] : 0; };
      out[first + i] = {get(0), {get(1), get(2), get(3)}};
    }
  });
}

void Program::hessians(std::span<const Vec3> points, std::span<Gradient2> out) const {
  if (points.size() == 1) {
    double v[10];
    run_one(steps_, registers_, result_, result_mask_, points[0], v);
    out[0] = {v[0], {v[1], v[2], v[3]}, v[4], v[5], v[6], v[7], v[8], v[9]};
    return;
  }
  run<2>(steps_, registers_, points, [&](auto& block, std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto get = [&](int c) { return has(result_mask_, c) ? block.at(result_, c)[i] : 0; };
      out[first + i] = {get(0), {get(1), get(2), get(3)}, get(4), get(5), get(6), get(7), get(8),
                        get(9)};
    }
  });
}

}  // namespace burin
