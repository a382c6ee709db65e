#pragma once
// Triangles over untrimmed patches.

#include "weld.h"

namespace burin::detail {

/// Lines of the grid over a face: ascending parameters in u and in v, the domain's ends included.
struct FaceGrid {
  std::vector<double> lines[2];
};

/// How many grid lines a chart asks for: its second derivatives bound how far the triangles are
/// from S at the same (u,v), the turning of its normal the angle between neighbours.
class GridPlan {
 public:
  explicit GridPlan(const Chart& chart);
  /// Lines for a largest distance in model mm; `least` cells a direction.
  FaceGrid lines(double distance, std::array<int, 2> least) const;

 private:
  std::vector<double> cumulative(int direction, double distance) const;

  ParameterBox box_;
  /// For each direction at even places: the largest second derivative, and the largest angle that
  /// the normal turns through, a unit of the parameter, along the other direction.
  std::vector<double> bend_[2], turn_[2];
  double length_[2] = {0, 0};  // model mm along the longest lines
};

/// A vertex on a side of a face, in the side's own order.
struct SideNode {
  std::uint32_t vertex = 0;
  double side_t = 0, edge_t = 0;
};

/// Adds the triangles of one face: a grid inside, and strips between it and the nodes of the sides
/// (a single one where a side is a pole).
void add_face(ChartMesh& mesh, const PatchComplex& complex, std::int32_t face, const FaceGrid& grid,
              const std::array<std::vector<SideNode>, 4>& sides);

/// Triangles whose points are within `tolerance` model mm of S at the same (u,v); states what it
/// measured. Both faces of an edge use its nodes. Normals are not filled.
ChartMesh tessellate(const PatchComplex& complex, double tolerance, const RunContext& context);

}  // namespace burin::detail
