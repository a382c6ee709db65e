#pragma once
/// Colours of the vertices or faces of a PLY file.

#include "look.h"
#include "ply_header.h"

namespace burin {

/// The colour channels of one element, as they are read property by property.
class PlyColors {
 public:
  explicit PlyColors(const PlyElement& element);

  /// Whether the elements have colours.
  bool any() const { return has_[0] && has_[1] && has_[2]; }
  /// Whether the property is one of the channels.
  bool takes(std::size_t property) const { return channel_of_[property] >= 0; }
  void take(std::size_t property, double value);
  /// Of the element that was read last.
  const Rgba& color() const { return color_; }

 private:
  /// Of each property: 0 to 3, or -1; and what makes its values shares of 1.
  std::vector<int> channel_of_;
  std::vector<double> unit_;
  std::array<bool, 3> has_{};
  Rgba color_{0, 0, 0, 255};
};

}  // namespace burin
