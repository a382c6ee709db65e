#include <burin/drawing/coincident.h>

#include "curves/path_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// Cells of this many mm at least: a few segments in each.
constexpr double kLeastSide = 1;

std::uint64_t key_of(std::int64_t x, std::int64_t y) {
  return (static_cast<std::uint64_t>(x) << 32U) ^ (static_cast<std::uint64_t>(y) & 0xffffffffU);
}

double distance_to(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 way = b - a;
  const double length2 = glm::dot(way, way);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - a, way) / length2, 0.0, 1.0) : 0;
  return glm::distance(p, a + t * way);
}

/// A stretch between two places along a path: the index of a segment and the share of it.
struct Run {
  double begin = 0, end = 0, length = 0;
  bool on = false;
};

/// Neighbours of one kind made one.
std::vector<Run> joined(const std::vector<Run>& runs) {
  std::vector<Run> out;
  for (const Run& run : runs) {
    if (!out.empty() && out.back().on == run.on) {
      out.back().end = run.end;
      out.back().length += run.length;
    } else {
      out.push_back(run);
    }
  }
  return out;
}

std::vector<Run> runs_of(const std::vector<Vec2>& points, const LinesOnPaper& lines) {
  std::vector<Run> runs;
  constexpr double kMostSteps = 1e6;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double length = glm::distance(points[i], points[i + 1]);
    const double steps = std::clamp(std::ceil(2 * length / lines.tolerance()), 1.0, kMostSteps);
    for (double k = 0; k < steps; ++k) {
      const double middle = (k + 0.5) / steps;
      runs.push_back({static_cast<double>(i) + k / steps, static_cast<double>(i) + (k + 1) / steps,
                      length / steps, lines.holds(glm::mix(points[i], points[i + 1], middle))});
    }
  }
  return joined(runs);
}

}  // namespace

LinesOnPaper::LinesOnPaper(double tolerance)
    : tolerance_(tolerance), side_(std::max(kLeastSide, 4 * tolerance)) {}

void LinesOnPaper::add(const Path& path) {
  const std::size_t n = path.points.size();
  for (std::size_t i = 0; i + (path.closed ? 0 : 1) < n; ++i) {
    const Vec2 a = path.points[i], b = path.points[(i + 1) % n];
    const auto index = static_cast<std::uint32_t>(segments_.size());
    segments_.emplace_back(a, b);
    // Points half a cell apart: whatever lies on the segment is in a cell beside that of one.
    constexpr double kMostSteps = 1e6;
    const double steps = std::clamp(std::ceil(2 * glm::distance(a, b) / side_), 1.0, kMostSteps);
    for (double k = 0; k <= steps; ++k) {
      const Vec2 p = glm::floor(glm::mix(a, b, k / steps) / side_);
      auto& cell = cells_[key_of(static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y))];
      if (cell.empty() || cell.back() != index) cell.push_back(index);
    }
  }
}

double LinesOnPaper::distance(Vec2 at, double most) const {
  const auto reach = static_cast<std::int64_t>(std::ceil(most / side_ + 0.25));
  const Vec2 middle = glm::floor(at / side_);
  double least = most;
  for (std::int64_t x = -reach; x <= reach; ++x) {
    for (std::int64_t y = -reach; y <= reach; ++y) {
      const auto cell = cells_.find(
          key_of(static_cast<std::int64_t>(middle.x) + x, static_cast<std::int64_t>(middle.y) + y));
      if (cell == cells_.end()) continue;
      for (const std::uint32_t i : cell->second) {
        least = std::min(least, distance_to(at, segments_[i].first, segments_[i].second));
      }
    }
  }
  return least;
}

bool LinesOnPaper::holds(Vec2 at) const {
  constexpr double kMore = 1.5;
  return distance(at, kMore * tolerance_) <= tolerance_;
}

PartedPath parted(const Path& path, const LinesOnPaper& lines, double least) {
  PartedPath out;
  if (path.points.size() < 2) return out;
  const OpenedPath open(path);
  std::vector<Run> runs = runs_of(open.points(), lines);
  // Short stretches between others are their neighbours', gaps before specks.
  for (const bool kind : {true, false}) {
    for (Run& run : runs) {
      if (runs.size() > 1 && run.on == kind && run.length < least) run.on = !kind;
    }
    runs = joined(runs);
  }
  if (runs.size() == 1) {
    (runs.front().on ? out.on : out.off).push_back(path);
    return out;
  }
  for (const Run& run : runs) {
    (run.on ? out.on : out.off).push_back(open.piece(run.begin, run.end));
  }
  return out;
}

}  // namespace burin
