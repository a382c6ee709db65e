#pragma once
/// From one value to another without a kink.

#include <algorithm>

namespace burin {

/// 0 up to `low`, 1 from `high` on, a cubic with level ends between.
inline double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace burin
