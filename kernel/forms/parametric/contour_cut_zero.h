#pragma once
// Zeros of a function of one variable that cannot be missed.

#include <algorithm>
#include <cmath>

namespace burin {

/// A zero of `f` in [0,1], whose values at the ends have different signs: inverse quadratic
/// interpolation where it can be trusted, bisection elsewhere. Within 1e-13, after some 7 calls
/// where f is nearly linear, 60 at most. @cite Chandrupatla1997
template <class Function>
double bracketed_zero(const Function& f, double at_0, double at_1) {
  constexpr double kEnough = 1e-13;  // of the bracket: 1e-4 of what positions of size 1 resolve
  constexpr double kNoise = 2e-15;   // rounding of a dot product of unit vectors
  double x1 = 1, f1 = at_1, x2 = 0, f2 = at_0;
  double share = f1 / (f1 - f2);
  for (int i = 0; i < 60; ++i) {
    const double x = x1 + share * (x2 - x1), fx = f(x);
    double x3 = x1, f3 = f1;
    if ((fx > 0) != (f1 > 0)) {
      x3 = x2, f3 = f2;
      x2 = x1, f2 = f1;
    }
    x1 = x, f1 = fx;
    const double least = kEnough / std::abs(x2 - x1);
    if (least > 0.5 || std::abs(f1) <= kNoise) break;
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
