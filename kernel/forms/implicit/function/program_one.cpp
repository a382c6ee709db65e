#include "program_one.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

using Mask = Program::Mask;
using Step = Program::Step;

constexpr Mask kValueOnly = 1;
constexpr Mask kSecond = 0x3f0;  // components 4 .. 9

bool curved(Mask m) { return (m & kSecond) != 0; }
// Components of an operand that are there: what its mask has none of is not written.
int present(Mask m) { return curved(m) ? 10 : m == kValueOnly ? 1 : 4; }

// r = f(a) from f, f' = d and f'' = dd.
template <int Count>
void chain(const Step& s, double* __restrict r, const double* __restrict a, double v, double d,
           double dd) {
  if constexpr (Count > 4) {
    if (curved(s.mask_a)) {
#pragma GCC unroll 10
      for (int c = 0; c < Count; ++c) r[c] = d * a[c];
    } else {
#pragma GCC unroll 10
      for (int c = 0; c < Count; ++c) r[c] = c < 4 ? d * a[c] : 0;
    }
    const double x = dd * a[1], y = dd * a[2], z = dd * a[3];
    r[4] += x * a[1];
    r[5] += y * a[2];
    r[6] += z * a[3];
    r[7] += x * a[2];
    r[8] += x * a[3];
    r[9] += y * a[3];
  } else {
#pragma GCC unroll 4
    for (int c = 0; c < Count; ++c) r[c] = d * a[c];
  }
  r[0] = v;
}

template <int Count>
void scaled(double* __restrict r, const double* __restrict a, double factor) {
#pragma GCC unroll 10
  for (int c = 0; c < Count; ++c) r[c] = factor * a[c];
}

// r = a + sign * b.
template <int Count>
void sum(const Step& s, double* __restrict r, const double* __restrict a,
         const double* __restrict b, double sign) {
  const int na = std::min(Count, present(s.mask_a)), nb = std::min(Count, present(s.mask_b));
  if (na == Count && nb == Count) {
#pragma GCC unroll 10
    for (int c = 0; c < Count; ++c) r[c] = a[c] + sign * b[c];
  } else if (na == Count) {
#pragma GCC unroll 10
    for (int c = 0; c < Count; ++c) r[c] = a[c];
    for (int c = 0; c < nb; ++c) r[c] += sign * b[c];
  } else {
#pragma GCC unroll 10
    for (int c = 0; c < Count; ++c) r[c] = sign * b[c];
    for (int c = 0; c < na; ++c) r[c] += a[c];
  }
}

// An operand with all its components.
template <int Count>
const double* full(const double* a, Mask m, double (&room)[Count]) {
  const int n = present(m);
  if (n >= Count) return a;
  for (int c = 0; c < Count; ++c) room[c] = c < n ? a[c] : 0;
  return room;
}

