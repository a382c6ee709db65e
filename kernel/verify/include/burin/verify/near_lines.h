#pragma once
/// Which lines of a sheet pass near a place.

#include <burin/base/vec.h>

#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

using Polyline = std::vector<Vec2>;

/// The segments of polylines in a grid of cells of the size of `reach`.
class NearLines {
 public:
  NearLines(std::span<const Polyline> lines, double reach);
  /// Paper mm to the nearest segment; infinite where none passes within `reach`.
  double distance(Vec2 p) const;
  bool near(Vec2 p) const;
  /// Whether one of those segments for which `counts(line, segment)` says so passes within `reach`.
  bool near(Vec2 p, const std::function<bool(std::size_t, std::size_t)>& counts) const;

 private:
  struct Segment {
    Vec2 a, b;
    std::size_t line, index;
  };
  template <class F>
  void visit(Vec2 p, const F& each) const;

  double reach_;
  std::vector<Segment> segments_;
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace burin
