#pragma once
// Where strokes stand: the ways to place them, one row each.

#include <burin/stroke/marks.h>

#include "picture.h"
#include "placement.h"
#include "seeds.h"
#include "view_raster.h"

#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace burin::detail {

struct Placing {
  std::string_view name;
  /// What it makes of the coverage, in a few words.
  std::string_view meaning;
  /// The points that strokes come from.
  Coverage (*cover)(const Picture&, const ViewRaster&, const RunContext&);
  /// The strokes of `families` families (1 or 2), one entry each. `progress` is called with the
  /// share that is done, from the calling thread.
  std::vector<Family> (*place)(const Picture&, const ViewRaster&, const std::vector<Seed>&,
                               int families, const RunContext&,
                               const std::function<void(double)>& progress);
  /// What a paper mm2 gets where strokes of one family are to cover a share `ink` of it.
  struct Load {
    double length = 0;   // paper mm of strokes
    double strokes = 0;  // how many; 0 where they are long
  };
  Load (*load)(const Picture&, double ink);
  Picture::PlacementKind placement_kind = Picture::PlacementKind::Apart;
};

/// All of them, the usual one first.
std::span<const Placing> placings();

/// The kind of marks from elsewhere that has the name; null: none.
const MarkKind* find_mark(std::string_view name);

/// Throws UsageError that lists them all.
const Placing& find_placing(std::string_view name);

}  // namespace burin::detail
