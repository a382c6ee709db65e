#pragma once
/// Segments of the picture in a uniform grid over the paper.

#include <burin/base/box.h>
#include <burin/base/vec.h>

#include "picture.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Finds segments near a segment. About one a cell where they are dense; cells never much smaller
/// than a segment, which would be in many, nor than the reach.
class SegmentGrid {
 public:
  SegmentGrid() = default;
  /// `reach`: paper mm by which segments are thickened; finite segments only.
  SegmentGrid(std::span<const PictureSegment> segments, double reach);

  /// Calls `visit(index)` for all segments in cells that `s`, thickened by `reach`, touches, some
  /// of them more than once.
  template <class Visit>
  void visit(const PictureSegment& s, double reach, Visit&& visit) const {
    if (first_.empty()) return;
    visit_cells(s, reach, [&](std::size_t cell) {
      for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) visit(members_[i]);
    });
  }

 private:
  template <class Visit>
  void visit_cells(const PictureSegment& s, double reach, Visit&& visit) const;
  int column(double x) const { return cell(x, box_.min.x, box_.max.x, columns_); }
  int row(double y) const { return cell(y, box_.min.y, box_.max.y, rows_); }
  int cell(double v, double low, double high, int count) const {
    return std::clamp(static_cast<int>((std::clamp(v, low, high) - low) / cell_), 0, count - 1);
  }

  Box2 box_;
  double cell_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_;    // per cell, one more than cells
  std::vector<std::uint32_t> members_;  // segment indices, cell by cell
};

// All cells that the segment, thickened by the reach, touches: row by row.
template <class Visit>
void SegmentGrid::visit_cells(const PictureSegment& s, double reach, Visit&& visit) const {
  const Vec2 lo = glm::min(s.a, s.b) - reach, hi = glm::max(s.a, s.b) + reach;
  if (hi.x < box_.min.x || hi.y < box_.min.y || lo.x > box_.max.x || lo.y > box_.max.y) return;
  const int first_row = row(lo.y), last_row = row(hi.y);
  const double slope = s.a.y == s.b.y ? 0 : (s.b.x - s.a.x) / (s.b.y - s.a.y);
  for (int j = first_row; j <= last_row; ++j) {
    double x0 = lo.x, x1 = hi.x;
    if (first_row != last_row && s.a.y != s.b.y) {
      const double y0 = box_.min.y + j * cell_ - reach, y1 = y0 + cell_ + 2 * reach;
      const double u = s.a.x + (y0 - s.a.y) * slope, v = s.a.x + (y1 - s.a.y) * slope;
      x0 = std::max(x0, std::min(u, v) - reach);
      x1 = std::min(x1, std::max(u, v) + reach);
      if (x0 > x1) continue;
    }
    if (x0 > box_.max.x || x1 < box_.min.x) continue;
    const int last = column(x1);
    for (int i = column(x0); i <= last; ++i) {
      visit(static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(i));
    }
  }
}

}  // namespace burin
