#pragma once
// The number of a dimension with what stands behind it; internal to the module.

#include <burin/annotate/dimensions.h>

#include "shapes.h"

namespace burin::detail {

/// Of the height of numbers: between a number and its line; how far extension lines go beyond the
/// line; arrows.
inline constexpr double kBelowText = 0.25, kBeyondLine = 0.6, kArrow = 0.85;

class DimensionLetters {
 public:
  DimensionLetters(const Dimension& dimension, double height);

  double width() const { return main_ + (stacked() ? gap() + deviations_ : 0); }
  /// From the base line of what is on a line to its top.
  double height() const { return stacked() ? (2 * kSmall + kBetween) * height_ : height_; }
  /// `low`: where all of it begins; it lies on the left of `along`, unit.
  Quad quad(Vec2 low, Vec2 along) const { return quad_of(low, along, width(), height()); }
  void lay(Vec2 low, Vec2 along, Layer& layer) const;

 private:
  /// Of the height of numbers: that of deviations, and the gap between the two. @cite ISO129
  static constexpr double kSmall = 0.7, kBetween = 0.3;
  bool stacked() const { return !dimension_.upper.empty() || !dimension_.lower.empty(); }
  double gap() const { return 0.35 * height_; }

  const Dimension& dimension_;
  double height_, main_, deviations_;
};

}  // namespace burin::detail
