#pragma once
// Segments of lines on paper, and which lie along one; internal to the module.

#include <burin/drawing/drawing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace burin {

/// Segments in square cells.
class PathGrid {
 public:
  /// `reach`: paper mm, up to which segments lie on each other.
  explicit PathGrid(double reach) : reach_(reach) {}

  /// Cost: 0.1 us a segment and mm.
  void add(Vec2 a, Vec2 b, std::size_t owner);
  /// All segments of a path.
  void add(const Path& path, std::size_t owner);

  /// Tells each stretch of the segment ab, as shares of it, that lies within reach of a segment
  /// that runs the same way (either way round), and the owner of that.
  template <class Tell>
  void along(Vec2 a, Vec2 b, const Tell& report) const {
    const double length = glm::distance(a, b);
    if (!(length > 0)) return;
    const Vec2 way = (b - a) / length;
    near_.clear();
    for_cells(a, b, reach_, [&](std::uint64_t key) {
      const auto cell = cells_.find(key);
      if (cell != cells_.end()) near_.insert(near_.end(), cell->second.begin(), cell->second.end());
    });
    std::ranges::sort(near_);
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    for (const std::uint32_t i : near_) {
      const Segment& s = segments_[i];
      const double own = glm::distance(s.a, s.b);
      if (!(std::abs(glm::dot(way, s.b - s.a)) >= same_way(std::min(own, length)) * own)) continue;
      if (const auto part = within(a, b, s)) report(part->first, part->second, s.owner);
    }
  }

 private:
  struct Segment {
    Vec2 a, b;
    std::size_t owner;
  };
  static constexpr double kSide = 2;  // paper mm

  /// Cosine of the angle up to which segments run the same way, the shorter one of a length. Two
  /// polygons that stand for one curve within 0.005 mm turn by 0.04 mm over that length.
  static double same_way(double length) {
    constexpr double kAngle = 0.1, kTurn = 0.04, kMost = 0.45;  // radians
    return std::cos(std::min(kAngle + kTurn / length, kMost));
  }

  template <class Use>
  static void for_cells(Vec2 a, Vec2 b, double more, const Use& use) {
    // Pieces no longer than a cell, each in the box about it.
    constexpr double kMostPieces = 1e6;
    const double pieces = std::clamp(std::ceil(glm::distance(a, b) / kSide), 1.0, kMostPieces);
    for (double k = 0; k < pieces; ++k) {
      const Vec2 p = glm::mix(a, b, k / pieces), q = glm::mix(a, b, (k + 1) / pieces);
      const Vec2 low = glm::floor((glm::min(p, q) - more) / kSide);
      const Vec2 high = glm::floor((glm::max(p, q) + more) / kSide);
      for (double x = low.x; x <= high.x; ++x) {
        for (double y = low.y; y <= high.y; ++y) {
          use(static_cast<std::uint64_t>(static_cast<std::int64_t>(x)) << 32U ^
              (static_cast<std::uint64_t>(static_cast<std::int64_t>(y)) & 0xffffffffU));
        }
      }
    }
  }

  /// The share of ab beside a segment within reach: one stretch, as what is beside it is convex.
  /// What lies beyond its ends goes on from it.
  std::optional<std::pair<double, double>> within(Vec2 a, Vec2 b, const Segment& s) const;

  double reach_;
  std::vector<Segment> segments_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
  mutable std::vector<std::uint32_t> near_;
};

}  // namespace burin
