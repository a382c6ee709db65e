#include <burin/base/parallel.h>
#include <burin/verify/referee.h>
#include <burin/verify/verify.h>

#include "feature_lines.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

// Paper mm between rays, more where these would be too many; and within which a line closes the
// border.
constexpr double kRayCell = 0.25;
constexpr double kMostRays = 1e6;
constexpr double kClose = 0.25;
// Paper mm that a line may lie beside facets which are drawn round.
constexpr double kRounded = 2;
constexpr double kShortestGap = 0.5;
constexpr int kBisections = 8;

/// A place of the border that no line closes.
struct Open {
  Vec2 paper{0};
  Referee::Seen seen;
};

struct RayGrid {
  Vec2 from{0};
  double cell = kRayCell;
  std::size_t columns = 0, rows = 0;

  Vec2 at(std::size_t i, std::size_t j) const {
    return from + cell * (Vec2(static_cast<double>(i), static_cast<double>(j)) + 0.5);
  }
};

RayGrid grid_of(const Drawing& drawing) {
  RayGrid grid;
  const Vec2 sheet(drawing.paper_width, drawing.paper_height);
  grid.cell = std::max(kRayCell, std::sqrt(sheet.x * sheet.y / kMostRays));
  grid.columns = static_cast<std::size_t>(sheet.x / grid.cell);
  grid.rows = static_cast<std::size_t>(sheet.y / grid.cell);
  return grid;
}

// The border between a covered and an empty place, if no line closes it.
std::optional<Open> open_border(Vec2 covered, Vec2 empty, const Referee& referee,
                                const NearLines& lines, const Camera& camera) {
  auto seen = referee.see(covered);
  for (int i = 0; i < kBisections; ++i) {
    const Vec2 middle = 0.5 * (covered + empty);
    if (auto there = referee.see(middle)) {
      covered = middle;
      seen = there;
    } else {
      empty = middle;
    }
  }
  const double rounded = 2 * seen->chord * camera.scale_at(seen->place);
  if (lines.distance(covered) <= std::min(kClose + rounded, kRounded)) return std::nullopt;
  return Open{covered, *seen};
}

// Places that hang together, within two cells of each other, as one stretch each.
std::vector<Contradiction> stretches(const std::vector<Open>& open, double cell) {
  std::vector<Contradiction> out;
  std::vector<char> taken(open.size(), 0);
  for (std::size_t first = 0; first < open.size(); ++first) {
    if (taken[first]) continue;
    std::vector<std::size_t> group{first};
    taken[first] = 1;
    Vec2 low = open[first].paper, high = low;
    for (std::size_t g = 0; g < group.size(); ++g) {
      const Vec2 p = open[group[g]].paper;
      low = glm::min(low, p), high = glm::max(high, p);
      for (std::size_t i = first + 1; i < open.size(); ++i) {
        if (taken[i] || glm::distance(open[i].paper, p) > 2 * cell) continue;
        taken[i] = 1;
        group.push_back(i);
      }
    }
    const double length = glm::distance(low, high);
    if (length < kShortestGap) continue;
    const Open& middle = open[group[group.size() / 2]];
    out.push_back({.what = "missing",
                   .source = middle.seen.source,
                   .length = length,
                   .at = middle.paper,
                   .model = middle.seen.place});
  }
  return out;
}

}  // namespace

std::vector<Contradiction> missing_outline(const Drawing& drawing, const Referee& referee,
                                           const Camera& camera, const RunContext& context) {
  std::vector<Polyline> polylines;
  each_feature_line(drawing, [&](const Layer&, const Path&, Polyline&& line) {
    polylines.push_back(std::move(line));
  });
  const NearLines lines(polylines, kRounded);
  const RayGrid grid = grid_of(drawing);
  std::vector<std::vector<char>> covered(grid.rows);
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      for (std::size_t i = 0; i < grid.columns; ++i) {
        covered[j].push_back(referee.see(grid.at(i, j)) ? 1 : 0);
      }
    }
  };
  parallel_for(grid.rows, 1, look, &context);
  std::vector<std::vector<Open>> open(grid.rows);
  const auto compare = [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      const auto pair = [&](std::size_t i, std::size_t k, std::size_t l) {
        if (k >= grid.columns || l >= grid.rows || covered[j][i] == covered[l][k]) return;
        const Vec2 a = grid.at(i, j), b = grid.at(k, l);
        if (auto o =
                open_border(covered[j][i] ? a : b, covered[j][i] ? b : a, referee, lines, camera)) {
          open[j].push_back(*o);
        }
      };
      for (std::size_t i = 0; i < grid.columns; ++i) {
        pair(i, i + 1, j);
        pair(i, i, j + 1);
      }
    }
  };
  parallel_for(grid.rows, 1, compare, &context);
  std::vector<Open> all;
  for (const auto& row : open) all.insert(all.end(), row.begin(), row.end());
  return stretches(all, grid.cell);
}

}  // namespace burin
