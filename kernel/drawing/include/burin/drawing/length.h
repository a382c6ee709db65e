#pragma once
/// How long lines are.

#include <burin/drawing/drawing.h>

#include <span>

namespace burin {

/// Paper mm from the first point to the last.
inline double length_of(std::span<const Vec2> points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += glm::distance(points[i - 1], points[i]);
  }
  return length;
}

/// Paper mm from the first point to the last; of a closed path without the way back.
inline double length_of(const Path& path) { return length_of(std::span<const Vec2>(path.points)); }

}  // namespace burin
