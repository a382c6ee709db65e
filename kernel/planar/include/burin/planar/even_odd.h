#pragma once
/// Which places closed rings enclose.

#include <burin/base/vec.h>

namespace burin {

/// Whether a ray from `p` towards greater x crosses the segment from `a` to `b`. Where it crosses
/// an odd number of the sides of rings, `p` is inside them by even-odd; each corner counts once.
inline bool crosses_ray(Vec2 a, Vec2 b, Vec2 p) {
  return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
}

}  // namespace burin
