#pragma once
/// Which stretches of a line lie on other lines of the sheet.

#include <burin/base/vec.h>
#include <burin/drawing/drawing.h>

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace burin {

/// Lines of a sheet as what others may lie on.
class LinesOnPaper {
 public:
  /// `tolerance`: paper mm, up to which a point lies on a line.
  explicit LinesOnPaper(double tolerance);

  /// Cost: 0.1 us a point and half a mm.
  void add(const Path& path);
  bool holds(Vec2 at) const;
  double tolerance() const { return tolerance_; }
  /// Paper mm to the nearest line; `most` where that is farther.
  double distance(Vec2 at, double most) const;

 private:
  using Segment = std::pair<Vec2, Vec2>;
  double tolerance_, side_;
  std::vector<Segment> segments_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

/// A path in pieces that lie on the lines and pieces that do not; each of them open, unless the
/// path is whole. Widths, model points and faces go with them.
struct PartedPath {
  std::vector<Path> on, off;
};

/// Parts a path; stretches of less than `least` mm are taken for what is beside them. Asks every
/// half tolerance. Cost: 0.2 us a question.
PartedPath parted(const Path& path, const LinesOnPaper& lines, double least);

}  // namespace burin
