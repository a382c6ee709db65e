#pragma once
// The strokes placed so far as samples in a grid on paper: who is near?

#include <burin/base/vec.h>

#include <cstdint>
#include <vector>

namespace burin::detail {

/// One place of one stroke on paper, and which visible sheet it lies on.
struct GridSample {
  Vec2 paper{0};
  Vec2 direction{0};  // unit, on paper; zero for a point that is no part of a line
  double pace = 0;    // paper mm to either side along the line that the sample stands for
  double depth = 0;   // model mm toward the viewer
  double slope = 0;   // model mm of depth a paper mm that the sheet may change by here
  std::int32_t part = -1;
  std::int32_t region = -1;
  std::int32_t stroke = -1;
  /// How much of its share of the ink the line still carries on its way into the light, in [0, 1].
  double weight = 1;
};

class SampleGrid {
 public:
  /// `cell`: edge of a cell in paper mm, about the largest distance that will be asked for.
  SampleGrid(Vec2 origin, Vec2 size, double cell);

  void insert(const GridSample& sample);

  /// How far the nearest sample of the same sheet is from `at`, measured across the sample's own
  /// direction; `radius` paper mm where there is none nearer. If both have directions, only samples
  /// count whose lines run about the same way.
  double nearest(const GridSample& at, double radius) const;

  /// The nearest distances on the left and on the right of `at` (looking along its direction), each
  /// `radius` where there is no neighbour, and the neighbours' weights; samples of its own stroke
  /// do not count.
  struct Sides {
    double left, right;
    double left_weight = 1, right_weight = 1;
  };
  Sides sides(const GridSample& at, double radius) const;

 private:
  template <class Visit>
  void visit(const GridSample& at, double radius, const Visit& f) const;

  Vec2 origin_;
  double cell_;
  std::int32_t nx_, ny_;
  std::vector<std::vector<GridSample>> cells_;
};

/// Whether two samples lie on one visible sheet: same part and smooth region, and no nearer or
/// farther than the slope of the surface explains.
bool same_sheet(const GridSample& a, const GridSample& b);

}  // namespace burin::detail
