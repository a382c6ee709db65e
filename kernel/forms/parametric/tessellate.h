#pragma once
// Triangles over untrimmed patches.

#include "weld.h"

namespace burin::detail {

/// Lines of the grid over a face: ascending parameters in u and in v, the domain's ends included.
struct FaceGrid {
  std::array<std::vector<double>, 2> lines;
};

/// How many grid lines a chart asks for: its second derivatives bound how far the triangles are
/// from S, the turning of its normal the angle between neighbours.
class GridPlan {
 public:
  explicit GridPlan(const Chart& chart);
  /// Lines for a largest distance in model mm from S, and kAlong times as much from the point of S
  /// at the same (u,v); `least` cells a direction.
  FaceGrid lines(double distance, std::array<int, 2> least) const;

 private:
  /// Second derivatives of the distance from the triangles: along u, along v and mixed.
  struct Bend {
    double u = 0, v = 0, mixed = 0;
  };
  /// Cells a unit of the parameter at each sample of a direction.
  std::vector<double> density(int direction, double distance) const;
  double largest_distance(const std::array<std::vector<double>, 2>& density) const;
  std::vector<double> places(int direction, const std::vector<double>& density, int cells) const;

  ParameterBox box_;
  int count_[2];
  std::vector<Bend> normal_, full_;  // a sample; sample (i, j) is i * count_[1] + j
  /// For each direction at its samples, the largest along the other one: the bend, and the angle
  /// that the normal turns through a unit of the parameter.
  std::vector<double> bend_[2], turn_[2];
  double length_[2] = {0, 0};  // model mm along the longest lines
};

/// A point of a triangle may lie this many times farther from the point of S at the same (u,v) than
/// from S: along the surface nothing is seen of it.
inline constexpr double kAlong = 2;

/// A vertex on a side of a face, in the side's own order.
struct SideNode {
  std::uint32_t vertex = 0;
  double side_t = 0, edge_t = 0;
};

/// Adds the triangles of one face: a grid inside, and strips between it and the nodes of the sides
/// (a single one where a side is a pole).
void add_face(ChartMesh& mesh, const PatchComplex& complex, std::int32_t face, const FaceGrid& grid,
              const std::array<std::vector<SideNode>, 4>& sides);

/// Triangles within `tolerance` model mm of S; states the largest distance that it measured from S
/// at the same (u,v). Both faces of an edge use its nodes. Normals are not filled.
ChartMesh tessellate(const PatchComplex& complex, double tolerance, const RunContext& context);

}  // namespace burin::detail
