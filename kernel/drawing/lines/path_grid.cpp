#include "path_grid.h"

#include "turned.h"

namespace burin {
namespace {

using Share = std::pair<double, double>;

/// Narrows a share to where `at + t * by` lies between two numbers; false where it never does.
bool narrow(Share& share, double at, double by, double low, double high) {
  if (by == 0) return at >= low && at <= high;
  const double u = (low - at) / by, v = (high - at) / by;
  share.first = std::max(share.first, std::min(u, v));
  share.second = std::min(share.second, std::max(u, v));
  return share.first <= share.second;
}

/// The share of ab in the strip of both sides of a segment.
std::optional<Share> in_strip(Vec2 a, Vec2 b, Vec2 from, Vec2 to, double reach) {
  const double length = glm::distance(from, to);
  if (!(length > 0)) return std::nullopt;
  const Vec2 along = (to - from) / length, across = turned_left(along), way = b - a;
  Share share{0, 1};
  const bool is = narrow(share, glm::dot(a - from, along), glm::dot(way, along), 0, length) &&
                  narrow(share, glm::dot(a - from, across), glm::dot(way, across), -reach, reach);
  return is ? std::optional(share) : std::nullopt;
}

}  // namespace

void PathGrid::add(Vec2 a, Vec2 b, std::size_t owner) {
  if (a == b) return;
  const auto index = static_cast<std::uint32_t>(segments_.size());
  segments_.push_back({a, b, owner});
  for_cells(a, b, 0, [&](std::uint64_t key) {
    auto& cell = cells_[key];
    if (cell.empty() || cell.back() != index) cell.push_back(index);
  });
}

void PathGrid::add(const Path& path, std::size_t owner) {
  const std::size_t n = path.points.size();
  for (std::size_t i = 0; i + (path.closed ? 0 : 1) < n; ++i) {
    add(path.points[i], path.points[(i + 1) % n], owner);
  }
}

std::optional<Share> PathGrid::within(Vec2 a, Vec2 b, const Segment& s) const {
  const auto share = in_strip(a, b, s.a, s.b, reach_);
  return share && share->first < share->second ? share : std::nullopt;
}

}  // namespace burin
