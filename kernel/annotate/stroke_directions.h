#pragma once
// Which way strokes run where; internal to the module.

#include <burin/base/box.h>
#include <burin/drawing/drawing.h>

#include <cstddef>
#include <vector>

namespace burin::detail {

/// The directions of strokes and hatching of a drawing, in cells of the sheet.
class StrokeDirections {
 public:
  explicit StrokeDirections(const Drawing& drawing);

  /// Paper mm of a line that run within 12 degrees of the strokes under it.
  double along(Vec2 from, Vec2 to) const;

 private:
  /// Sum over strokes of length times (cos, sin) of twice the angle, and of length.
  struct Cell {
    Vec2 doubled{0};
    double length = 0;
  };
  /// Null outside.
  const Cell* at(Vec2 p) const;

  Vec2 origin_{0};
  std::size_t width_ = 0, height_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace burin::detail
