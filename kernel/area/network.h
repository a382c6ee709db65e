#pragma once
/// The lines of a sheet as points and segments that meet in common points; internal to the module.

#include <burin/area/partition.h>

#include <array>
#include <memory>

namespace burin::detail {

struct Segment {
  std::array<std::uint32_t, 2> ends;
  /// `BorderLine::line`; of segments that lie on each other the lowest that is one.
  std::int32_t line = -1;
};

struct Network {
  std::vector<Vec2> points;
  std::vector<Segment> segments;
};

/// The lines within `sheet`, and its frame. Points near each other are one, segments are divided at
/// points near them, and free ends are joined to the nearest line. Cost: n log n; segments that lie
/// across large parts of the sheet see all points in their box.
Network make_network(const Box2& sheet, std::span<const BorderLine> lines,
                     const PartitionOptions& options);

/// The segments near a place.
class NearSegments {
 public:
  explicit NearSegments(const Network& network);
  ~NearSegments();
  NearSegments(const NearSegments&) = delete;
  NearSegments& operator=(const NearSegments&) = delete;

  /// `BorderLine::line` of the nearest drawn segment within `reach` paper mm of both points, the
  /// lowest of those at one distance; -1: none.
  std::int32_t line_along(Vec2 a, Vec2 b, double reach) const;

 private:
  struct Tree;
  const Network& network_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace burin::detail
