#pragma once
/// The points of a plane that are nearest to a place; points can be taken away. Internal to the
/// module.

#include <burin/base/box.h>
#include <burin/base/run_context.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace burin {

/// A k-d tree whose nodes know how many of their points are left, so that looking for the nearest
/// of the last few points of a million costs no more than at first. @cite Bentley1990
class PointTree {
 public:
  struct Near {
    std::uint32_t point = 0;
    /// mm.
    double distance = 0;
  };

  /// Polls `context`, which throws Cancelled. Cost: n log n.
  PointTree(std::vector<Vec2> points, const RunContext& context);

  const std::vector<Vec2>& points() const { return points_; }
  /// Takes a point away; once.
  void remove(std::uint32_t point);
  /// One of the nearest points that are left; nothing where none is.
  std::optional<std::uint32_t> nearest(Vec2 place) const;
  /// At most `most` points that are left within `radius` of a place, by their distance.
  std::vector<Near> near(Vec2 place, std::size_t most,
                         double radius = std::numeric_limits<double>::infinity()) const;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Node {
    Box2 box;
    std::uint32_t begin = 0, end = 0, left = 0;  // children: left and the one after it; 0: a leaf
    std::uint32_t above = kNone;
    std::uint32_t count = 0;  // points that are left
  };

  void divide(std::uint32_t node, const RunContext& context);
  template <class Visit, class Reach>
  void search(Vec2 place, const Visit& visit, const Reach& reach) const;

  std::vector<Vec2> points_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> leaf_;  // of each point; kNone: taken away
  std::vector<Node> nodes_;
};

}  // namespace burin
