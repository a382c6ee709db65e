#pragma once
/// The directions of a flat part from its outline.

#include <burin/base/vec.h>

#include <optional>
#include <vector>

namespace burin::field {

/// The unit directions of a cross; `first` belongs to family 1.
struct CrossDirections {
  Vec3 first{1, 0, 0};
  Vec3 second{0, 1, 0};
};

/// A flat part: a constant cross, or circles and rays about a centre.
struct FlatPatch {
  Vec3 normal{0, 0, 1};
  CrossDirections arms;
  std::optional<Vec3> center;
  /// Whether family 1 is the rays'.
  bool rays_first = false;
  /// Model mm; nearer to the centre than this there is no direction.
  double hub = 0;

  std::optional<CrossDirections> at(Vec3 position) const;
  /// Exchanges the families.
  void swap_families();
};

/// An edge of a flat part's outline: its middle, its vector, whether the surface goes on smoothly
/// behind it, and an arm of the cross that strokes have there (the edge itself at a crease, a
/// principal direction at a smooth border).
struct OutlineEdge {
  Vec3 middle{0};
  Vec3 vector{0};
  bool smooth = false;
  Vec3 arm{0};
};

/// The cross of a flat part. It is constant and follows the outline (the mean of the outline's
/// directions to the fourth power, by length) where that has a direction. Where it has none, as a
/// circle: circles about the centre if the part goes over into round fillets all around, and
/// `fallback` if creases bound it. Nothing where the smooth border has no such shape: then the
/// field had better flow in from it.
std::optional<FlatPatch> flat_cross(Vec3 normal, const std::vector<OutlineEdge>& outline,
                                    Vec3 fallback);

}  // namespace burin::field
