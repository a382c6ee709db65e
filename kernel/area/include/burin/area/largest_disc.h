#pragma once
/// The place of an area that is farthest from its border: its pole of inaccessibility.

#include <burin/base/vec.h>

#include <array>
#include <limits>
#include <span>

namespace burin {

/// A straight piece of a border or a line, by its ends; paper mm.
using BorderSide = std::array<Vec2, 2>;

/// Whether `border` encloses a point by even-odd, its sides in any order.
bool encloses(std::span<const BorderSide> border, Vec2 p);

double distance_to(const BorderSide& side, Vec2 p);

/// Paper mm.
struct InnerDisc {
  Vec2 middle{0};
  /// 0: there is none.
  double radius = 0;
};

struct DiscOptions {
  /// Paper mm by which a larger disc may be missed. More than 0.
  double precision = 0.1;
  /// Paper mm: the search ends as soon as a disc of this radius is found, or there is none.
  double enough = std::numeric_limits<double>::infinity();
};

/// The largest disc within the area that `border` encloses by even-odd, its sides in any order, and
/// which no side of `across` passes through. The area is searched by squares that are divided where
/// their disc might be larger, at most 20,000 of them, each with the sides that may be nearest in
/// it. Cost: some 20 passes over the sides. @cite Agafonkin2016
InnerDisc largest_disc(std::span<const BorderSide> border, std::span<const BorderSide> across = {},
                       const DiscOptions& options = {});

}  // namespace burin
