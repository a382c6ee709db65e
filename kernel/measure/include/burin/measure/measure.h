#pragma once
/// Lengths and angles between features of parts, from their equations.

#include <burin/measure/feature.h>

#include <optional>

namespace burin {

/// How far one feature is from another along a direction: planes count where they stand across it,
/// axes and straight edges where they run across it, centres and points always.
struct MeasuredDistance {
  /// mm over 0.
  double length = 0;
  /// Unit, from the first to the second.
  Vec3 along{1, 0, 0};
  /// A point of each: (to - from) is `length` along `along`, and nothing across it where both
  /// features allow that.
  Vec3 from{0}, to{0};
};

/// The distance of two features: of parallel planes; of a plane from an axis, a straight edge or a
/// point; of parallel or crossing axes and edges; of points, which are centres of spheres, too.
/// `along`, any length but 0: measured in this direction. Throws UsageError where the two have no
/// one distance, says what they are, and what to do.
MeasuredDistance distance_between(const Feature& a, const Feature& b,
                                  const std::optional<Vec3>& along = {});

/// The angle between planes, axes and straight edges.
struct MeasuredAngle {
  /// Over 0 and below 180.
  double degrees = 0;
  /// Where both meet, and the way from there along each, unit.
  Vec3 vertex{0}, first{1, 0, 0}, second{0, 1, 0};
};

/// Between the sides of the angle on which the features lie. Throws UsageError where they are
/// parallel, do not meet or have no direction.
MeasuredAngle angle_between(const Feature& a, const Feature& b);

/// Where the sides of a cone meet.
Vec3 apex_of(const Feature& cone);

}  // namespace burin
