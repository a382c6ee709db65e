#pragma once
/// Grey pictures that surfaces are textured with.

#include <burin/base/vec.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// Rows of lightness from 0 (black) to 1 (white), the bottom one first; at least one of each.
struct Image {
  std::int32_t width = 0, height = 0;
  std::vector<float> values;

  /// Lightness at (u, v): (0, 0) is the lower left corner, (1, 1) the upper right one; beyond, the
  /// picture repeats. Between the middles of pixels bilinear; no number where u or v is none.
  double at(double u, double v) const {
    const double x = (u - std::floor(u)) * width - 0.5, y = (v - std::floor(v)) * height - 0.5;
    if (!(std::isfinite(x) && std::isfinite(y))) return std::nan("");
    const double i = std::floor(x), j = std::floor(y), s = x - i, t = y - j;
    const auto column = static_cast<std::int32_t>(i), row = static_cast<std::int32_t>(j);
    return (1 - t) * ((1 - s) * pixel(column, row) + s * pixel(column + 1, row)) +
           t * ((1 - s) * pixel(column, row + 1) + s * pixel(column + 1, row + 1));
  }

  /// Of a column and a row, up to one beyond the picture on each side.
  double pixel(std::int32_t column, std::int32_t row) const {
    column = column < 0 ? width - 1 : column >= width ? column - width : column;
    row = row < 0 ? height - 1 : row >= height ? row - height : row;
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
  }
};

}  // namespace burin
