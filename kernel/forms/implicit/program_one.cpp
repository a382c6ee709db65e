#include "program_one.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

using Mask = Program::Mask;
using Step = Program::Step;

constexpr Mask kValueOnly = 1;

// r = f(a) with f' = d and f'' = dd.
template <int Count>
void chain(double* __restrict r, const double* __restrict a, double v, double d, double dd) {
  for (int c = 0; c < Count; ++c) r[c] = d * a[c];
  if constexpr (Count > 4) {
    const double x = dd * a[1], y = dd * a[2], z = dd * a[3];
    r[4] += x * a[1];
    r[5] += y * a[2];
    r[6] += z * a[3];
    r[7] += x * a[2];
    r[8] += x * a[3];
    r[9] += y * a[3];
  }
  r[0] = v;
}

template <int Count>
void scaled(double* __restrict r, const double* __restrict a, double factor) {
  for (int c = 0; c < Count; ++c) r[c] = factor * a[c];
}

template <int Count>
void multiply(const Step& s, double* __restrict r, const double* __restrict a,
              const double* __restrict b) {
  if (s.mask_b == kValueOnly) return scaled<Count>(r, a, b[0]);
  if (s.mask_a == kValueOnly) return scaled<Count>(r, b, a[0]);
  const double a0 = a[0], b0 = b[0];
  for (int c = 0; c < Count; ++c) r[c] = a[c] * b0 + b[c] * a0;
  if constexpr (Count > 4) {
    // Summed in the order of the blocks, so that both agree to the bit.
    r[4] = r[4] + a[1] * b[1] + a[1] * b[1];
    r[5] = r[5] + a[2] * b[2] + a[2] * b[2];
    r[6] = r[6] + a[3] * b[3] + a[3] * b[3];
    r[7] = r[7] + a[1] * b[2] + a[2] * b[1];
    r[8] = r[8] + a[1] * b[3] + a[3] * b[1];
    r[9] = r[9] + a[2] * b[3] + a[3] * b[2];
  }
  r[0] = a0 * b0;
}

template <int Count>
void angle(double* __restrict r, const double* __restrict y, const double* __restrict x) {
  const double y0 = y[0], x0 = x[0], square = x0 * x0 + y0 * y0, q = 1 / square;
  for (int c = 0; c < Count; ++c) r[c] = (x0 * y[c] - y0 * x[c]) / square;
  if constexpr (Count > 4) {
    constexpr int kI[6] = {1, 2, 3, 1, 1, 2}, kJ[6] = {1, 2, 3, 2, 3, 3};
    const double mixed = (y0 * y0 - x0 * x0) * q * q, twice = 2 * x0 * y0 * q * q;
    for (int h = 0; h < 6; ++h) {
      const int i = kI[h], j = kJ[h];
      r[4 + h] += twice * (x[i] * x[j] - y[i] * y[j]) + mixed * (x[i] * y[j] + y[i] * x[j]);
    }
  }
  r[0] = std::atan2(y0, x0);
}

