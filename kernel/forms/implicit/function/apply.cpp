// The operations on single numbers and on intervals.

#include "node.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace burin {
namespace {

// Ends that are NaN (0 * inf, inf - inf) tell nothing.
Interval made(double min, double max) {
  if (std::isnan(min) || std::isnan(max)) return {};
  return {min, max};
}

Interval hull_of_values(std::initializer_list<double> v) {
  for (const double x : v) {
    if (std::isnan(x)) return {};
  }
  return {std::min(v), std::max(v)};
}

double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }  // 0 * inf = 0 here

Interval product_of(Interval a, Interval b) {
  return hull_of_values(
      {product(a.min, b.min), product(a.min, b.max), product(a.max, b.min), product(a.max, b.max)});
}

Interval absolute(Interval a) {
  if (a.min >= 0) return a;
  if (a.max <= 0) return {-a.max, -a.min};
  return {0, std::max(-a.min, a.max)};
}

Interval power(Interval a, double exponent) {
  // Not defined for negative numbers unless the exponent is whole; these are rare and large.
  if (a.min < 0) return {};
  const double u = std::pow(a.min, exponent), v = std::pow(a.max, exponent);
  return made(std::min(u, v), std::max(u, v));
}

Interval cosine(Interval a) {
  if (!(a.max - a.min < 2 * std::numbers::pi) || !std::isfinite(a.min)) return {-1, 1};
  // Peaks at even, valleys at odd multiples of pi.
  const double first = std::ceil(a.min / std::numbers::pi),
               last = std::floor(a.max / std::numbers::pi);
  Interval r = hull_of_values({std::cos(a.min), std::cos(a.max)});
  for (double k = first; k <= last; ++k) {
    if (std::fmod(k, 2) == 0) r.max = 1;
    if (std::fmod(k, 2) != 0) r.min = -1;
  }
  return r;
}

Interval tangent(Interval a) {
  const double k = std::floor(a.min / std::numbers::pi + 0.5);
  const bool one_branch = std::isfinite(a.min) && a.max < (k + 0.5) * std::numbers::pi;
  return one_branch ? made(std::tan(a.min), std::tan(a.max)) : Interval{};
}

Interval angle_between(Interval y, Interval x) {
  // Continuous away from the half line x <= 0, y = 0, and extreme at corners there.
  if (x.min <= 0 && y.min <= 0 && y.max >= 0) return {-std::numbers::pi, std::numbers::pi};
  return hull_of_values({std::atan2(y.min, x.min), std::atan2(y.min, x.max),
                         std::atan2(y.max, x.min), std::atan2(y.max, x.max)});
}

double clamp1(double v) { return std::clamp(v, -1.0, 1.0); }

}  // namespace

double apply(Op op, double a, double b, double value) {
  switch (op) {
    case Op::Constant:
      return value;
    case Op::X:
    case Op::Y:
    case Op::Z:
      return a;
    case Op::Negate:
      return -a;
    case Op::Abs:
      return std::abs(a);
    case Op::Square:
      return a * a;
    case Op::Sqrt:
      return std::sqrt(a);
    case Op::Reciprocal:
      return 1 / a;
    case Op::Exp:
      return std::exp(a);
    case Op::Log:
      return std::log(a);
    case Op::Sin:
      return std::sin(a);
    case Op::Cos:
      return std::cos(a);
    case Op::Tan:
      return std::tan(a);
    case Op::Asin:
      return std::asin(a);
    case Op::Acos:
      return std::acos(a);
    case Op::Atan:
      return std::atan(a);
    case Op::Round:
      return std::floor(a + 0.5);
    case Op::Power:
      return std::pow(a, value);
    case Op::Add:
      return a + b;
    case Op::Subtract:
      return a - b;
    case Op::Multiply:
      return a * b;
    // A NaN on either side makes the result NaN: "not defined" is not lost.
    case Op::Min:
      return a <= b || std::isnan(a) ? a : b;
    case Op::Max:
      return a >= b || std::isnan(a) ? a : b;
    case Op::Atan2:
      return std::atan2(a, b);
  }
  return 0;
}

Interval apply(Op op, Interval a, Interval b, double value) {
  switch (op) {
    case Op::Constant:
      return {value, value};
    case Op::X:
    case Op::Y:
    case Op::Z:
      return a;
    case Op::Negate:
      return {-a.max, -a.min};
    case Op::Abs:
      return absolute(a);
    case Op::Square: {
      const Interval m = absolute(a);
      return {m.min * m.min, m.max * m.max};
    }
    // Where the argument is negative in places the function is not defined there: the rest counts.
    case Op::Sqrt:
      return {std::sqrt(std::max(a.min, 0.0)), std::sqrt(std::max(a.max, 0.0))};
    case Op::Reciprocal:
      return a.min > 0 || a.max < 0 ? made(1 / a.max, 1 / a.min) : Interval{};
    case Op::Exp:
      return {std::exp(a.min), std::exp(a.max)};
    case Op::Log:
      return a.max > 0 ? Interval{std::log(std::max(a.min, 0.0)), std::log(a.max)} : Interval{};
    case Op::Sin:
      return cosine({a.min - 0.5 * std::numbers::pi, a.max - 0.5 * std::numbers::pi});
    case Op::Cos:
      return cosine(a);
    case Op::Tan:
      return tangent(a);
    case Op::Asin:
      return {std::asin(clamp1(a.min)), std::asin(clamp1(a.max))};
    case Op::Acos:
      return {std::acos(clamp1(a.max)), std::acos(clamp1(a.min))};
    case Op::Atan:
      return {std::atan(a.min), std::atan(a.max)};
    case Op::Round:
      return {std::floor(a.min + 0.5), std::floor(a.max + 0.5)};
    case Op::Power:
      return power(a, value);
    case Op::Add:
      return made(a.min + b.min, a.max + b.max);
    case Op::Subtract:
      return made(a.min - b.max, a.max - b.min);
    case Op::Multiply:
      return product_of(a, b);
    case Op::Min:
      return {std::min(a.min, b.min), std::min(a.max, b.max)};
    case Op::Max:
      return {std::max(a.min, b.min), std::max(a.max, b.max)};
    case Op::Atan2:
      return angle_between(a, b);
  }
  return {};
}

}  // namespace burin
