#pragma once
/// Which areas of a drawing hold a place of the sheet.

#include <burin/base/vec.h>
#include <burin/drawing/drawing.h>
#include <burin/planar/near_lines.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace burin {

/// Areas by rows of the sheet. Read by many threads.
class AreasAt {
 public:
  /// `reach`: paper mm within which borders are looked for. The areas must outlive it. Cost: that
  /// of their points.
  AreasAt(std::span<const Area> areas, double reach);

  /// The numbers of those that hold a place (paper mm), ascending: the last is painted over the
  /// others. Cost: a look at the sides in a row of 0.25 mm.
  std::vector<std::size_t> at(Vec2 paper) const;
  /// Whether a border of one of them passes within reach.
  bool beside_border(Vec2 paper) const { return borders_.near(paper); }

 private:
  struct Side {
    Vec2 a, b;
    std::size_t area;
  };
  /// By their lower edge.
  std::map<std::int64_t, std::vector<Side>> rows_;
  NearLines borders_;
};

}  // namespace burin
