#pragma once
/// Straight segments as they lie in the picture.

#include <burin/base/vec.h>

#include <algorithm>
#include <cmath>
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

/// The same for a segment; the share of the picture may miss [0,1] by rounding.
inline double to_space(const PictureSegment& s, double picture) {
  return space_share(std::clamp(picture, 0.0, 1.0), s.range_a, s.range_b);
}
inline double depth_at(const PictureSegment& s, double space) {
  return s.depth_a + space * (s.depth_b - s.depth_a);
}

inline bool is_finite(const PictureSegment& s) {
  return std::isfinite(s.a.x + s.a.y + s.b.x + s.b.y) && s.range_a > 0 && s.range_b > 0;
}

/// The piece of a segment between two shares of it in space.
inline PictureSegment part_of(const PictureSegment& s, double begin, double end) {
  const double u = picture_share(begin, s.range_a, s.range_b);
  const double v = picture_share(end, s.range_a, s.range_b);
  PictureSegment out = s;
  out.a = u == 0 ? s.a : glm::mix(s.a, s.b, u);
  out.b = v == 1 ? s.b : glm::mix(s.a, s.b, v);
  out.depth_a = glm::mix(s.depth_a, s.depth_b, begin);
  out.depth_b = glm::mix(s.depth_a, s.depth_b, end);
  out.range_a = glm::mix(s.range_a, s.range_b, begin);
  out.range_b = glm::mix(s.range_a, s.range_b, end);
  return out;
}

}  // namespace burin
