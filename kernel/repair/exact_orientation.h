#pragma once
/// The exact sign of the area of a plane triangle.

#include <burin/base/vec.h>

namespace burin {

/// +1 where a, b, c turn left, -1 right, 0 where they lie on a line: exact for all finite doubles
/// whose products stay in range. Fast unless the points are nearly collinear. @cite Shewchuk1997
int orientation(Vec2 a, Vec2 b, Vec2 c);

}  // namespace burin
