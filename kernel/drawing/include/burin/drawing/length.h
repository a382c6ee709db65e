#pragma once
/// How long lines are.

#include <burin/drawing/drawing.h>

namespace burin {

/// Paper mm from the first point to the last; of a closed path without the way back.
inline double length_of(const Path& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    length += glm::distance(path.points[i - 1], path.points[i]);
  }
  return length;
}

}  // namespace burin
