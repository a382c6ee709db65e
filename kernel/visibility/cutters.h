#pragma once
/// The occluding segments of the picture in a uniform grid, and where they cut another segment.

#include "picture.h"
#include "segment_grid.h"

#include <vector>

namespace burin {

/// What a segment of a curve meets in the picture, in shares of the segment in space.
struct Crossings {
  std::vector<double> cuts;
  /// Stretches that lie exactly under a nearer occluding segment: a line behind a line.
  struct Stretch {
    double begin, end;
  };
  std::vector<Stretch> covered;
  /// Segments that were looked at since the beginning: what the search has cost.
  std::size_t tests = 0;
  void clear() {
    cuts.clear();
    covered.clear();
  }
};

/// Which occluding segments cut.
enum class CutRule {
  NearerOrAt,  ///< those before or at the depth of the segment where they cross it
  /// All; for curves that lie a chord error off the lines that bound them. A line that can be seen
  /// has nothing before it, so that it cuts nothing that it should not.
  AnyDepth
};

/// Segments that cut, found by a uniform grid over the paper. All tests are on closed segments
/// thickened by kReach, so that two chains that only share a point, or miss each other by rounding,
/// still count as meeting: a cut too many costs one more vote, a cut too few would let an answer
/// run past a T-junction.
class Cutters {
 public:
  /// Paper mm; above rounding on any sheet, far below anything visible.
  static constexpr double kReach = 1e-7;

  /// `same_depth`: model mm within which two depths count as one.
  Cutters(std::vector<PictureSegment> segments, double same_depth);

  /// Adds to `out` where the occluding segments cut `s`; unordered and possibly twice.
  void cross(const PictureSegment& s, CutRule rule, Crossings& out) const;
  std::size_t size() const { return segments_.size(); }
  /// From now on `cross` cuts every so many paper mm (and at the start of a segment) in place of
  /// where the segments are: where there are too many of them to be met one by one.
  void cut_evenly(double spacing) { even_ = spacing; }
  /// How many cuts lines of so many paper mm in all would get, were they and the segments strewn
  /// over the picture by chance. @cite Santalo1976
  double expected_cuts(double length) const;

 private:
  void cross_one(const PictureSegment& s, const PictureSegment& cutter, CutRule rule,
                 Crossings& out) const;
  void cross_parallel(const PictureSegment& s, const PictureSegment& cutter, CutRule rule,
                      Crossings& out) const;
  bool nearer_at(const PictureSegment& s, double space, const PictureSegment& cutter, double share,
                 double sign) const;

  std::vector<PictureSegment> segments_;
  double same_depth_;
  double even_ = 0;
  SegmentGrid grid_;
};

}  // namespace burin
