#pragma once
// Functions that are known in a box only: volumes and trivariate splines.

#include <burin/forms/implicit/implicit_function.h>

#include <array>
#include <memory>
#include <span>

namespace burin {

/// A scalar field over [0, last] in coordinates of its own.
class BoxField {
 public:
  BoxField() = default;
  BoxField(const BoxField&) = delete;
  BoxField& operator=(const BoxField&) = delete;
  virtual ~BoxField() = default;

  /// At points inside the box; others count as the nearest point of its border.
  virtual void values(std::span<const Vec3> at, std::span<double> out) const = 0;
  virtual void gradients(std::span<const Vec3> at, std::span<Gradient1> out) const = 0;
  virtual void hessians(std::span<const Vec3> at, std::span<Gradient2> out) const = 0;
  /// An interval that holds all values over the part of a box that is inside; over the six sides.
  virtual Interval range(Vec3 min, Vec3 max) const = 0;
  virtual Interval border_range() const = 0;
  /// Intervals that hold the three derivatives over a box that is inside; all numbers where it is
  /// too large to tell quickly.
  virtual std::array<Interval, 3> slopes([[maybe_unused]] Vec3 min,
                                         [[maybe_unused]] Vec3 max) const {
    return {};
  }
  /// A box that holds all points where the field is above (or else below) the level; empty where
  /// there are none.
  virtual Box3 support(double level, bool above) const = 0;
  virtual Vec3 last() const = 0;
};

/// Where a field stands in the model, and which part of it is solid.
struct BoxPlacement {
  Vec3 origin{0};
  Mat3 steps{1};
  double level = 0;
  bool inside_above = false;
  /// How steep planes and what lies outside are, in units of the field for one of its coordinates.
  double slope = 1;
};

/// field - level, or its negative where larger values are inside. Planes close it where the inside
/// reaches the sides of the box; outside it is positive.
std::shared_ptr<const ImplicitFunction> make_box_function(std::unique_ptr<const BoxField> field,
                                                          const BoxPlacement& placement);

}  // namespace burin
