#pragma once
/// The piece of a segment that lies in a rectangle.

#include <burin/base/box.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace burin {

/// The shares of the way from `a` to `b` between which the segment is in the box, borders included;
/// nothing where it is outside. @cite LiangBarsky1984
inline std::optional<std::pair<double, double>> segment_in_box(Vec2 a, Vec2 b, const Box2& box) {
  double from = 0, to = 1;
  for (int i = 0; i < 2; ++i) {
    const double d = b[i] - a[i];
    if (d == 0) {
      if (a[i] < box.min[i] || a[i] > box.max[i]) return {};
      continue;
    }
    const double u = (box.min[i] - a[i]) / d, v = (box.max[i] - a[i]) / d;
    from = std::max(from, std::min(u, v));
    to = std::min(to, std::max(u, v));
  }
  if (!(from <= to)) return {};
  return std::pair(from, to);
}

}  // namespace burin
