#pragma once
/// A curve as it lies in the picture.

#include <burin/base/curve.h>
#include <burin/camera/camera.h>

#include "picture.h"

#include <vector>

namespace burin {

/// A curve's points on paper with what is needed to go between places in the picture and parameters
/// of the curve (segment index plus share of the segment in space). On a closed curve parameters
/// and lengths go on beyond the end.
class Track {
 public:
  Track(const Curve3& curve, const Camera& camera);

  std::size_t segment_count() const { return length_.size() - 1; }
  bool closed() const { return closed_; }
  Vec2 point(std::size_t i) const { return xy_[i]; }
  Vec2 start(std::size_t segment) const { return xy_[segment]; }
  Vec2 end(std::size_t segment) const { return xy_[next(segment)]; }
  double start_range(std::size_t segment) const { return range_[segment]; }
  double end_range(std::size_t segment) const { return range_[next(segment)]; }
  /// `curve` is any number that tells curves apart; -1: none.
  PictureSegment segment(std::size_t i, std::int32_t curve) const;
  /// Whole length in paper mm.
  double length() const { return length_.back(); }
  /// Paper mm from the curve's start to a parameter.
  double length_at(double parameter) const;
  /// The parameter a number of paper mm from the start.
  double parameter_at(double length) const;
  /// The unit direction of a segment on paper; zero where it is seen end on.
  Vec2 direction(std::size_t segment) const;

 private:
  std::size_t next(std::size_t i) const { return i + 1 == xy_.size() ? 0 : i + 1; }
  std::vector<Vec2> xy_;
  std::vector<double> depth_, range_, length_;
  bool closed_;
};

}  // namespace burin
