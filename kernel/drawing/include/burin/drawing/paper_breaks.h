#pragma once
/// Broken views: stretches of a view that are left out, and how what is left moves together.

#include <burin/base/vec.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace burin {

/// What of a view is left out: bands across one direction of the paper.
struct PaperBreaks {
  struct Band {
    double low = 0, high = 0;
    bool operator==(const Band&) const = default;
  };
  /// Unit, on paper: the way along which the view becomes shorter.
  Vec2 along{1, 0};
  /// Paper mm along it in the whole view, ascending, apart from each other.
  std::vector<Band> bands = {};
  /// Paper mm that are left of each band; of a narrower band all of it.
  double gap = 0;
  /// How far all of it moves beside.
  Vec2 offset{0};

  bool empty() const { return bands.empty(); }
  double gap_of(const Band& band) const { return std::min(gap, band.high - band.low); }
  /// How far a piece moves: 0 is before the first band, 1 behind it, ...
  Vec2 shift(std::size_t piece) const;
  /// Where a place of the whole view is on the sheet; places in a band are spread over its gap.
  Vec2 moved(Vec2 place) const;
  /// Whether a place of the whole view, or something `around` it in paper mm, is in a band.
  bool leaves_out(Vec2 place, double around = 0) const;
  /// The same of the whole view as it lies `by` farther.
  PaperBreaks of_moved_view(Vec2 by) const;

  bool operator==(const PaperBreaks&) const = default;
};

}  // namespace burin
