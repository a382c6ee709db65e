#pragma once
/// Which lines of a sheet pass near a place, and which end where no other one is.

#include <burin/base/vec.h>

#include <cstddef>
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
  /// The same of those segments for which `counts(line, segment)` says so.
  double distance(Vec2 p, const std::function<bool(std::size_t, std::size_t)>& counts) const;
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

/// Of polylines in a list.
struct LineEnd {
  std::size_t line = 0;
  bool last = false;
};

/// Paper mm along a line from its start to each of its points.
std::vector<double> lengths_along(const Polyline& line);

/// The ends of `asked` (indices of `lines`) without another of the lines within `reach` paper mm;
/// of a line's own course what is `away` mm and more from the end along it is another line.
std::vector<LineEnd> free_ends(std::span<const Polyline> lines, const NearLines& grid,
                               std::span<const std::size_t> asked, double away);

}  // namespace burin
