#pragma once
/// Straight segments as they lie in the picture.

#include <burin/base/vec.h>

#include <cstdint>

namespace burin {

/// A straight segment of the picture; ranges as in `space_share`.
struct PictureSegment {
  Vec2 a{0}, b{0};
  double depth_a = 0, depth_b = 0;
  double range_a = 1, range_b = 1;
  /// Which segment of which curve; segments that follow each other on one curve do not cross.
  std::int32_t curve = -1;
  std::uint32_t index = 0, before = 0, after = 0;
};

inline bool follow_each_other(const PictureSegment& a, const PictureSegment& b) {
  return a.curve >= 0 && a.curve == b.curve &&
         (a.index == b.index || a.index == b.before || a.index == b.after);
}

/// The share of a segment in space for a share in its picture, and back. `from` and `to` are the
/// distances of its ends from the viewer along the axis of the view (both 1 in an orthographic
/// one): in perspective the far half of a segment is the smaller one on paper.
inline double space_share(double picture, double from, double to) {
  return picture * from / ((1 - picture) * to + picture * from);
}
inline double picture_share(double space, double from, double to) {
  return space * to / ((1 - space) * from + space * to);
}

}  // namespace burin
