#pragma once
/// Zeros of a function of one variable that cannot be missed.

#include <algorithm>
#include <cmath>

namespace burin {

/// When a zero is near enough.
struct ZeroLimits {
  /// Of the bracket: 1e-4 of what positions of size 1 resolve.
  double bracket = 1e-13;
  /// Of the value: rounding of a dot product of unit vectors.
  double value = 2e-15;
};

/// A zero of `f` in [0,1], whose values at the ends have different signs: inverse quadratic
/// interpolation where it can be trusted, bisection elsewhere. Some 7 calls where f
/// is nearly linear, 60 at most. @cite Chandrupatla1997
template <class Function>
double bracketed_zero(const Function& f, double at_0, double at_1, ZeroLimits limits = {}) {
  double x1 = 1, f1 = at_1, x2 = 0, f2 = at_0;
  double share = f1 / (f1 - f2);
  if (!(share >= 0 && share <= 1)) share = 0.5;  // infinite values
  for (int i = 0; i < 60; ++i) {
    const double x = x1 + share * (x2 - x1), fx = f(x);
    double x3 = x1, f3 = f1;
    if ((fx > 0) != (f1 > 0)) {
      x3 = x2, f3 = f2;
      x2 = x1, f2 = f1;
    }
    x1 = x, f1 = fx;
    const double least = limits.bracket / std::abs(x2 - x1);
    if (least > 0.5 || std::abs(f1) <= limits.value) break;
    const double xi = (x1 - x2) / (x3 - x2), phi = (f1 - f2) / (f3 - f2);
    share = 0.5;
    if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi) {
      share =
          f1 / (f2 - f1) * f3 / (f2 - f3) + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2);
    }
    share = std::clamp(share, least, 1 - least);
  }
  return std::abs(f1) <= std::abs(f2) ? x1 : x2;
}

}  // namespace burin