template <int Count>
void multiply(const Step& s, double* __restrict r, const double* left, const double* right) {
  if (s.mask_b == kValueOnly) return scaled<Count>(r, left, right[0]);
  if (s.mask_a == kValueOnly) return scaled<Count>(r, right, left[0]);
  double room_a[Count], room_b[Count];
  const double* __restrict a = full(left, s.mask_a, room_a);
  const double* __restrict b = full(right, s.mask_b, room_b);
  const double a0 = a[0], b0 = b[0];
#pragma GCC unroll 10
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
void angle(const Step& s, double* __restrict r, const double* a, const double* b) {
  double room_y[Count], room_x[Count];
  const double* __restrict y = full(a, s.mask_a, room_y);
  const double* __restrict x = full(b, s.mask_b, room_x);
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
  constexpr bool kWithGradient = Count > 1, kWithHessian = Count > 4;
  const double x = a[0];
  switch (s.op) {
    case Op::Negate:
      return scaled<Count>(r, a, -1);
    case Op::Abs:
      return scaled<Count>(r, a, x < 0 ? -1 : 1);
    case Op::Square:
      return chain<Count>(s, r, a, x * x, 2 * x, 2);
    case Op::Sqrt: {
      // At zero the derivative counts as zero: lengths of vectors have their minimum there.
      const double v = std::sqrt(x), d = kWithGradient && v > 0 ? 0.5 / v : 0;
      return chain<Count>(s, r, a, v, d, kWithHessian && v > 0 ? -0.5 * d / x : 0);
    }
    case Op::Reciprocal: {
      const double v = 1 / x, d = -v * v;
      return chain<Count>(s, r, a, v, d, -2 * v * d);
    }
    case Op::Exp: {
      const double v = std::exp(x);
      return chain<Count>(s, r, a, v, v, v);
    }
    case Op::Log: {
      const double d = 1 / x;
      return chain<Count>(s, r, a, std::log(x), d, -d * d);
    }
    case Op::Sin: {
      const double v = std::sin(x);
      return chain<Count>(s, r, a, v, kWithGradient ? std::cos(x) : 0, -v);
    }
    case Op::Cos: {
      const double v = std::cos(x);
      return chain<Count>(s, r, a, v, kWithGradient ? -std::sin(x) : 0, -v);
    }
    case Op::Tan: {
      const double v = std::tan(x), d = 1 + v * v;
      return chain<Count>(s, r, a, v, d, 2 * v * d);
    }
    case Op::Asin: {
      const double d = 1 / std::sqrt((1 - x) * (1 + x));
      return chain<Count>(s, r, a, std::asin(x), d, x * d * d * d);
    }
    case Op::Acos: {
      const double d = -1 / std::sqrt((1 - x) * (1 + x));
      return chain<Count>(s, r, a, std::acos(x), d, x * d * d * d);
    }
    case Op::Atan: {
      const double d = 1 / (1 + x * x);
      return chain<Count>(s, r, a, std::atan(x), d, -2 * x * d * d);
    }
    case Op::Round:
      return chain<Count>(s, r, a, std::floor(x + 0.5), 0, 0);
    default: {  // Power
      const double e = s.value;
      return chain<Count>(s, r, a, std::pow(x, e), kWithGradient ? e * std::pow(x, e - 1) : 0,
                          kWithHessian ? e * (e - 1) * std::pow(x, e - 2) : 0);
    }
  }
}

template <int Count>
[[gnu::always_inline]] inline void step(const Step& s, double* __restrict r,
                                        const double* __restrict a, const double* __restrict b,
                                        Vec3 p) {
  switch (s.op) {
    case Op::Constant:
      r[0] = s.value;
      return;
    case Op::X:
    case Op::Y:
    case Op::Z: {
      const int axis = static_cast<int>(s.op) - static_cast<int>(Op::X);
      for (int c = 1; c < Count; ++c) r[c] = c == 1 + axis ? 1 : 0;
      r[0] = p[axis];
      return;
    }
    case Op::Add:
      return sum<Count>(s, r, a, b, 1);
    case Op::Subtract:
      return sum<Count>(s, r, a, b, -1);
    case Op::Multiply:
      return multiply<Count>(s, r, a, b);
    case Op::Min:
    case Op::Max: {
      // As `apply`: a NaN on either side wins.
      const bool first = (s.op == Op::Min ? a[0] <= b[0] : a[0] >= b[0]) || std::isnan(a[0]);
      const double* from = first ? a : b;
      const int n = std::min(Count, present(first ? s.mask_a : s.mask_b));
      for (int c = 0; c < n; ++c) r[c] = from[c];
      for (int c = n; c < Count; ++c) r[c] = 0;
      return;
    }
    case Op::Atan2:
      return angle<Count>(s, r, a, b);
    default:
      return unary<Count>(s, r, a);
  }
}

}  // namespace

template <int Count>
void run_one(const std::vector<Step>& steps, std::uint32_t registers, std::uint32_t result,
             Program::Mask mask, Vec3 p, double (&out)[Count]) {
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
  for (const Step& s : steps) {
    double* r = at(s.to);
    const double *a = at(s.a), *b = at(s.b);
    if (Count > 4 && curved(s.mask)) {
      step<Count>(s, r, a, b, p);
    } else if (Count > 1 && s.mask != kValueOnly) {
      step<std::min(Count, 4)>(s, r, a, b, p);
    } else {
      step<1>(s, r, a, b, p);
    }
  }
  const int n = std::min(Count, present(mask));
  for (int c = 0; c < Count; ++c) out[c] = c < n ? at(result)[c] : 0;
}

template void run_one<1>(const std::vector<Step>&, std::uint32_t, std::uint32_t, Mask, Vec3,
                         double (&)[1]);
template void run_one<4>(const std::vector<Step>&, std::uint32_t, std::uint32_t, Mask, Vec3,
                         double (&)[4]);
template void run_one<10>(const std::vector<Step>&, std::uint32_t, std::uint32_t, Mask, Vec3,
                          double (&)[10]);

}  // namespace burin
