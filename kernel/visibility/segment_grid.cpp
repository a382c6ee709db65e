#include "segment_grid.h"

#include <cmath>

namespace burin {

SegmentGrid::SegmentGrid(std::span<const PictureSegment> segments, double reach) {
  if (segments.empty()) return;
  double total = 0;
  for (const PictureSegment& s : segments) {
    box_.add(s.a);
    box_.add(s.b);
    total += glm::length(s.b - s.a);
  }
  box_.min -= 2 * reach;
  box_.max += 2 * reach;
  const Vec2 size = box_.size();
  const auto n = static_cast<double>(segments.size());
  cell_ = std::max(
      {std::sqrt(size.x * size.y / n), 0.5 * total / n, 1e-4 * std::max(size.x, size.y), reach});
  columns_ = static_cast<int>(size.x / cell_) + 1;
  rows_ = static_cast<int>(size.y / cell_) + 1;
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const PictureSegment& s : segments) {
    visit_cells(s, reach, [&](std::size_t cell) { ++first_[cell + 1]; });
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  members_.resize(first_.back());
  std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    visit_cells(segments[i], reach,
                [&](std::size_t cell) { members_[fill[cell]++] = static_cast<std::uint32_t>(i); });
  }
}

}  // namespace burin