template <int Count>
void unary(const Step& s, double* __restrict r, const double* __restrict a) {
  constexpr bool first = Count > 1, second = Count > 4;
  const double x = a[0];
  switch (s.op) {
    case Op::Negate:
      return scaled<Count>(r, a, -1);
    case Op::Abs:
      return scaled<Count>(r, a, x < 0 ? -1 : 1);
    case Op::Square:
      return chain<Count>(r, a, x * x, 2 * x, 2);
    case Op::Sqrt: {
      // At zero the derivative counts as zero: lengths of vectors have their minimum there.
      const double v = std::sqrt(x), d = first && v > 0 ? 0.5 / v : 0;
      return chain<Count>(r, a, v, d, second && v > 0 ? -0.5 * d / x : 0);
    }
    case Op::Reciprocal: {
      const double v = 1 / x, d = -v * v;
      return chain<Count>(r, a, v, d, -2 * v * d);
    }
    case Op::Exp: {
      const double v = std::exp(x);
      return chain<Count>(r, a, v, v, v);
    }
    case Op::Log: {
      const double d = 1 / x;
      return chain<Count>(r, a, std::log(x), d, -d * d);
    }
    case Op::Sin: {
      const double v = std::sin(x);
      return chain<Count>(r, a, v, first ? std::cos(x) : 0, -v);
    }
    case Op::Cos: {
      const double v = std::cos(x);
      return chain<Count>(r, a, v, first ? -std::sin(x) : 0, -v);
    }
    case Op::Tan: {
      const double v = std::tan(x), d = 1 + v * v;
      return chain<Count>(r, a, v, d, 2 * v * d);
    }
    case Op::Asin: {
      const double d = 1 / std::sqrt((1 - x) * (1 + x));
      return chain<Count>(r, a, std::asin(x), d, x * d * d * d);
    }
    case Op::Acos: {
      const double d = -1 / std::sqrt((1 - x) * (1 + x));
      return chain<Count>(r, a, std::acos(x), d, x * d * d * d);
    }
    case Op::Atan: {
      const double d = 1 / (1 + x * x);
      return chain<Count>(r, a, std::atan(x), d, -2 * x * d * d);
    }
    case Op::Round:
      return chain<Count>(r, a, std::floor(x + 0.5), 0, 0);
    default: {  // Power
      const double e = s.value;
      return chain<Count>(r, a, std::pow(x, e), first ? e * std::pow(x, e - 1) : 0,
                          second ? e * (e - 1) * std::pow(x, e - 2) : 0);
    }
  }
}

template <int Count>
void step(const Step& s, double* __restrict r, const double* __restrict a,
          const double* __restrict b, Vec3 p) {
  switch (s.op) {
    case Op::Constant:
    case Op::X:
    case Op::Y:
    case Op::Z: {
      for (int c = 0; c < Count; ++c) r[c] = 0;
      const int axis = static_cast<int>(s.op) - static_cast<int>(Op::X);
      r[0] = axis < 0 ? s.value : p[axis];
      if (Count > 1 && axis >= 0) r[1 + axis] = 1;
      return;
    }
    case Op::Add:
      for (int c = 0; c < Count; ++c) r[c] = a[c] + b[c];
      return;
    case Op::Subtract:
      for (int c = 0; c < Count; ++c) r[c] = a[c] - b[c];
      return;
    case Op::Multiply:
      return multiply<Count>(s, r, a, b);
    case Op::Min:
    case Op::Max: {
      // As `apply`: a NaN on either side wins.
      const bool first = (s.op == Op::Min ? a[0] <= b[0] : a[0] >= b[0]) || std::isnan(a[0]);
      const double* from = first ? a : b;
      for (int c = 0; c < Count; ++c) r[c] = from[c];
      return;
    }
    case Op::Atan2:
      return angle<Count>(r, a, b);
    default:
      return unary<Count>(s, r, a);
  }
}

}  // namespace

template <int Count>
void run_one(const std::vector<Step>& steps, std::uint32_t registers, std::uint32_t result, Vec3 p,
             double (&out)[Count]) {
  // Most programs fit on the stack.
  constexpr std::uint32_t kFew = 64;
  alignas(64) double few[kFew * Count];
  double* memory = few;
  if (registers > kFew) {
    thread_local std::vector<double> many;
    if (many.size() < std::size_t{registers} * Count) many.resize(std::size_t{registers} * Count);
    memory = many.data();
  }
  const auto at = [&](std::uint32_t reg) { return memory + std::size_t{reg} * Count; };
  for (const Step& s : steps) step<Count>(s, at(s.to), at(s.a), at(s.b), p);
  std::copy_n(at(result), Count, out);
}

template void run_one<1>(const std::vector<Step>&, std::uint32_t, std::uint32_t, Vec3,
                         double (&)[1]);
template void run_one<4>(const std::vector<Step>&, std::uint32_t, std::uint32_t, Vec3,
                         double (&)[4]);
template void run_one<10>(const std::vector<Step>&, std::uint32_t, std::uint32_t, Vec3,
                          double (&)[10]);

}  // namespace burin
