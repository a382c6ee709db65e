#pragma once
/// Sheets in the units of formats, and the largest of them.

#include <algorithm>
#include <cmath>

namespace burin {

inline constexpr double kMmPerInch = 25.4;
/// Readers by Adobe show no larger page.
inline constexpr double kLargestPdf = 200 * kMmPerInch;
/// Of a side of a picture; cairo ends at 32767.
inline constexpr int kMostPixels = 32000;

/// The pixels of a side of `mm` (up to 10000): one at least.
inline int pixels(double mm, double dpi) {
  return static_cast<int>(std::max(std::lround(mm * dpi / kMmPerInch), 1l));
}

}  // namespace burin
