#include <burin/base/nearest_along.h>
#include <burin/planar/near_lines.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

std::int64_t key(std::int64_t x, std::int64_t y) { return x * 1'000'003 + y; }

}  // namespace

NearLines::NearLines(std::span<const Polyline> lines, double reach) : reach_(reach) {
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const Polyline& line = lines[l];
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec2 a = line[i], b = line[i + 1];
      const auto index = static_cast<std::uint32_t>(segments_.size());
      segments_.push_back({a, b, l, i});
      // Cells along the segment, one every cell's size: the query looks at those around.
      const auto steps = static_cast<std::int64_t>(glm::distance(a, b) / reach) + 1;
      std::int64_t last = INT64_MIN;
      for (std::int64_t s = 0; s <= steps; ++s) {
        const Vec2 p = a + static_cast<double>(s) / static_cast<double>(steps) * (b - a);
        const std::int64_t k = key(std::llround(p.x / reach), std::llround(p.y / reach));
        if (k != last) cells_[k].push_back(index);
        last = k;
      }
    }
  }
}

// Calls each(segment, distance) for segments within reach until it says true.
template <class F>
void NearLines::visit(Vec2 p, const F& each) const {
  const std::int64_t x = std::llround(p.x / reach_), y = std::llround(p.y / reach_);
  for (std::int64_t dx = -2; dx <= 2; ++dx) {
    for (std::int64_t dy = -2; dy <= 2; ++dy) {
      const auto cell = cells_.find(key(x + dx, y + dy));
      if (cell == cells_.end()) continue;
      for (const std::uint32_t i : cell->second) {
        const double d = distance_to_segment(segments_[i].a, segments_[i].b, p);
        if (d <= reach_ && each(segments_[i], d)) return;
      }
    }
  }
}

double NearLines::distance(Vec2 p) const {
  return distance(p, [](std::size_t, std::size_t) { return true; });
}

double NearLines::distance(Vec2 p,
                           const std::function<bool(std::size_t, std::size_t)>& counts) const {
  double least = std::numeric_limits<double>::infinity();
  visit(p, [&](const Segment& s, double d) {
    if (d < least && counts(s.line, s.index)) least = d;
    return false;
  });
  return least;
}

bool NearLines::near(Vec2 p) const {
  return near(p, [](std::size_t, std::size_t) { return true; });
}

bool NearLines::near(Vec2 p, const std::function<bool(std::size_t, std::size_t)>& counts) const {
  bool found = false;
  visit(p, [&](const Segment& s, double) { return found = counts(s.line, s.index); });
  return found;
}

std::vector<double> lengths_along(const Polyline& line) {
  std::vector<double> at{0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    at.push_back(at.back() + glm::distance(line[i - 1], line[i]));
  }
  return at;
}

std::vector<LineEnd> free_ends(std::span<const Polyline> lines, const NearLines& grid,
                               std::span<const std::size_t> asked, double away) {
  std::vector<LineEnd> out;
  for (const std::size_t own : asked) {
    const std::vector<double> at = lengths_along(lines[own]);
    for (const bool last : {false, true}) {
      const Vec2 end = last ? lines[own].back() : lines[own].front();
      const bool goes_on = grid.near(end, [&](std::size_t other, std::size_t segment) {
        if (other != own) return true;
        return last ? at.back() - at[segment + 1] >= away : at[segment] >= away;
      });
      if (!goes_on) out.push_back({own, last});
    }
  }
  return out;
}

}  // namespace burin
