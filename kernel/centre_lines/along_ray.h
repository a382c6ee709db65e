#pragma once
// What triangles cover of a ray on paper; internal to the module.

#include <burin/base/vec.h>

#include <array>

namespace burin::detail {

/// From a point in a direction (unit), so many mm far.
struct PaperRay {
  Vec2 from{0}, way{1, 0};
  double length = 0;
};

/// The farthest place at which a side of a triangle crosses the ray, and whether one covers its
/// end.
struct AlongRay {
  double farthest = 0;
  bool covers_end = false;

  void add(const PaperRay& ray, const std::array<Vec2, 3>& corners);
};

}  // namespace burin::detail
